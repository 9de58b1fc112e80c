// What the planners over cells have in common once the cells are found: the way into the goal, and what is said of it.
#pragma once

#include <string>
#include <vector>

#include "waywright/planner/grid/grid_frame.hpp"
#include "waywright/planner/grid/grid_path.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright::grid {

/// Into the goal's pose, or where its heading is free, to it.
Path way_to_goal(const Problem& problem, std::vector<Action> actions);

/// How long it is, against the straight line, and how much it turns.
std::string length_sentence(const Problem& problem, const Path& path);
/// That the disc around a footprint with a shape was searched for.
std::string disc_sentence(double radius);

/// No cell can be driven to from the start, or none leads into the goal; `of_what` follows the cells in the sentence.
PlanningFailure not_connected(const Problem& problem, const GridFrame& frame, bool is_start, const std::string& of_what = {});

}  // namespace waywright::grid
