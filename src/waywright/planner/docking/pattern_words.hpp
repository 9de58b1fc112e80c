// What a docking search came to, in sentences and pictures.
#pragma once

#include <string>
#include <vector>

#include "waywright/planner/docking/pattern_solver.hpp"
#include "waywright/planner/docking/side_search.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright {

/// What the pattern is called: a docking pattern only where something is docked at.
const char* pattern_name(const Problem& problem);

/// Every side's story.
std::vector<SideOutcome> outcomes_of(const PreparedDocking& prepared, const PatternSolver& solver, const Budget& budget);

/// Why this side, where the vehicle drives, what it costs; then every side's story.
std::vector<std::string> explain(const Problem& problem, const PatternDockingOptions& options, const PatternSolver& solver, const SideOutcome& best,
                                 const std::vector<SideOutcome>& outcomes, const char* of);

/// The reason says what is in the way of each side, the explanation more of it.
PlanningFailure failure_of(const Problem& problem, const DockingTask& task, const PatternSolver& solver, const std::vector<SideOutcome>& outcomes,
                           const Budget& budget);

std::string optimality_sentence(const Optimality& optimality);

}  // namespace waywright
