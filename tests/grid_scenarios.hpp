// What the tests of grid planners have in common.
#pragma once

#include "waywright/core/random.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright::test {

inline Plan planned(Scenario scenario, const std::string& planner, Parameters parameters = {}) {
  scenario.planner = {planner, std::move(parameters)};
  return *solve(Problem::prepare(std::move(scenario)).value());
}

/// Boxes in a hall of 12 × 9 m; start and goal at random poses that are free.
inline Scenario hall(Random& random, const Footprint& footprint, double clearance, int boxes) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {12, 9})};
  for (int i = 0; i < boxes; ++i) {
    const Vec2 at{random.uniform(0, 11), random.uniform(0, 8)};
    const Ring box = rectangle({0, 0}, {random.uniform(0.2, 1.2), random.uniform(0.2, 1.2)});
    s.map.obstacles.push_back(transformed(box, Frame{make_pose(at, random.uniform(-1, 1))}));
  }
  s.vehicle.footprint = footprint;
  s.vehicle.drive = Differential{0.5};
  s.vehicle.limits.angular_speed = 1.0;
  s.clearance = clearance;
  World world{s.map};
  world.build();
  const auto pose = [&] {
    for (int tries = 0; tries < 10'000; ++tries) {
      const Pose p{random.uniform(0.3, 11.7), random.uniform(0.3, 8.7), random.uniform(-3, 3)};
      if (world.clearance(footprint, p, 1.0).clearance > clearance + 1e-4) return p;
    }
    return Pose{};
  };
  s.start = pose();
  s.mission = pose();
  return s;
}

inline const Footprint disc{{}, 0.3};

}  // namespace waywright::test
