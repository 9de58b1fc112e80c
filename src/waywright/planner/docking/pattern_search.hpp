// The search for the best docking pattern on both sides of the shelf.
#pragma once

#include <vector>

#include "waywright/planner/docking/pattern_docking.hpp"
#include "waywright/planner/docking/prepared.hpp"

namespace waywright {

/// What came of each side, in the order of the task's zones. Both sides get a first share of the work; then a side that is worse by far than
/// the other one is given up. `second_choice`: a part of the scenario's budget is kept for one.
std::vector<SideOutcome> search_sides(const PreparedDocking& prepared, const PatternDockingOptions& options, const Optimizer& optimizer,
                                      std::uint64_t seed, bool second_choice, Budget& budget);

/// What costs are relative to. One reference for both sides, so that their costs can be compared: the shorter of the two reference paths, its
/// change of curvature no more than three bends at the curvature limit.
PathMeasures reference_measures(const PreparedDocking& prepared, const PatternLeads& leads);

/// Less is better; grows with length and with change of curvature.
double objective_value(const PatternDockingOptions& options, const PathMeasures& path, const PathMeasures& reference);

}  // namespace waywright
