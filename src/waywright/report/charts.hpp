// The charts along a plan's path.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "waywright/judge/plan.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// Curvature, steering angle (of a tricycle), clearance and speed, each in two widths of which a page shows
/// the one that fits; what the colours mean. Empty where there is no path.
std::string charts_html(const Problem& problem, const Plan& plan);

/// What is asked of a path's clearance, and what it has at its samples, m; and where zones limit its speed.
struct AskedAlong {
  std::vector<double> clearance;
  double required = 0.0;
  double margin = 0.0;  ///< of `required`, for the pose error
  std::vector<double> zone_speed{};  ///< m/s at the samples, infinity where no zone limits it; empty: nowhere
};
/// The same of any plan, for which these are known.
std::string charts_html(const Plan& plan, const AskedAlong& asked);

/// A picture of the clearance along several plans of one problem, each with its name; cut off where it no longer matters.
std::string clearances_svg(const Problem& problem, const std::vector<std::pair<std::string, const Plan*>>& plans, double width);

}  // namespace waywright
