// The publication's reconstructed vehicle FT1 and stations D0 to D4, for tests.
#pragma once

#include <vector>

#include "waywright/scenario/problem.hpp"

namespace waywright::fixture {

inline Vehicle ft1() {
  Vehicle v;
  v.name = "FT1";
  v.footprint.polygon = rectangle({-2.30, -0.45}, {0.40, 0.45});
  v.drive = Tricycle{1.90, 60.0 * pi / 180.0, std::nullopt, SteeredAxle::rear};
  v.limits.curvature = 0.8;
  return v;
}

/// Points every 0.05 m along a rectangle's edges.
inline void scan(Map& map, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i];
    const Vec2 b = ring[(i + 1) % ring.size()];
    const auto steps = static_cast<int>(std::ceil(distance(a, b) / 0.05 - 1e-9));
    for (int k = 0; k < steps; ++k) map.points.push_back(a + (static_cast<double>(k) / steps) * (b - a));
  }
}

enum class Id { d0, d1, d2, d3 };

/// In the shelf's frame, placed in the world by `place`. Obstacles as scan points, as the publication has them.
inline Scenario station(Id id, const Pose& place = {}) {
  std::vector<Ring> boxes;
  const auto box = [&](double x0, double y0, double x1, double y1) { boxes.push_back(rectangle({x0, y0}, {x1, y1})); };
  if (id == Id::d1 || id == Id::d2) {
    box(5.2, 2.6, 6.4, 3.4);
    box(0.4, -4.2, 1.6, -3.4);
  }
  if (id == Id::d2) {
    box(3.6, -2.6, 4.4, -1.4);
    box(2.6, 5.6, 3.8, 6.4);
    box(-0.8, 2.4, 0.4, 3.2);
    box(7.2, -3.4, 8.4, -2.6);
  }
  const Frame world{place};
  Scenario s;
  s.name = "fixture";
  s.vehicle = ft1();
  for (const Ring& b : boxes) scan(s.map, transformed(b, world));
  s.start = world.to_world(Pose{8.0, 0.0, 0.0});
  Station station;
  station.area = transformed(rectangle({-1.5, -7.0}, {10.5, id == Id::d3 ? 2.2 : 7.0}), world);
  station.shelf.center = world.to_world(Vec2{-0.6, 0.0});
  station.shelf.heading = world.heading();
  station.shelf.depth = 1.2;
  station.shelf.width = 2.7;
  station.shelf.gap = 0.1;
  s.mission = station;
  return s;
}

/// The forks in and the load out: tines of 0.21 m, pockets 4 cm wider on each side.
inline Scenario with_pockets(Manoeuvre manoeuvre) {
  Scenario s = station(Id::d1, {3.0, -2.0, 0.4});
  s.vehicle.footprint.polygon = {{-2.30, -0.45}, {-0.75, -0.45}, {-0.75, -0.33}, {0.40, -0.33}, {0.40, -0.12}, {-0.75, -0.12},
                                 {-0.75, 0.12},  {0.40, 0.12},   {0.40, 0.33},   {-0.75, 0.33}, {-0.75, 0.45}, {-2.30, 0.45}};
  s.vehicle.forks = {rectangle({-0.75, -0.33}, {0.40, -0.12}), rectangle({-0.75, 0.12}, {0.40, 0.33})};
  s.vehicle.loads["pallet"] = {{rectangle({-0.75, -0.40}, {0.45, 0.40}), 0.0}, 800.0};
  auto& station = std::get<Station>(s.mission);
  station.manoeuvre = manoeuvre;
  station.insertion = Insertion{1.0, {{-0.37, -0.08}, {0.08, 0.37}}};
  if (manoeuvre == Manoeuvre::undock) s.carried_load = "pallet";
  s.pose_error = {0.01, 0.01, 0.004};
  return s;
}

inline Problem problem(Id id, const Pose& place = {}) { return Problem::prepare(station(id, place)).value(); }

}  // namespace waywright::fixture
