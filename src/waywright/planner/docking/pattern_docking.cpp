#include "waywright/planner/docking/pattern_docking.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "waywright/planner/docking/optimality.hpp"
#include "waywright/planner/docking/pattern_search.hpp"
#include "waywright/planner/docking/side_search.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

constexpr int harder_times = 4;            // evaluations of a second search where the first one finds nothing

std::vector<std::string> explain(const Problem& problem, const PatternDockingOptions& options, const SideOutcome& best,
                                 const std::vector<SideOutcome>& outcomes, const char* of) {
  std::vector<std::string> text;
  const SideOutcome* other = nullptr;
  for (const SideOutcome& outcome : outcomes) {
    if (&outcome != &best) other = &outcome;
  }
  if (other != nullptr && other->feasible) {
    const double more = 100.0 * (other->cost / best.cost - 1.0);
    text.push_back(more < 0.05 ? fmt::format("Both sides of the {} cost the same, {:.4f}; the {} one was taken.", of, best.cost, to_string(best.side))
                               : fmt::format("The {} side of the {} was chosen: its cost is {:.4f}, the {} side's {:.4f} ({:.1f} % more).", to_string(best.side),
                                             of, best.cost, to_string(other->side), other->cost, more));
  } else if (other != nullptr && other->searched) {
    text.push_back(fmt::format("The {} side of the {} was chosen because nothing was found on the other one.", to_string(best.side), of));
  } else {
    text.push_back(fmt::format("The {} side of the {} was taken; the other one was not looked at.", to_string(best.side), of));
  }
  const double back = length(best.path.pieces[0]);
  const double forth = length(best.path.pieces[1]);
  const Pose& docked = problem.goal();
  text.push_back(
      problem.is_driven_back()
          ? fmt::format("The vehicle backs {:.2f} m from the docked pose ({:.3f}, {:.3f}) to the transition point ({:.3f}, {:.3f}), the first {:.2f} m "
                        "straight, stops, and drives {:.2f} m forks first to the last pose.",
                        forth, docked.x, docked.y, best.transition.x, best.transition.y, options.leads.dock, back)
          : fmt::format("The vehicle backs {:.2f} m to the transition point ({:.3f}, {:.3f}), stops, and drives {:.2f} m forks first into the "
                        "docked pose ({:.3f}, {:.3f}); the last {:.2f} m are straight.",
                        back, best.transition.x, best.transition.y, forth, docked.x, docked.y, options.leads.dock));
  text.push_back(fmt::format("The cost is {:.2g} × change of curvature + {:.2g} × length, each over that of the reference "
                             "pattern{}; among the candidates that keep every limit and {:.3f} m from everything it is the "
                             "least found.",
                             options.weights.curvature, options.weights.length,
                             options.objective == DockingObjective::normalised ? "" : " by the exponential form",
                             problem.required_clearance()));
  for (const SideOutcome& outcome : outcomes) text.push_back(outcome.sentence);
  return text;
}

/// The reason says what is in the way of each side, the explanation more of it.
PlanningFailure failure_of(const Problem& problem, const DockingTask& task, const std::vector<SideOutcome>& outcomes, const Budget& budget) {
  PlanningFailure failure;
  std::vector<std::string> sides;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const SideOutcome& outcome = outcomes[i];
    failure.explanation.push_back(outcome.sentence);
    if (outcome.contact && !failure.failure.point) failure.failure.point = outcome.contact->point;
    const std::string why = task.zones[i].left_out() ? "too narrow"
                            : !outcome.searched      ? "not searched"
                            : outcome.contact        ? "blocked by " + contact_words(problem, *outcome.contact)
                                                     : "over the limit of curvature or its rate";
    sides.push_back(fmt::format("{} side {}", to_string(outcome.side), why));
  }
  failure.failure.status = budget.canceled() ? Status::canceled : budget.cut_short() ? Status::timed_out : Status::no_path;
  failure.failure.reason = fmt::format("no docking pattern fits: {}", fmt::join(sides, ", "));
  failure.alternatives = alternatives_of(task, outcomes, nullptr);
  return failure;
}

std::string optimality_sentence(const Optimality& o) {
  return fmt::format("Branch and bound over {} boxes of transition points and headings: no docking pattern of this form on the sides searched costs less than "
                     "{:.4f}, so this one is at most {:.1f} % above the optimum.",
                     o.boxes, o.lower_bound, 100.0 * o.gap());
}

/// The search allows for what is between its samples by estimates; what the proof does not confirm is not offered.
bool stands(const Problem& problem, const SideOutcome& outcome) { return prove(problem, problem.whole_path(outcome.path)).holds(); }

}  // namespace

PatternDockingPlanner::PatternDockingPlanner(PatternDockingOptions options, std::shared_ptr<const Optimizer> optimizer,
                                             std::uint64_t seed, std::optional<AnyPlanner> fallback)
    : options_{options}, optimizer_{std::move(optimizer)}, seed_{seed}, fallback_{std::move(fallback)} {}

PatternDockingPlanner PatternDockingPlanner::prepared(const Problem& problem) const {
  PatternDockingPlanner ready = *this;
  ready.prepared_ = std::make_shared<const PreparedDocking>(problem);
  return ready;
}

PlanningResult PatternDockingPlanner::plan(const Problem& problem, Budget& budget) const {
  if (prepared_ && &prepared_->problem() == &problem) return plan(*prepared_, budget);
  return plan(PreparedDocking{problem}, budget);
}

PlanningResult PatternDockingPlanner::plan(const PreparedDocking& prepared, Budget& budget) const {
  const Problem& problem = prepared.problem();
  const DockingTask& task = prepared.task();
  std::vector<SideOutcome> outcomes = search_sides(prepared, options_, *optimizer_, seed_, fallback_.has_value(), budget);
  if (best_of(outcomes) == nullptr && !budget.limits().evaluations && !budget.exhausted()) {
    PatternDockingOptions harder = options_;
    harder.evaluations *= harder_times;
    outcomes = search_sides(prepared, harder, *optimizer_, seed_, fallback_.has_value(), budget);
  }
  while (const SideOutcome* best = best_of(outcomes)) {
    if (stands(problem, *best)) {
      Planned planned{best->path, explain(problem, options_, *best, outcomes, task.zones.front().of), alternatives_of(task, outcomes, best)};
      if (options_.gap > 0.0) {
        planned.optimality = bound_optimum(prepared, options_, reference_measures(prepared, options_.leads), best->cost, budget);
        planned.explanation.push_back(optimality_sentence(*planned.optimality));
      }
      return planned;
    }
    SideOutcome& refused = outcomes[static_cast<std::size_t>(best - outcomes.data())];
    refused.feasible = false;
    refused.sentence += " The proof refuses it.";
  }
  PlanningFailure failure = failure_of(problem, task, outcomes, budget);
  if (!fallback_ || budget.exhausted()) return tl::unexpected{std::move(failure)};

  PlanningResult second = fallback_->plan(problem, budget);
  if (second) {
    std::vector<std::string> text{"No docking pattern fits; this path is the second choice, found by the general planner " +
                                  std::string{fallback_->name()} + "."};
    text.insert(text.end(), second->explanation.begin(), second->explanation.end());
    text.insert(text.end(), failure.explanation.begin(), failure.explanation.end());
    second->explanation = std::move(text);
    second->alternatives.insert(second->alternatives.end(), failure.alternatives.begin(), failure.alternatives.end());
    return second;
  }
  PlanningFailure& both = second.error();
  failure.failure.status = both.failure.status;
  failure.failure.reason += fmt::format("; the second choice {} found none either", fallback_->name());
  failure.explanation.insert(failure.explanation.end(), both.explanation.begin(), both.explanation.end());
  failure.failure.pose = both.failure.pose;
  if (both.failure.point) failure.failure.point = both.failure.point;
  failure.alternatives.insert(failure.alternatives.end(), both.alternatives.begin(), both.alternatives.end());
  return tl::unexpected{std::move(failure)};
}

}  // namespace waywright
