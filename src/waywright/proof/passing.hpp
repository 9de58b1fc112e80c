// Does the path pass the mission's waypoints, in their order?
#pragma once

#include <vector>

#include "waywright/proof/motion.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {

/// The origin of the body frame passes each waypoint within the scenario's radius (and the tolerance of positions), not before it passes the
/// one before. Decided by bounds on the exact curves.
std::vector<Violation> check_waypoints(const Problem& problem, const Motion& motion, const ProofOptions& options);

}  // namespace waywright
