// What every plan's explanation says of its mission and its proof.
#pragma once

#include <string>
#include <vector>

#include "waywright/judge/plan.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// What was proven. @pre the plan is solved
std::string proof_sentence(const Problem& problem, const Plan& plan);

/// What the mission adds to what the planner was asked.
void explain_mission(const Problem& problem, const Plan& plan, std::vector<std::string>& text);
/// The same of a path that no planner made: where it waits, what it carries, where it ends.
void explain_driven(const Problem& problem, const Plan& plan, std::vector<std::string>& text);

/// Where, when and for whom the vehicle waits.
std::string wait_sentence(const Problem& problem, const Wait& wait);

/// What of the scenario's zones the planner does not look at. Empty where it heeds them, or where none directs or weighs.
std::string unheeded_zones_sentence(const Problem& problem, const std::string& planner, bool heeds_zones);

/// That a vehicle which moves stops first. @pre it moves
std::string stop_sentence(const Problem& problem);

}  // namespace waywright
