// The metaheuristics of the publications, through pagmo.
#pragma once

#include <vector>

#include "waywright/optimizer/optimizer.hpp"

namespace waywright {

/// "ga", "pso", "de", "sa", "aco" with the docking publication's reconstructed parameters (population 20 by default), and those of the other
/// publications: "ga_intermediate" (waypoints), "capso" and "ga_spline" (splines), "woa" and, of our own, "woa_unbiased" (RRT*-WOA).
std::vector<OptimizerDescription> pagmo_optimizers();

}  // namespace waywright
