// May a vehicle that moves go on along a path at the speed that it has?
#pragma once

#include <optional>
#include <vector>

#include "waywright/proof/proof.hpp"
#include "waywright/speed/speed.hpp"

namespace waywright {

/// True where the vehicle stands, or every limit can be kept along the samples from the speed that it has.
bool can_be_entered(const Problem& problem, const std::vector<Sample>& samples, SpeedWorkspace& workspace, const LimitsAlong& along = {});

/// The same in words, and for poses from outside whether they begin with about the vehicle's curvature. @pre samples of a path that was found
/// to begin at the vehicle's pose in its direction
std::optional<Violation> check_entry(const Problem& problem, const std::vector<Sample>& samples, SpeedWorkspace& workspace, const LimitsAlong& along = {});

}  // namespace waywright
