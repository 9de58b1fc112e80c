// A* over the states of a lattice, where what a motion really costs is only asked when the search comes to it.
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/planner/state_lattice/lattice_rest.hpp"

namespace waywright {

struct LatticeAnswer {
  enum class End { found, exhausted, out_of_budget, canceled, timed_out, too_many };
  End ended = End::exhausted;
  double cost = 0.0;         ///< of the way found
  double lower_bound = 0.0;  ///< no way over the lattice costs less
  std::vector<LatticeStretch> stretches;  ///< of the way found, in the world
  std::int64_t expansions = 0;     ///< states
  std::int64_t motions = 0;        ///< that were evaluated
};

/// `gap`: the way found may cost up to this share more than the best one; 0: it is the best.
LatticeAnswer search_lattice(const LatticeGraph& graph, const LatticeRest& rest, MotionCost& cost, double gap, Budget& budget);

}  // namespace waywright
