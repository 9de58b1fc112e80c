#include "waywright/planner/replan.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "waywright/judge/judge.hpp"
#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/path/remainder.hpp"
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

/// Why it is not carried along, and what would come of driving the old plan on as it is.
std::vector<std::string> anew_sentences(const Problem& problem, const Path& old, double driven) {
  std::string why = "an end of it has moved, and no bend is left there that could be carried along";
  if (const auto rest = continuation(problem, old, driven)) {
    const Plan judged = judge(problem, rest->path);
    why = judged.reason.substr(0, judged.reason.find("; "));
  }
  std::vector<std::string> text{fmt::format("The way is planned anew, since what was left of the old plan cannot be carried along: {}.", why)};
  Path rest = remainder(old, driven);
  if (problem.pocket() && rest.pieces.size() > 1) rest.pieces.pop_back();  // its way into the shelf as that was
  const Proof proof = prove(problem, rest);
  const Pose& goal = problem.goal();
  const Pose end = end_pose(rest);
  if (proof.certificate.collision_free) {
    text.push_back(fmt::format("Driven on as it is, the old plan comes to {:.4f} m and {:.4f} rad from the {} as it is now, and the footprint keeps at least {:.4f} m from "
                               "everything at every pose within the pose error.",
                               distance(end.position(), goal.position()), std::abs(shorter_turn(end.heading, goal.heading)), problem.pocket() ? "docked pose" : "goal",
                               proof.certificate.clearance));
  } else {
    text.push_back("Driven on as it is, the old plan is not free of collision.");
  }
  return text;
}

/// What was left of the old plan, for the picture.
Alternative old_plan(const Path& old, double driven) {
  Alternative a;
  a.name = "old plan";
  a.was_driven = true;
  a.outcome = "What was left of the plan that was being driven.";
  for (const Sample& s : sample(remainder(old, driven), 0.0, 0.01, 0.12)) a.poses.push_back(s.pose());
  return a;
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
    const double prepared_in = std::chrono::duration<double>(Clock::now() - begin).count();
    PatternSolver solver{prepared, options, optimizer, problem.scenario().seed};
    Budget budget{problem.scenario().budget, cancel};
    if (const auto rest = solver.carry_on(old, driven, budget)) {
      const double planned_in = std::chrono::duration<double>(Clock::now() - begin).count() - prepared_in;
      Plan plan = judge(problem, rest->path, cancel);
      plan.timing.prepare = prepared_in;
      plan.timing.plan = planned_in;
      plan.effort.evaluations = budget.evaluations();
      plan.alternatives.push_back(old_plan(old, driven));
      plan.explanation.push_back(carried_sentence(*rest, budget.evaluations()));
      explain_mission(problem, plan, plan.explanation);
      if (plan.status == Status::solved) plan.explanation.push_back(proof_sentence(problem, plan));
      return plan;
    }
  }
  auto plan = solve(problem, cancel);
  if (plan && may_be_carried_on) {
    const std::vector<std::string> why = anew_sentences(problem, old, driven);
    plan->explanation.insert(plan->explanation.begin(), why.begin(), why.end());
    plan->alternatives.push_back(old_plan(old, driven));
  }
  return plan;
}

}  // namespace waywright
