// Where a search among states begins and ends, and where in the plane it looks.
#pragma once

#include <optional>

#include "waywright/planner/steering/steering.hpp"

namespace waywright {

/// An end of the task that just keeps its clearance, as a docked pose may, and the straight run between it
/// and `pose`: on a line the clearance there is the same as at the end itself, on an arc it could be shown
/// only up to the proof's tolerance.
struct StateEnd {
  Pose pose;
  std::optional<Piece> run{};
};

StateEnd end_of_search(MotionTest& test, const Pose& pose, bool is_start, bool backwards_too);

/// The goal with a straight run forwards into it, of `run` metres; without a run where that one is not free.
StateEnd goal_with_run(MotionTest& test, const Pose& goal, double run);

/// A way between the ends' poses with their runs.
Path with_runs(const Steering& steering, const StateEnd& start, const Path& middle, const StateEnd& goal);

/// Where positions are drawn. Of curves (`radius`: their least one, m): about start and goal, wide enough for detours of some turning circles. Inside of what bounds the
/// world, around everything that is known, and with both ends in it.
Box search_region(const Problem& problem, double radius, bool is_curve = true);

}  // namespace waywright
