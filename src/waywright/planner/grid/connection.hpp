// From true poses to the cells of a grid and back: short drives and turns, each tested against the exact outlines.
#pragma once

#include <vector>

#include "waywright/planner/grid/grid_frame.hpp"
#include "waywright/planner/grid/heading_search.hpp"
#include "waywright/planner/grid/motion_check.hpp"

namespace waywright {

/// What a way is made of before it becomes pieces of a path.
struct Action {
  enum class Kind { turn, drive } kind = Kind::drive;
  double angle = 0.0;  ///< rad, of a turn
  Vec2 to{};           ///< of a drive
  int direction = 1;   ///< of a drive
};

/// Of a disc, which may turn anywhere.
struct DiscConnection {
  Cell cell{};
  double cost = 0.0;  ///< m, the length as zones weigh it; 0: the pose is the cell's middle
};
/// The middles around a place that it can be driven from, or to, on a straight line: the cell that it is the middle of alone, or those of the four around it;
/// where none of them can be, of the sixteen or the thirty-six around. `is_start`: from the place; else to it.
std::vector<DiscConnection> disc_connections(const Problem& problem, const GridFrame& frame, Vec2 at, bool is_start, MotionCheck& test);

/// Of a footprint with a shape: to a state of a HeadingSpace, with what is done on the way, in the order of driving.
struct HeadingConnection {
  HeadingState state{};
  double cost = 0.0;  ///< m
  std::vector<Action> actions;
};
/// From a pose turn, drive to a middle around it, and turn to one of the two headings next to the way there. Where that cannot be, first straight on or back along
/// the pose's heading, as little as serves. `is_start`: from the pose; else into it, the same driven the other way.
std::vector<HeadingConnection> heading_connections(const Problem& problem, const HeadingSpace& space, const Pose& pose, bool is_start, MotionCheck& test);

}  // namespace waywright
