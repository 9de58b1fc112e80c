#include "waywright/planner/solve_legs.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <numeric>

#include "waywright/judge/left_behind.hpp"
#include "waywright/judge/legs.hpp"
#include "waywright/planner/order_legs.hpp"
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
  if (mission.order == LegOrder::given) return {};
  if (auto ordered = ordered_legs(mission); !ordered) return tl::unexpected{ordered.error()};
  return {};
}

Parsed<SolvedLeg> solve_leg(const Scenario& mission, const LegBegin& begin, const World& of_map, const std::atomic<bool>* cancel) {
  const auto problem = prepare_leg(mission, begin, of_map);
  if (!problem) return tl::unexpected{problem.error()};
  auto plan = is_standing(mission, begin) ? Parsed<Plan>{standing(*problem, cancel)} : solve(*problem, cancel);
  if (!plan) return tl::unexpected{error_of_leg(mission, begin, plan.error())};
  plan->reason = told_of_load(mission, begin, {plan->status, plan->reason}).reason;
  judge_left_behind(mission, begin, *problem, *plan);
  LegBegin next = next_leg(mission, begin, end_of(*problem, plan->path));
  if (next.index == mission.legs.size() && !plan->path.pieces.empty()) {
    const auto load = check_last_load(mission, next, of_map);
    if (!load) return tl::unexpected{load.error()};
    if (*load) {
      const Effort effort = plan->effort;
      *plan = failed_plan(*problem, **load);
      plan->effort = effort;
    }
  }
  return SolvedLeg{std::move(*plan), std::move(next)};
}

namespace {

/// @pre complete_legs holds
Parsed<Plan> solve_as_they_stand(const Scenario& mission, const std::atomic<bool>* cancel) {
  const World of_map{mission.map};
  std::vector<JudgedLeg> legs;
  LegBegin begin = first_leg(mission);
  while (begin.index < mission.legs.size()) {
    auto solved = solve_leg(mission, begin, of_map, cancel);
    if (!solved) return tl::unexpected{solved.error()};
    solved->plan.scenario = {};  // with its map
    legs.push_back({begin, solved->next.pose, std::move(solved->plan)});
    if (legs.back().plan.path.pieces.empty() || legs.back().plan.status == Status::canceled) break;
    begin = std::move(solved->next);
  }
  return join_legs(mission, std::move(legs));
}

Parsed<Plan> solve_in_best_order(const Scenario& mission, const std::atomic<bool>* cancel) {
  using Clock = std::chrono::steady_clock;
  const auto choosing = Clock::now();
  auto chosen = choose_order(mission, cancel);
  if (!chosen) return tl::unexpected{chosen.error()};
  const double chosen_in = std::chrono::duration<double>(Clock::now() - choosing).count();
  auto plan = solve_as_they_stand(chosen->mission, cancel);
  if (!plan) return plan;
  std::vector<std::string> sentences = chosen->sentences;
  if (chosen->is_canceled) {
    plan->status = Status::canceled;
    plan->reason = "the run was interrupted while the order of the legs was chosen";
    plan->reproducible = false;
  } else if (!chosen->is_found && plan->status != Status::solved && plan->status != Status::canceled) {
    plan->status = chosen->failure.status;
    plan->reason = chosen->failure.reason;
    sentences.emplace_back("There is no order to choose; the legs are shown in the order given, as far as it comes.");
  } else if (chosen->is_found && plan->status != Status::solved && plan->status != Status::canceled && chosen->order.given_length && chosen->order.length < *chosen->order.given_length) {
    // Loads that were set down stand in the way of what seemed best.
    auto given = solve_as_they_stand(mission, cancel);
    if (!given) return given;
    if (given->status == Status::solved) {
      sentences = {fmt::format("The legs are driven in the order given, {:.3f} m by the lengths of the ways between the places: the order chosen by them, {:.3f} m, cannot be driven ({}).",
                               *chosen->order.given_length, chosen->order.length, plan->reason)};
      std::iota(chosen->order.given_as.begin(), chosen->order.given_as.end(), std::size_t{0});
      chosen->order.length = *chosen->order.given_length;
      chosen->order.is_exact = false;
      plan = std::move(given);
    }
  }
  if (chosen->is_found && plan->status == Status::solved && std::abs(plan->metrics.length - chosen->order.length) > 1e-3) {
    sentences.push_back(fmt::format("The plan is {:.3f} m long, not {:.3f} m: the ways between places were planned without the loads that the order had set down before, and of free headings with another one.",
                                    plan->metrics.length, chosen->order.length));
  }
  if (chosen->is_found) plan->order = chosen->order;
  plan->explanation.insert(plan->explanation.begin(), sentences.begin(), sentences.end());
  plan->effort.evaluations += chosen->effort.evaluations;
  plan->effort.expansions += chosen->effort.expansions;
  plan->timing.plan += chosen_in;
  plan->reproducible = plan->reproducible && chosen->reproducible;
  return plan;
}

}  // namespace

Parsed<Plan> solve_legs(const Scenario& scenario, const std::atomic<bool>* cancel) {
  Scenario mission = scenario;
  if (auto completed = complete_legs(mission); !completed) return tl::unexpected{completed.error()};
  return mission.order == LegOrder::given ? solve_as_they_stand(mission, cancel) : solve_in_best_order(mission, cancel);
}

}  // namespace waywright
