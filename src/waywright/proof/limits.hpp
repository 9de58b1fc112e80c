// Is the path well formed, continuous, and within what the vehicle can drive?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waywright/proof/motion.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {

/// Numbers finite, curves not empty, directions that fit; everything else may be evaluated only when this is empty.
std::vector<Violation> check_form(const Path& path);

/// `motion` is the path's, here and below: starts at the start, ends at the goal, joins where pieces meet.
std::vector<Violation> check_continuity(const Problem& problem, const Path& path, const Motion& motion, const ProofOptions& options);

/// Curvature and curvature rate by rigorous bounds, no turning on the spot for a tricycle, no sideways motion.
std::vector<Violation> check_limits(const Vehicle& vehicle, const Path& path, const Motion& motion);

}  // namespace waywright
