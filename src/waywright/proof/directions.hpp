// Does the path keep to the direction of the zones that have one?
#pragma once

#include <vector>

#include "waywright/proof/motion.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {

/// While the vehicle's origin is inside of a directed zone (deeper than `zone_depth`), its course is at most 90° (and `zone_course`) off the zone's direction. Decided by bounds on
/// the exact curves, of what is between samples too; turning on the spot is no driving. Of poses from outside, whose steps carry noise, the progress along the direction may fall
/// back by `retreat_allowed` at most, while the origin is inside. At most one sentence a zone.
std::vector<Violation> check_directions(const Problem& problem, const Path& path, const Motion& motion, const ProofOptions& options);

}  // namespace waywright
