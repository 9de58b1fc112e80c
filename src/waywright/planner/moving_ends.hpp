// Moving obstacles that are where a plan begins, or stay where it ends.
#pragma once

#include <optional>
#include <string>

#include "waywright/core/result.hpp"
#include "waywright/judge/plan.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// "cart (moving obstacle 2)", "moving obstacle 2 of the scenario's list"; numbers count from 1.
std::string who_moves(const MovingObstacle& obstacle, std::size_t index);

/// Known before anything is planned: what is too near to the start when the plan begins, and what is at the goal from then on and never leaves. Goals with a free heading are not
/// looked at.
std::optional<Failure> moving_at_ends(const Problem& problem);

/// Of a plan that is hindered by what stands in its way for good: does that stand at the goal?
std::optional<Failure> moving_at_goal(const Problem& problem, const Plan& plan);

}  // namespace waywright
