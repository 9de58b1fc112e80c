// The spline planners' parameters, as lists and scenarios name them.
#pragma once

#include "waywright/planner/planner.hpp"
#include "waywright/planner/spline/spline_planner.hpp"

namespace waywright {

/// Of complete and checked parameters.
SplineOptions spline_options(SplineForm curve, const Parameters& parameters);

/// `capso_spline` and `ga_bspline`. `optimizers`: names that their parameter may have; `make`: one of them, that outlives the planner.
std::vector<PlannerDescription> spline_planner_descriptions(const std::vector<std::string>& optimizers, const std::function<std::shared_ptr<const Optimizer>(const std::string&)>& make);

}  // namespace waywright
