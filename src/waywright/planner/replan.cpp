#include "waywright/planner/replan.hpp"

#include <fmt/format.h>

#include <chrono>

#include "waywright/judge/judge.hpp"
#include "waywright/planner/solve_words.hpp"

namespace waywright {
namespace {

std::string carried_sentence(const Continuation& rest) {
  if (rest.farthest == 0.0) return "What was left of the plan stands as it is and is driven on.";
  return fmt::format("What was left of the plan was carried along with its ends: no place of it moves by more than {:.4f} m, and pose, curvature and speed go on "
                     "without a jump.",
                     rest.farthest);
}

}  // namespace

Parsed<Plan> replan(const Problem& problem, const Path& old, double driven, const std::atomic<bool>* cancel) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  std::string why_not = "an end of it has moved, and its curve there cannot be carried along";
  if (const auto rest = continuation(problem, old, driven); rest && !problem.check_ends()) {
    const double planned_in = std::chrono::duration<double>(Clock::now() - begin).count();
    Plan plan = judge(problem, rest->path, cancel);
    if (plan.status == Status::solved) {
      plan.timing.plan = planned_in;
      plan.explanation.push_back(carried_sentence(*rest));
      explain_mission(problem, plan, plan.explanation);
      plan.explanation.push_back(proof_sentence(problem, plan));
      return plan;
    }
    why_not = plan.reason;
  }
  auto plan = solve(problem, cancel);
  if (plan) plan->explanation.insert(plan->explanation.begin(), fmt::format("The way is planned anew, since what was left of the old plan cannot be driven on: {}.", why_not));
  return plan;
}

}  // namespace waywright
