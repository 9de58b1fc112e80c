// What a run's path costs by the objective of its planner.
#pragma once

#include <optional>
#include <string>

#include "waywright/judge/plan.hpp"

namespace waywright {

struct RunCost {
  std::string objective;  ///< in words, with its weights; the same words, the same objective: "docking, normalised, curvature_weight 0.7, length_weight 0.3"
  double cost = 0.0;
};

/// Of the alternative that was chosen. Empty without a path, and for planners that tell no cost. Both docking planners share the publication's costs.
std::optional<RunCost> cost_of(const Plan& plan);

}  // namespace waywright
