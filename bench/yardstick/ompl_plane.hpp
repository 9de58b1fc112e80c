// OMPL's RRT* for a disc in the plane, on our check of straight lines.
#pragma once

#include <cstdint>

#include "waywright/planner/plane/plane_space.hpp"

namespace yardstick {

struct OmplPlaneRun {
  double length = 0.0;  ///< m; 0: nothing found
  std::uint64_t iterations = 0;
};

/// `samples` iterations, edges of at most `range` m, the radius of the proof of optimality, no goal bias.
OmplPlaneRun rrt_star(const waywright::PlaneSpace& space, waywright::Vec2 start, waywright::Vec2 goal, unsigned samples, double range, std::uint32_t seed);

}  // namespace yardstick
