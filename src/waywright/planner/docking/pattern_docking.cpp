#include "waywright/planner/docking/pattern_docking.hpp"

#include <fmt/format.h>

#include <utility>

#include "waywright/planner/docking/optimality.hpp"
#include "waywright/planner/docking/pattern_words.hpp"

namespace waywright {

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
  PatternSolver solver{prepared, options_, *optimizer_, seed_};
  const SideFound* found = solver.solve(fallback_.has_value(), budget);
  const std::vector<SideOutcome> outcomes = outcomes_of(prepared, solver, budget);
  if (found != nullptr) {
    const SideOutcome& best = outcomes[static_cast<std::size_t>(found - solver.sides().data())];
    Planned planned{best.path, explain(problem, options_, solver, best, outcomes, task.zones.front().of), alternatives_of(task, outcomes, &best)};
    planned.begins_in_motion = solver.in_motion();
    if (options_.gap > 0.0) {
      if (solver.in_motion()) {
        planned.explanation.push_back("How far this is from the optimum was not bounded: that is done for patterns that begin at rest.");
      } else {
        planned.optimality = bound_optimum(prepared, options_, reference_measures(prepared, options_.leads), best.cost, budget);
        planned.explanation.push_back(optimality_sentence(*planned.optimality));
      }
    }
    return planned;
  }
  PlanningFailure failure = failure_of(problem, task, solver, outcomes, budget);
  if (!fallback_ || budget.exhausted() || !solver.can_stop()) return tl::unexpected{std::move(failure)};

  PlanningResult second = fallback_->plan(problem, budget);
  if (second) {
    std::vector<std::string> text{"No " + std::string{pattern_name(problem)} + " fits; this path is the second choice, found by the general planner " +
                                  std::string{fallback_->name()} + "."};
    text.insert(text.end(), second->explanation.begin(), second->explanation.end());
    text.insert(text.end(), failure.explanation.begin(), failure.explanation.end());
    second->explanation = std::move(text);
    second->alternatives.insert(second->alternatives.end(), failure.alternatives.begin(), failure.alternatives.end());
    return second;
  }
  PlanningFailure& both = second.error();
  failure.failure.status = both.failure.status;
  failure.failure.reason += fmt::format("; the second choice {} found none either: {}", fallback_->name(), both.failure.reason);
  for (std::string& sentence : both.explanation) {
    if (sentence != both.failure.reason + ".") failure.explanation.push_back(std::move(sentence));  // the reason is told once
  }
  failure.failure.pose = both.failure.pose;
  if (both.failure.point) failure.failure.point = both.failure.point;
  failure.alternatives.insert(failure.alternatives.end(), both.alternatives.begin(), both.alternatives.end());
  return tl::unexpected{std::move(failure)};
}

}  // namespace waywright
