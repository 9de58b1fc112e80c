// The checks that a scenario file's reader makes, for scenarios that a program builds itself.
#pragma once

#include <optional>

#include "waywright/core/result.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

/// Repairs polygons where that is safe; the first thing that cannot be used, with its field's name.
std::optional<InputError> check_fields(Scenario& scenario);

}  // namespace waywright
