#include "waywright/planner/solve_legs.hpp"

#include "waywright/judge/left_behind.hpp"
#include "waywright/judge/legs.hpp"
#include "waywright/planner/solve_words.hpp"

namespace waywright {
namespace {

Parsed<void> complete(PlannerChoice& choice, const BudgetLimits& budget) {
  auto parameters = complete_parameters(choice);
  if (!parameters) return tl::unexpected{parameters.error()};
  choice.parameters = std::move(*parameters);
  return check_budget(choice.name, choice.parameters, budget);
}

/// The plan of a leg on which the vehicle stands: no planner has anything to plan there.
Plan standing(const Problem& problem, const std::atomic<bool>* cancel) {
  const Scenario& scenario = problem.scenario();
  const auto failure = problem.check_ends();
  const Pose& there = problem.goal();
  Plan plan = failure ? failed_plan(problem, *failure) : judge(problem, Path{{{Turn{there.position(), there.heading, 0.0}, 0}}}, cancel);
  if (!failure) plan.explanation = {"The vehicle stands there, where the load is changed; nothing is driven, and no planner is asked."};
  if (plan.status == Status::solved) plan.explanation.push_back(proof_sentence(problem, plan));
  plan.parameters = *complete_parameters(scenario.planner);
  return plan;
}

}  // namespace

Parsed<void> complete_legs(Scenario& mission) {
  if (auto checked = check_legs(mission); !checked) return checked;
  // A planner that no leg asks is still one that is named: its parameters must fit, what it counts does not matter.
  if (auto known = complete(mission.planner, {}); !known) return known;
  Scenario without_map = mission;
  without_map.map = {};
  LegBegin begin = first_leg(mission);
  for (Leg& leg : mission.legs) {
    const Scenario scenario = leg_scenario(without_map, begin);
    Parsed<void> taken = check_mission(scenario.planner.name, scenario);
    PlannerChoice choice = planner_of(mission, leg);
    if (taken) taken = complete(choice, mission.budget);
    if (!taken) return tl::unexpected{error_of_leg(mission, begin, taken.error())};
    if (leg.planner) leg.planner = std::move(choice);
    ++begin.index;
  }
  return {};
}

Parsed<Plan> solve_legs(const Scenario& scenario, const std::atomic<bool>* cancel) {
  Scenario mission = scenario;
  if (auto completed = complete_legs(mission); !completed) return tl::unexpected{completed.error()};
  const World of_map{mission.map};
  std::vector<JudgedLeg> legs;
  LegBegin begin = first_leg(mission);
  while (begin.index < mission.legs.size()) {
    const auto problem = prepare_leg(mission, begin, of_map);
    if (!problem) return tl::unexpected{problem.error()};
    auto plan = is_standing(mission, begin) ? Parsed<Plan>{standing(*problem, cancel)} : solve(*problem, cancel);
    if (!plan) return tl::unexpected{error_of_leg(mission, begin, plan.error())};
    plan->reason = told_of_load(mission, begin, {plan->status, plan->reason}).reason;
    judge_left_behind(mission, begin, *problem, *plan);
    const LegBegin next = next_leg(mission, begin, end_of(*problem, plan->path));
    if (next.index == mission.legs.size() && !plan->path.pieces.empty()) {
      const auto load = check_last_load(mission, next, of_map);
      if (!load) return tl::unexpected{load.error()};
      if (*load) {
        const Effort effort = plan->effort;
        *plan = failed_plan(*problem, **load);
        plan->effort = effort;
      }
    }
    plan->scenario = {};  // with its map
    legs.push_back({begin, next.pose, std::move(*plan)});
    if (legs.back().plan.path.pieces.empty() || legs.back().plan.status == Status::canceled) break;
    begin = next;
  }
  return join_legs(mission, std::move(legs));
}

}  // namespace waywright
