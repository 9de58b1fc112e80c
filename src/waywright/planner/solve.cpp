// From a problem to a judged plan.
#include <fmt/format.h>

#include <chrono>

#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {
namespace {

std::string proof_sentence(const Problem& problem, const Plan& plan) {
  const Certificate& c = plan.certificate;
  const bool is_measured = c.tightest.has_value();
  std::string text = is_measured ? fmt::format("Proven along the whole motion: the footprint keeps at least {:.4f} m from everything", c.clearance)
                                 : fmt::format("Proven along the whole motion: nothing is nearer to the footprint than {:.4f} m", c.clearance);
  if (problem.pose_error_margin() > 0.0) {
    text += fmt::format(" at every pose within the pose error (which takes {:.4f} m)", problem.pose_error_margin());
  }
  if (is_measured) {
    text += fmt::format("; it is tightest against {} at ({:.2f}, {:.2f})", plan.tightest_obstacle, c.tightest_point.x,
                        c.tightest_point.y);
  }
  return text + ".";
}

/// What the mission adds to what the planner was asked.
void explain_mission(const Problem& problem, const Plan& plan, std::vector<std::string>& text) {
  const Scenario& scenario = problem.scenario();
  if (problem.is_driven_back()) {
    text.insert(text.begin(), "The way out was planned as the way of docking from the last pose, and is driven back.");
  }
  if (!scenario.carried_load.empty()) {
    text.push_back(fmt::format("The load \"{}\" is carried all the way and belongs to the footprint{}.", scenario.carried_load,
                               problem.pocket() ? "; only between the docked pose and the forks' place in the shelf it may overlap the shelf" : ""));
  }
  if (problem.pocket() && plan.certificate.pocket_clearance && plan.certificate.collision_free) {
    const Insertion& insertion = *std::get<Station>(scenario.mission).insertion;
    text.push_back(fmt::format("The forks move straight for {:.2f} m, to {:.2f} m behind the shelf's face; no more than they enter the shelf, and they keep at least "
                               "{:.4f} m from its parts beside the pockets at every pose within the pose error.",
                               distance(problem.pocket()->outer.position(), problem.pocket()->inner.position()), insertion.depth,
                               *plan.certificate.pocket_clearance));
  }
}

}  // namespace

Parsed<Plan> solve(const Problem& problem, const std::atomic<bool>* cancel) {
  const Scenario& scenario = problem.scenario();
  auto parameters = complete_parameters(scenario.planner);
  if (!parameters) return tl::unexpected{parameters.error()};
  if (auto kept = check_budget(scenario.planner.name, *parameters, scenario.budget); !kept) return tl::unexpected{kept.error()};
  const PlannerDescription* description = find_planner(scenario.planner.name);

  const auto finish = [&](Plan plan) {
    plan.planner = description->name;
    plan.parameters = *parameters;
    return plan;
  };
  if (auto failure = problem.check_ends()) return finish(failed_plan(problem, *failure));

  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  const auto preparing = Clock::now();
  const AnyPlanner planner = description->make(*parameters, scenario.seed).prepared(problem);
  const double prepared_in = since(preparing);
  Budget budget{scenario.budget, cancel};
  const auto planning = Clock::now();
  PlanningResult result = planner.plan(problem, budget);
  const double planned_in = since(planning);

  Plan plan;
  if (result) {
    plan = judge(problem, problem.whole_path(std::move(result->path)), cancel);
    plan.explanation = std::move(result->explanation);
    plan.alternatives = std::move(result->alternatives);
    plan.optimality = result->optimality;
    explain_mission(problem, plan, plan.explanation);
    plan.explanation.push_back(plan.status == Status::solved ? proof_sentence(problem, plan)
                                                             : "This path is not proven: " + plan.reason + ".");
  } else {
    plan = failed_plan(problem, result.error().failure);
    plan.explanation = std::move(result.error().explanation);
    plan.alternatives = std::move(result.error().alternatives);
  }
  plan.timing.prepare = prepared_in;
  plan.timing.plan = planned_in;
  plan.effort.evaluations = budget.evaluations();
  plan.reproducible = !budget.cut_short() && !budget.canceled();
  return finish(std::move(plan));
}

}  // namespace waywright
