// From a way over the lattice to one that is not bound to its cells and headings, and costs less.
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/planner/state_lattice/danger_cost.hpp"

namespace waywright {

struct Smoothed {
  std::vector<LatticeStretch> stretches;
  double cost = 0.0;             ///< as MotionCost has it, poses at most fine_step apart, with changes of direction
  std::int64_t evaluations = 0;  ///< of motions
};

/// m between poses whose cost is told.
inline constexpr double fine_step = 0.02;

/// What the stretches cost in all.
double cost_of(const std::vector<LatticeStretch>& stretches, MotionCost& cost);

/// First the least costly choice of places of the way (ends of its motions and between) that are joined by three clothoids each, or left as they are;
/// then each place is moved, turned and bent as long as that saves cost. Every motion is free, within the limits and goes on in curvature; start and goal stay.
/// Never dearer than what went in.
Smoothed smoothed(const std::vector<LatticeStretch>& way, MotionCost& cost, const BendLimits& limits, Budget& budget);

}  // namespace waywright
