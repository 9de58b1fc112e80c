// Whether it is the scenario's zones that leave no way.
#pragma once

#include <string>

#include "waywright/planner/planner.hpp"

namespace waywright {

/// Asks the planner again, without the scenario's forbidden and directed zones and with a budget as large. Where it finds a way then, a sentence without
/// its stop: which zones stand in that way or are driven against their direction on it, and its length. Empty where there are no such zones, where
/// it finds none then either, or where the way meets none of them. @pre the planner found no way with them
std::string blocking_zones_words(const Problem& problem, const PlannerDescription& planner, const Parameters& complete, const std::atomic<bool>* cancel);

}  // namespace waywright
