// When the vehicle and what moves come nearest to each other.
#pragma once

#include <vector>

#include "waywright/path/path.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

struct ClosestApproach {
  std::size_t obstacle = 0;  ///< index among the scenario's moving ones
  double t = 0.0;            ///< s after the plan's start; the first such time
  double distance = 0.0;     ///< m between the footprint and the obstacle as predicted for that time, ≥ 0, at most closest_cap
  Pose vehicle{}, other{};   ///< both then
  Vec2 on_vehicle{}, on_other{};  ///< their nearest points, of discs as polygons
};

inline constexpr double closest_cap = 100.0;  ///< m

/// One of each moving obstacle, nearest first. Times are looked at a hundredth of a second apart (more, where 100 000 for all obstacles would not do), fewer where none can be nearer:
/// distances are least but for what both move in that.
std::vector<ClosestApproach> closest_approaches(const Problem& problem, const std::vector<Sample>& samples);

/// The pose at a time, straight between samples. @pre samples not empty, t never decreasing
Pose pose_at(const std::vector<Sample>& samples, double t);

}  // namespace waywright
