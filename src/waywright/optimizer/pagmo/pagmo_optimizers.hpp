// The five metaheuristics of the docking publication, through pagmo.
#pragma once

#include <vector>

#include "waywright/optimizer/optimizer.hpp"

namespace waywright {

/// "ga", "pso", "de", "sa", "aco" with the published reconstruction's parameters (population 20 by default).
std::vector<OptimizerDescription> pagmo_optimizers();

}  // namespace waywright
