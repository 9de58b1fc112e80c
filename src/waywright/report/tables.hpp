// The report's tables as HTML.
#pragma once

#include <string>

#include "waywright/judge/plan.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

std::string metric_table(const Problem& problem, const Plan& plan);
std::string scenario_table(const Problem& problem, const Plan& plan);
/// Of a mission in legs.
std::string metric_table(const Plan& plan);
std::string scenario_table(const Plan& plan);
/// Length, time, tightest spot, load and mass of each; with its heading.
std::string legs_table(const Plan& plan);
/// With its heading; empty where nothing is told of alternatives.
std::string alternatives_table(const Plan& plan);

}  // namespace waywright
