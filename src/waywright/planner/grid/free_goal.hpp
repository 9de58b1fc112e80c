// Goals that leave the heading free, for planners over cells: where ways to them may end.
#pragma once

#include <vector>

#include "waywright/path/path.hpp"
#include "waywright/planner/grid/connection.hpp"
#include "waywright/planner/grid/grid_search.hpp"

namespace waywright {

/// Cells whose middles lie in the goal's region and beside one that does not, and the one nearest to the middle of its box first: whoever comes from outside by moves
/// between cells comes through one of them, so the least costly way to any of the region's cells ends in one. Also all of the cells around `start` that
/// lie in it. @pre the goal is a region
std::vector<Cell> region_cells(const Problem& problem, const GridFrame& frame);

/// Where ways of a disc may end: of a region region_cells, of a point the cells that it can be driven to from, as disc_connections has it.
std::vector<GridEnd> free_ends(const Problem& problem, const GridFrame& frame, MotionCheck& test);

/// The same of a footprint with a shape, with any heading: at a point that of the last drive.
std::vector<HeadingConnection> free_connections(const Problem& problem, const HeadingSpace& space, MotionCheck& test);

/// As path_of, without a goal to drive to and to face at the end.
Path path_along(const Pose& start, const std::vector<Action>& actions);

/// No way from the start to the goal can be shorter. m
double least_way(const Problem& problem);
/// The goal in words: "(1.000, 2.000)", "the region".
std::string goal_words(const Problem& problem);

}  // namespace waywright
