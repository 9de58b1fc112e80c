// The first and last stretch of a way over cells: straight from the true pose, without a stub to the middle of its cell.
#pragma once

#include <vector>

#include "waywright/planner/grid/connection.hpp"

namespace waywright {

struct EndsToJoin {
  bool start = true, goal = true;  ///< which of the two
  int most_corners = 1;            ///< left out at each end; a stub has one
  double turn_cost = 0.0;          ///< m that a radian of turning counts as, ≥ 0
  double reverse_cost = 1.0;       ///< m that a metre backwards counts as
};

/// A way in drives and turns, from the start's pose into the goal's position. Where an end is off the middles of the cells, it is joined by one straight drive to the
/// farthest corner of the way to which each one before was joined, too: drives in one direction alone, each new drive and turn tested against the exact outlines as
/// connections are, against no zone's direction. The way becomes neither longer, nor turns it more, nor costs it more. Poses on the middles of cells stay as they are,
/// and so do ends that are driven straight on, without a turn.
std::vector<Action> with_joined_ends(const Problem& problem, const GridFrame& frame, const std::vector<Action>& actions, const EndsToJoin& ends, MotionCheck& test);

}  // namespace waywright
