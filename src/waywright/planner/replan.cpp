#include "waywright/planner/replan.hpp"

#include <fmt/format.h>

#include <chrono>

#include "waywright/judge/judge.hpp"
#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/planner/docking/pattern_solver.hpp"
#include "waywright/planner/solve_words.hpp"

namespace waywright {
namespace {

std::string carried_sentence(const Continuation& rest, std::int64_t evaluations) {
  if (rest.farthest == 0.0) return "What was left of the plan stands as it is and is driven on.";
  return fmt::format("What was left of the plan was carried along with its ends{}: no place of it moves by more than {:.4f} m, and pose, curvature and speed go on "
                     "without a jump.",
                     evaluations == 0 ? "" : fmt::format(", and its point of changing direction moved as little as {} candidates showed to serve", evaluations), rest.farthest);
}

std::string anew_sentence(const Problem& problem, const Path& old, double driven) {
  const auto rest = continuation(problem, old, driven);
  return fmt::format("The way is planned anew, since what was left of the old plan cannot be driven on: {}.",
                     rest ? judge(problem, rest->path).reason : "an end of it has moved, and its curve there cannot be carried along");
}

}  // namespace

Parsed<Plan> replan(const Problem& problem, const Path& old, double driven, const std::atomic<bool>* cancel) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const bool may_be_carried_on = !problem.check_ends();
  if (may_be_carried_on) {
    const PreparedDocking prepared{problem};
    const PatternDockingOptions options;
    const LatticeSearch optimizer;
    PatternSolver solver{prepared, options, optimizer, problem.scenario().seed};
    Budget budget{problem.scenario().budget, cancel};
    if (const auto rest = solver.carry_on(old, driven, budget)) {
      const double planned_in = std::chrono::duration<double>(Clock::now() - begin).count();
      Plan plan = judge(problem, rest->path, cancel);
      plan.timing.plan = planned_in;
      plan.effort.evaluations = budget.evaluations();
      plan.explanation.push_back(carried_sentence(*rest, budget.evaluations()));
      explain_mission(problem, plan, plan.explanation);
      if (plan.status == Status::solved) plan.explanation.push_back(proof_sentence(problem, plan));
      return plan;
    }
  }
  auto plan = solve(problem, cancel);
  if (plan && may_be_carried_on) plan->explanation.insert(plan->explanation.begin(), anew_sentence(problem, old, driven));
  return plan;
}

}  // namespace waywright
