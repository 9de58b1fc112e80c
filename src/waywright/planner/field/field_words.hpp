// What planners that go down a field say where they do not come to the goal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/planner/field/descent.hpp"
#include "waywright/planner/planner.hpp"
#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

/// "it stalls at (6.304, 6.998), 5.874 m from the goal: …", without a full stop; of a descent that did not come to the goal.
std::string end_of_descent(const Descent& descent, Vec2 goal, const PlaneSpace& space, const Budget& budget, std::string_view who = "it");

/// Canceled, or out of time.
PlanningFailure stopped(const Budget& budget, std::int64_t steps);

/// The failure of a descent that did not come to the goal, with what was driven as an alternative.
PlanningFailure not_at_goal(const Descent& descent, Vec2 goal, const PlaneSpace& space, std::vector<std::string> text, std::string_view name, const Budget& budget);

}  // namespace waywright
