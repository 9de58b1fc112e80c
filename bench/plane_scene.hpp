// Where planners in the plane are measured: among octagons, and on the maps of the RRT*-WOA publication.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "waywright/core/random.hpp"
#include "waywright/map/whale_maps.hpp"
#include "waywright/planner/plane/plane_space.hpp"

namespace waywright::bench {

inline constexpr Vec2 start{1.0, 1.0}, goal{19.0, 19.0};  // among the octagons

/// 50 octagons in 20 × 20 m, 400 sides; a disc of 0.2 m from corner to corner.
inline Scenario octagons() {
  Scenario s;
  Random random{7};
  s.map.boundaries = {rectangle({0, 0}, {20, 20})};
  while (s.map.obstacles.size() < 50) {
    const Vec2 at{random.uniform(0.5, 19.5), random.uniform(0.5, 19.5)};
    const double radius = random.uniform(0.3, 0.8);
    if (distance(at, start) < radius + 0.5 || distance(at, goal) < radius + 0.5) continue;
    Ring ring;
    for (int i = 0; i < 8; ++i) ring.push_back(at + radius * unit(wrap(two_pi * i / 8.0)));
    s.map.obstacles.push_back(ring);
  }
  s.vehicle.footprint = {{}, 0.2};
  s.vehicle.drive = Differential{0.4};
  s.start = make_pose(start, 0.0);
  s.mission = make_pose(goal, 0.0);
  return s;
}

/// A point on one of the publication's maps.
inline Scenario of_a_point(const WhaleMap& map) {
  Scenario s;
  s.map = map.map;
  s.vehicle.footprint = {{}, 0.0};
  s.vehicle.drive = Differential{0.5};
  s.start = make_pose(map.task.start, 0.0);
  s.mission = make_pose(map.task.goal, 0.0);
  return s;
}

struct PlaneScene {
  explicit PlaneScene(std::string called, Scenario scenario) : name{std::move(called)}, problem{Problem::prepare(std::move(scenario)).value()}, space{problem} {}
  std::string name;
  Problem problem;
  PlaneSpace space;
  Vec2 from() const { return problem.start().position(); }
  Vec2 to() const { return problem.goal().position(); }
};

/// The octagons, then the five maps.
inline const std::vector<std::unique_ptr<PlaneScene>>& plane_scenes() {
  static const auto scenes = [] {
    std::vector<std::unique_ptr<PlaneScene>> all;
    all.push_back(std::make_unique<PlaneScene>("50 octagons", octagons()));
    for (const std::string& name : whale_map_names()) all.push_back(std::make_unique<PlaneScene>(name, of_a_point(*whale_map(name))));
    return all;
  }();
  return scenes;
}
inline const PlaneScene& scene() { return *plane_scenes().front(); }

}  // namespace waywright::bench
