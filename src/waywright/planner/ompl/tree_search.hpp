// RRTConnect by OMPL between two poses of the Reeds–Shepp space.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "waywright/path/path.hpp"
#include "waywright/planner/steering/arc_motion.hpp"
#include "waywright/planner/steering/reeds_shepp.hpp"

namespace waywright {

struct TreeSearchResult {
  std::optional<Path> path;  ///< exact; absent where the trees did not meet
  Path nearest;              ///< else: to the state of the start's tree nearest to the goal; may be empty
  double missing = 0.0;      ///< m of Reeds–Shepp curve from there to the goal
  std::int64_t start_states = 0;  ///< in the tree that grew from the start
  std::int64_t goal_states = 0;   ///< in the tree that grew from the goal
  std::string error;              ///< what the library refused; empty in a healthy run
};

/// Where positions are drawn: about start and goal, wide enough for detours of some turning circles, inside
/// of what bounds the world, and with both poses in it.
Box search_region(const Problem& problem, double radius);

struct PosePair {
  Pose start, goal;
};

/// The way between two poses, which may stand in for the problem's own. Ends where the trees meet or the
/// test's limits are spent. `range` as in RrtConnectOptions. Every motion of the path has been called free by
/// `test`. Same arguments, same bits.
TreeSearchResult tree_search(const Problem& problem, const PosePair& ends, const ReedsShepp& curves,
                             MotionTest& test, double range, std::uint64_t seed);

}  // namespace waywright
