// A plan that is being driven, when something has appeared that was not on its map.
#pragma once

#include <atomic>

#include "waywright/judge/plan.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/scenario/seen_obstacles.hpp"

namespace waywright {

/// The plan from where the vehicle is `t` seconds after the start of `old`, among what has been seen.
///
/// What stands still becomes part of the map; then, of these the first that serves:
/// (1) what is left of the old path is free of it: it is kept, curve for curve, and proven again.
/// (2) The old path is mended: left before what blocks it, by a way of the scenario's planner that joins it again behind; or the way to the goal is planned anew, from the first
///     place where the vehicle can stand (planners that can go on in motion do). Whichever is driven sooner.
/// (3) Neither: the status of the way planned anew, with how far the vehicle is from what blocks it and what it needs to stop.
/// What moves gets its place in the plan's times (timed_past_moving); where it stands in the way for good, the plan leads around it in the end.
///
/// The explanation says which, and why. An InputError: the mission is one that is not planned anew (in legs, with waypoints), the forks are in a shelf.
/// @pre `old` is solved and verified, 0 ≤ t < its end
Parsed<Plan> replan(const Plan& old, double t, const SeenObstacles& seen, const std::atomic<bool>* cancel = nullptr);

}  // namespace waywright
