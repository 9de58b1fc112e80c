// The waypoint planner's parameters, as lists and scenarios name them.
#pragma once

#include "waywright/planner/planner.hpp"
#include "waywright/planner/waypoint/waypoint_clothoid.hpp"

namespace waywright {

/// Of complete and checked parameters.
WaypointOptions waypoint_options(const Parameters& parameters);

/// `optimizers`: names that its parameter may have; `make`: one of them, that outlives the planner.
PlannerDescription waypoint_clothoid_description(std::vector<std::string> optimizers, std::function<std::shared_ptr<const Optimizer>(const std::string&)> make);

}  // namespace waywright
