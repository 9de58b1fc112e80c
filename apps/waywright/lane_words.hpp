#pragma once

#include <string>

#include "waywright/judge/plan.hpp"

namespace waywright::app {

/// Of a plan whose scenario was made of lanes (`meta.lanes`, as `map --scenario` writes it): how much of the way, as the vehicle's origin has it, lies farther than half a lane's
/// width from all of them, and where. Empty where the scenario tells of no lanes, or the plan has no way.
std::string lanes_sentence(const Plan& plan);

/// Puts it before the explanation's last sentence, which is that of the proof.
void tell_of_lanes(Plan& plan);

}  // namespace waywright::app
