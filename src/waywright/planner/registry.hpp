// Every planner and optimiser by name.
#pragma once

#include <vector>

#include "waywright/optimizer/optimizer.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright {

const std::vector<PlannerDescription>& planners();
const PlannerDescription* find_planner(std::string_view name);

const std::vector<OptimizerDescription>& optimizers();
const OptimizerDescription* find_optimizer(std::string_view name);

/// Parameters completed with defaults, or the first that is unknown, mistyped or out of range.
Parsed<Parameters> complete_parameters(const PlannerDescription& planner, const Parameters& given);

/// The same for what a scenario names: its planner must be known and its parameters fit.
Parsed<Parameters> complete_parameters(const PlannerChoice& choice);

/// Every kind of work that the budget limits is one that the planner counts; nothing is ignored in silence.
/// Does the planner take such a mission at all?
Parsed<void> check_mission(const std::string& planner, const Scenario& scenario);

Parsed<void> check_budget(const std::string& planner, const Parameters& complete, const BudgetLimits& budget);

/// Parses "KEY=VALUE" against a planner's description.
Parsed<void> set_parameter(const PlannerDescription& planner, Parameters& parameters, const std::string& key_value);

/// The whole way: checks the ends, makes the planner that the scenario names, plans, judges.
/// Only wrong parameter names or values are an InputError; everything else is a plan with its status.
Parsed<Plan> solve(const Problem& problem, const std::atomic<bool>* cancel = nullptr);

}  // namespace waywright
