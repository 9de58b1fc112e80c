// From drives and turns to the pieces of a path.
#pragma once

#include <vector>

#include "waywright/path/path.hpp"
#include "waywright/planner/grid/connection.hpp"

namespace waywright {

/// Lines with turns on the spot before each where the course changes, and a last one into the goal's heading. Turns that are told are kept, also where
/// the other way round would be shorter; where none is told the shorter way is taken.
Path path_of(const Pose& start, const std::vector<Action>& actions, const Pose& goal);

/// Drives along the cells of a way, straight runs as one.
std::vector<Action> drives_along(const GridFrame& frame, const std::vector<Cell>& cells);

/// Drives and turns of a way through headings, straight runs as one.
std::vector<Action> actions_along(const HeadingSpace& space, const HeadingAnswer& answer);

/// Radians of turning on the spot, and how many turns.
struct Turning {
  double angle = 0.0;
  int turns = 0;
};
Turning turning_of(const Path& path);

}  // namespace waywright
