// Cells that are asked for and are too many to be searched: a setting that is refused, not a map without a way.
#pragma once

#include <optional>
#include <string>

#include "waywright/core/result.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {

/// Of a planner over cells that ended before it looked at anything, for the reason `why`: was the `resolution` that it was given too fine? Then what is allowed here, with
/// what bounds it. Empty where the map itself, or something else, is the cause. @pre parameters are complete
std::optional<InputError> refused_resolution(const Problem& problem, const std::string& planner, const Parameters& parameters, const std::string& why);

}  // namespace waywright
