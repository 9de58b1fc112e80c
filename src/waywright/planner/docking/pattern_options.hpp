// What a docking search can be told.
#pragma once

#include <cstdint>

#include "waywright/objective/docking_cost.hpp"
#include "waywright/planner/docking/pattern.hpp"

namespace waywright {

enum class SideChoice { both, left, right };
enum class DockingObjective { normalised, exponential };

/// Where no candidate of a search serves it goes on, by as many each time, until it has looked at so many times as many.
inline constexpr int harder_times = 4;

struct PatternDockingOptions {
  /// Candidates per side, ≥ 1; where none of them serves, up to harder_times as many are tried before the second choice is asked. A scenario's
  /// budget.evaluations takes its place, for all sides together.
  std::int64_t evaluations = 600;
  int population = 20;              ///< of optimisers that have one
  double heading_range = 1.0;       ///< rad, the transition heading may leave the perpendicular by this; 0: two variables
  PatternLeads leads;
  DockingWeights weights;
  DockingObjective objective = DockingObjective::normalised;
  SideChoice sides = SideChoice::both;
  double gap = 0.0;                 ///< > 0: branch and bound until the answer is shown to cost at most this share more than the optimum
};

}  // namespace waywright
