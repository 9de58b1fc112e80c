// From a problem to a judged plan.
#include <chrono>

#include "waywright/judge/judge.hpp"
#include "waywright/planner/blocking_zones.hpp"
#include "waywright/planner/check_resolution.hpp"
#include "waywright/planner/go_around.hpp"
#include "waywright/planner/moving_ends.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/solve_words.hpp"

namespace waywright {

Parsed<Plan> solve(const Problem& problem, const std::atomic<bool>* cancel) {
  const Scenario& scenario = problem.scenario();
  auto parameters = complete_parameters(scenario.planner);
  if (!parameters) return tl::unexpected{parameters.error()};
  if (auto takes = check_mission(scenario.planner.name, scenario); !takes) return tl::unexpected{takes.error()};
  if (auto kept = check_budget(scenario.planner.name, *parameters, scenario.budget); !kept) return tl::unexpected{kept.error()};
  const PlannerDescription* description = find_planner(scenario.planner.name);

  const auto finish = [&](Plan plan) {
    plan.planner = description->name;
    plan.parameters = *parameters;
    return plan;
  };
  if (auto failure = problem.check_ends()) return finish(failed_plan(problem, *failure));
  if (auto failure = moving_at_ends(problem)) return finish(failed_plan(problem, *failure));
  if (!description->goes_on_in_motion) {
    if (auto failure = problem.check_stop()) return finish(failed_plan(problem, *failure));
  }

  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  const auto preparing = Clock::now();
  const AnyPlanner planner = description->make(*parameters, scenario.seed).prepared(problem);
  const double prepared_in = since(preparing);
  Budget budget{scenario.budget, cancel};
  const auto planning = Clock::now();
  PlanningResult result = planner.plan(problem, budget);
  const double planned_in = since(planning);
  if (!result && result.error().failure.status == Status::no_path && budget.evaluations() == 0 && budget.expansions() == 0) {
    if (auto refused = refused_resolution(problem, description->name, *parameters, result.error().failure.reason)) return tl::unexpected{std::move(*refused)};
  }

  Plan plan;
  if (result) {
    plan = judge(problem, problem.whole_path(std::move(result->path), result->begins_in_motion), cancel, {}, result->pace ? &*result->pace : nullptr);
    plan.explanation = std::move(result->explanation);
    plan.alternatives = std::move(result->alternatives);
    plan.optimality = result->optimality;
    plan.search = std::move(result->search);
    plan.field = std::move(result->field);
    if (problem.motion() && !description->goes_on_in_motion) plan.explanation.insert(plan.explanation.begin(), stop_sentence(problem));
    if (plan.hindrance) {
      plan.planner = description->name;
      plan.parameters = *parameters;
      auto led = led_around(problem, std::move(plan), cancel);
      if (!led) return led;
      plan = std::move(*led);
      if (auto failure = moving_at_goal(problem, plan)) {
        Plan failed = failed_plan(problem, *failure);
        failed.explanation = std::move(plan.explanation);
        failed.alternatives = std::move(plan.alternatives);
        failed.search = std::move(plan.search);
        failed.timing = plan.timing;
        failed.effort = plan.effort;
        plan = std::move(failed);
      }
    }
    if (plan.status == Status::unproven && !result->shortcoming.empty()) plan.reason += (plan.reason.empty() ? "" : "; ") + result->shortcoming;
    explain_mission(problem, plan, plan.explanation);
    if (!plan.path.pieces.empty())
      plan.explanation.push_back(plan.status == Status::solved ? proof_sentence(problem, plan)
                                                             : plan.status == Status::canceled ? "The run was interrupted: this path is not proven." : "This path is not proven: " + plan.reason + ".");
  } else {
    plan = failed_plan(problem, result.error().failure);
    if (plan.status == Status::no_path && !budget.cut_short() && !budget.canceled()) {
      if (const std::string zones = blocking_zones_words(problem, *description, *parameters, cancel); !zones.empty()) plan.reason = zones + "; with them " + plan.reason;
    }
    plan.explanation = std::move(result.error().explanation);
    plan.alternatives = std::move(result.error().alternatives);
    plan.search = std::move(result.error().search);
    plan.field = std::move(result.error().field);
  }
  const bool heeds_zones = description->heeds_zones && description->heeds_zones(*parameters);
  if (std::string sentence = unheeded_zones_sentence(problem, description->name, heeds_zones); !sentence.empty()) plan.explanation.push_back(std::move(sentence));
  plan.timing.prepare += prepared_in;
  plan.timing.plan += planned_in;
  plan.effort.evaluations += budget.evaluations();
  plan.effort.expansions += budget.expansions();
  plan.reproducible = plan.reproducible && !budget.cut_short() && !budget.canceled();
  return finish(std::move(plan));
}

}  // namespace waywright
