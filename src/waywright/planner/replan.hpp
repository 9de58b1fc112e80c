// A plan that is being driven, made anew when start or goal turn out to be a little elsewhere.
#pragma once

#include <atomic>

#include "waywright/judge/plan.hpp"
#include "waywright/planner/docking/continuation.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {

/// What is left of `old` after `driven` metres, carried along to the problem's start and goal where that is proven; else planned anew by the
/// scenario's planner from the vehicle's motion. The explanation says which, and why. Errors as of solve().
/// @pre the problem's start is where the vehicle is, its motion the scenario's start_motion
Parsed<Plan> replan(const Problem& problem, const Path& old, double driven, const std::atomic<bool>* cancel = nullptr);

}  // namespace waywright
