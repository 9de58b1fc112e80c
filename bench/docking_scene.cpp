#include "bench/docking_scene.hpp"

#include "waywright/planner/docking/side_search.hpp"

namespace waywright::bench {
namespace {

constexpr double kept_free = 0.5;  // m around start and dock

yardstick::Point point(Vec2 p) { return {p.x, p.y}; }

yardstick::Polygon polygon(const Ring& ring) {
  yardstick::Polygon out;
  for (const Vec2 p : ring) out.push_back(point(p));
  return out;
}

/// Far enough from where every path begins and ends.
bool may_stand(const Scenario& scenario, const Ring& ring) {
  World world;
  world.add_obstacle(ring, "box");
  world.build();
  const Station& station = std::get<Station>(scenario.mission);
  const Pose dock = station.shelf.docked(scenario.vehicle.footprint.front());
  const Pose before{dock.x - 1.0 * unit(dock.heading).x, dock.y - 1.0 * unit(dock.heading).y, dock.heading};
  for (const Pose& pose : {scenario.start, dock, before}) {
    if (!world.is_free(scenario.vehicle.footprint, pose, kept_free)) return false;
  }
  return true;
}

}  // namespace

Scenario docking_scenario(Clutter clutter, std::uint64_t seed, std::size_t boxes) {
  Scenario s;
  s.name = "bench";
  s.clearance = 0.05;
  s.vehicle.name = "forklift";
  s.vehicle.footprint.polygon = rectangle({-2.30, -0.45}, {0.40, 0.45});
  s.vehicle.drive = Tricycle{1.90, 60.0 * pi / 180.0, std::nullopt, SteeredAxle::rear};
  s.vehicle.limits.curvature = 0.8;
  s.start = Pose{8.0, 0.0, 0.0};
  Station station;
  station.area = rectangle({-1.5, -7.0}, {10.5, 7.0});
  station.shelf.center = Vec2{-0.6, 0.0};
  station.shelf.depth = 1.2;
  station.shelf.width = 2.7;
  s.mission = station;
  Random random{seed};
  const auto anywhere = [&] { return Vec2{random.uniform(-1.0, 10.0), random.uniform(-6.5, 6.5)}; };
  while (clutter == Clutter::boxes && s.map.obstacles.size() < boxes) {
    const Vec2 half{0.5 * random.uniform(0.3, 1.0), 0.5 * random.uniform(0.3, 1.0)};
    const Ring box = transformed(rectangle(-half, half), Frame{make_pose(anywhere(), random.uniform(0.0, pi))});
    if (may_stand(s, box)) s.map.obstacles.push_back(box);
  }
  while (clutter == Clutter::points && s.map.points.size() < 500) {
    const Vec2 middle = anywhere();
    const Vec2 half{0.3, 0.3};
    if (!may_stand(s, rectangle(middle - half, middle + half))) continue;
    for (int i = 0; i < 50; ++i) s.map.points.push_back(middle + Vec2{random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)});
  }
  return s;
}

yardstick::Scene scene_of(const Problem& problem, double clearance) {
  yardstick::Scene scene;
  scene.clearance = clearance;
  scene.footprint = polygon(problem.vehicle().footprint.polygon);
  for (const Ring& ring : problem.scenario().map.obstacles) scene.obstacles.push_back(polygon(ring));
  const Station& station = std::get<Station>(problem.scenario().mission);
  scene.obstacles.push_back(polygon(station.shelf.outline()));
  for (std::size_t i = 0; i < station.area.size(); ++i) {
    scene.walls.push_back({point(station.area[i]), point(station.area[(i + 1) % station.area.size()])});
  }
  for (const Vec2 p : problem.scenario().map.points) scene.points.push_back(point(p));
  return scene;
}

yardstick::Candidate candidate_of(const DockingPattern& pattern) {
  yardstick::Candidate candidate;
  for (std::size_t i = 0; i < 6; ++i) {
    candidate.back[i] = point(pattern.back.control[i]);
    candidate.forth[i] = point(pattern.forth.control[i]);
  }
  return candidate;
}

DockingPattern random_pattern(const Problem& problem, const DockingTask& task, Random& random) {
  const TransitionZone& zone = task.zones[random.uniform() < 0.5 ? 0 : 1];
  const SearchSpace space = search_space(zone, 1.0);
  std::array<double, 3> x{};
  for (std::size_t i = 0; i < 3; ++i) x[i] = random.uniform(space.low[i], space.high[i]);
  return docking_pattern(problem.start(), problem.goal(), transition_pose(task, zone, x), {});
}

}  // namespace waywright::bench
