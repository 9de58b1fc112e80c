// The files that every judged plan leaves.
#pragma once

#include <filesystem>
#include <functional>

#include "commands.hpp"
#include "waywright/judge/plan.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright::app {

/// `waywright-out/NAME`, the name made safe for a folder.
std::filesystem::path default_folder(const std::string& name);

/// Makes the folder and tries it before long work begins.
Parsed<void> prepare_folder(const std::filesystem::path& folder);

/// Makes the folder that a file is to lie in where there is none, and says so.
Parsed<void> prepare_folder_of(const std::filesystem::path& file);

/// --planner, --set and --seed go into the scenario, so that the plan file holds what was used.
Parsed<void> apply(const PlanArguments& arguments, Scenario& scenario);

/// Refuses --planner and --set of a mission whose legs all name planners of their own.
Parsed<void> check_somebody_asks(const std::string& planner, const std::vector<std::string>& settings, const Scenario& scenario);

/// Each KEY of --set once: the last one would win in silence.
Parsed<void> check_each_key_once(const std::vector<std::string>& settings);

/// Refuses --set evaluations=… where the budget names evaluations, which come before the planner's.
Parsed<void> check_no_budget_over(const std::string& setting, const BudgetLimits& budget);

/// plan.json, plan.svg, report.html: all or none.
Parsed<void> write_plan(const std::filesystem::path& folder, const Problem& problem, const Plan& plan);
/// The same of a mission in legs.
Parsed<void> write_plan(const std::filesystem::path& folder, const Plan& plan);

/// Scenario file, read and changed, with the time that took. A configuration file of the publication on RRT* with the whale optimisation algorithm is taken too, for
/// `planner` where one is named; what its keys become is said on standard error.
struct LoadedScenario {
  Scenario scenario;
  double load = 0.0;  ///< s
};
Parsed<LoadedScenario> load_scenario(const std::filesystem::path& file, const std::function<Parsed<void>(Scenario&)>& change = {}, const std::string& planner = {});

/// For commands that know no legs: `why` is what is wrong with a mission in legs.
Parsed<void> refuse_legs(const Scenario& scenario, const std::filesystem::path& file, const char* why, const char* allowed = "a scenario with one goal or station");

/// Scenario file → problem, with the times it took.
struct Loaded {
  Problem problem;
  double load = 0.0, prepare = 0.0;  ///< s
};
Parsed<Loaded> prepare(LoadedScenario scenario, const std::filesystem::path& file);
Parsed<Loaded> load(const std::filesystem::path& scenario, const std::function<Parsed<void>(Scenario&)>& change = {});

}  // namespace waywright::app
