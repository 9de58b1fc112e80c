// The charts along a plan's path.
#pragma once

#include <string>

#include "waywright/judge/plan.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// Curvature, steering angle (of a tricycle), clearance and speed, each in two widths of which a page shows
/// the one that fits; what the colours mean. Empty where there is no path.
std::string charts_html(const Problem& problem, const Plan& plan);

}  // namespace waywright
