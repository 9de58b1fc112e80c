#include <fmt/format.h>

#include <algorithm>

#include "waywright/core/random.hpp"
#include "waywright/scenario/problem.hpp"
#include "waywright/study/generate.hpp"

namespace waywright {
namespace {

constexpr int most_tries = 200;

bool chance(Random& random, double p) { return random.uniform() < p; }

Vehicle random_vehicle(Random& random) {
  Vehicle v;
  const double stretch = random.uniform(0.85, 1.15);
  v.name = "generated forklift";
  v.footprint.polygon = rectangle({-2.30 * stretch, -0.45}, {0.40 * stretch, 0.45});
  v.drive = Tricycle{1.90 * stretch, 1.05, 0.8, SteeredAxle::rear};
  v.limits.speed = 1.2;
  v.limits.reverse_speed = 1.0;
  v.limits.lateral_acceleration = 0.5;
  v.limits.curvature = random.uniform(0.6, 0.9);
  if (chance(random, 0.5)) v.limits.curvature_rate = random.uniform(0.8, 2.0);
  return v;
}

/// In the shelf's frame: back wall behind the shelf, opening towards +x.
Ring random_area(Random& random, double shelf_depth, double shelf_width) {
  const double depth = random.uniform(9.0, 16.0);
  const double width = random.uniform(10.0, 18.0);
  const double back = -(shelf_depth + random.uniform(0.05, 0.5));
  const double kind = random.uniform();
  const double half = 0.5 * shelf_width + 0.3;
  const double right = kind < 0.4   ? -0.5 * width
                       : kind < 0.6 ? -(width - half)
                       : kind < 0.8 ? -half
                                    : -random.uniform(half, width - half);
  const double front = back + depth;
  const double left = right + width;
  Ring area = rectangle({back, right}, {front, left});
  if (chance(random, 0.3)) {
    // The far left or far right corner is missing: cut off at an angle, or notched.
    const double a = random.uniform(1.0, 0.3 * depth);
    const double b = random.uniform(1.0, 0.3 * width);
    const bool notch = chance(random, 0.5);
    Ring cut{{back, right}, {front, right}, {front, left - b}};
    if (notch) cut.push_back({front - a, left - b});
    cut.push_back({front - a, left});
    cut.push_back({back, left});
    if (chance(random, 0.5)) {  // mirrored about the station's axis
      for (Vec2& p : cut) p.y = left + right - p.y;
      std::reverse(cut.begin(), cut.end());
    }
    area = cut;
  }
  return area;
}

bool clear_of(const Ring& ring, const Footprint& footprint, const Pose& pose, double margin) {
  World world{Map{}};
  world.add_obstacle(ring, "candidate");
  world.build();
  return world.is_free(footprint, pose, margin);
}

}  // namespace

Parsed<Scenario> generate_station(std::uint64_t seed, const StationOptions& options) {
  Random random = Random::stream(seed, 0);
  for (int attempt = 0; attempt < most_tries; ++attempt) {
    Scenario s;
    s.name = fmt::format("station {}", seed);
    s.seed = 1;
    s.vehicle = random_vehicle(random);
    Station station;
    Shelf& shelf = station.shelf;
    shelf.depth = random.uniform(1.0, 1.4);
    shelf.width = random.uniform(2.2, 3.2);
    s.clearance = random.uniform(0.02, 0.10);
    if (chance(random, 0.3)) s.pose_error = {random.uniform(0.0, 0.02), random.uniform(0.0, 0.02), random.uniform(0.0, 0.005)};
    shelf.gap = s.clearance + random.uniform(0.06, 0.12);
    const Ring area = random_area(random, shelf.depth, shelf.width);
    const Box box = bounding_box(area);

    // Everything up to here is in the shelf's frame (origin in the middle of the face).
    const Frame world{make_pose({random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0)}, random.uniform(-pi, pi))};
    shelf.center = world.to_world(Vec2{-0.5 * shelf.depth, 0.0});
    shelf.heading = world.heading();
    const double along = box.high.x - 0.5 - s.vehicle.footprint.front();
    const double x = random.uniform(std::min(along, std::max(4.0, 0.5 * box.high.x)), along);
    const double y = std::clamp(random.uniform(-2.0, 2.0), box.low.y + 1.2, box.high.y - 1.2);
    s.start = world.to_world(make_pose({x, y}, random.uniform(-0.3, 0.3)));
    station.area = transformed(area, world);

    const Pose dock = shelf.docked(s.vehicle.footprint.front());
    const auto keeps_clear = [&](const Ring& ring) {
      return clear_of(ring, s.vehicle.footprint, s.start, s.clearance + 0.15) && clear_of(ring, s.vehicle.footprint, dock, s.clearance + 0.15);
    };
    const int boxes = options.boxes.value_or(static_cast<int>(random.integer(0, 12)));
    for (int i = 0; i < boxes; ++i) {
      for (int t = 0; t < 20; ++t) {
        const Vec2 size{random.uniform(0.3, 1.5), random.uniform(0.3, 1.5)};
        const Vec2 at{random.uniform(box.low.x, box.high.x), random.uniform(box.low.y, box.high.y)};
        const Ring ring = transformed(rectangle(-0.5 * size, 0.5 * size), Frame{world.to_world(make_pose(at, random.uniform(-pi, pi)))});
        if (!keeps_clear(ring)) continue;
        s.map.obstacles.push_back(ring);
        break;
      }
    }
    for (auto clusters = random.integer(0, 3); clusters > 0; --clusters) {
      const Vec2 at{random.uniform(box.low.x, box.high.x), random.uniform(box.low.y, box.high.y)};
      const Frame line{world.to_world(make_pose(at, random.uniform(-pi, pi)))};
      const auto count = random.integer(10, 50);
      for (std::int64_t i = 0; i < count; ++i) {
        const Vec2 p = line.to_world(Vec2{0.04 * static_cast<double>(i), random.uniform(-0.01, 0.01)});
        const Vec2 speck{0.001, 0.001};
        if (keeps_clear(rectangle(p - speck, p + speck))) s.map.points.push_back(p);
      }
    }
    s.mission = station;
    auto problem = Problem::prepare(s);
    if (problem && !problem->check_ends()) return s;
  }
  return tl::unexpected{InputError{"", "generate station", fmt::format("seed {} gave no usable station in {} tries", seed, most_tries), "another seed"}};
}

}  // namespace waywright
