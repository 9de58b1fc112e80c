// OMPL's RRT* for a disc in the plane, on our check of straight lines.
#pragma once

#include <cstdint>

#include "waywright/planner/plane/plane_space.hpp"

namespace yardstick {

struct OmplPlaneRun {
  double length = 0.0;  ///< m; 0: nothing found
  std::uint64_t iterations = 0;
  std::size_t nodes = 0;  ///< where they are counted, which takes time
};

/// `samples` iterations, edges of at most `range` m, nothing informed or pruned; one in a hundred samples is the goal, without which it finds nothing. `is_same`: it is given
/// the places that our tree draws with that seed, in their order (it draws places in obstacles, too, and wastes them), and our constant of the radius (its own is smaller:
/// (2 (1 + 1/d))^{1/d} where ours is 2 (1 + 1/d)^{1/d}, of the whole region).
OmplPlaneRun rrt_star(const waywright::PlaneSpace& space, waywright::Vec2 start, waywright::Vec2 goal, unsigned samples, double range, std::uint32_t seed, bool is_same,
                      bool counts_nodes = false);

}  // namespace yardstick
