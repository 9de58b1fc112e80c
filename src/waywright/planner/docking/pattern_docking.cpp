#include "waywright/planner/docking/pattern_docking.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "waywright/planner/docking/candidate.hpp"
#include "waywright/planner/docking/side_search.hpp"

namespace waywright {
namespace {

// The publication's reference transition point in front of and beside the shelf, for its largest curvature of 0.8 1/m.
constexpr Vec2 published_reference{4.0, 3.5};
constexpr double published_curvature = 0.8;

constexpr double first_share = 0.3;        // of the evaluations of a side, before sides are compared
constexpr double by_far = 1.1;             // a side that costs more than this times the other one's best is given up
constexpr int harder_times = 4;            // evaluations of a second search where the first one finds nothing
constexpr double infeasible_costs = 100.0;  // graded costs from here on stand for what is not feasible

double objective_value(const PatternDockingOptions& options, const PathMeasures& path, const PathMeasures& reference) {
  return options.objective == DockingObjective::normalised
             ? normalised_cost(path, reference, options.weights)
             : exponential_cost(path, reference, options.weights);
}

/// One reference for both sides, so that their costs can be compared: the shorter of the two reference paths, its change of
/// curvature no more than three bends at the curvature limit.
PathMeasures reference_measures(const Problem& problem, const DockingTask& task, const PatternLeads& leads,
                                CandidateEvaluator& evaluator) {
  const double limit = problem.vehicle().max_curvature();
  const double scale = std::isfinite(limit) && limit > 0.0 ? published_curvature / limit : 1.0;
  PathMeasures reference;
  for (const Zone& zone : task.zones) {
    const double sign = zone.side == Side::left ? 1.0 : -1.0;
    const Vec2 point{scale * published_reference.x, sign * scale * published_reference.y};
    const Pose transition = task.frame.to_world(make_pose(point, transition_heading(zone.side, task.dock.heading)));
    const CandidateScore score =
        evaluator.measure(docking_pattern(problem.start(), problem.goal(), transition, leads));
    if (reference.length == 0.0 || score.measures.length < reference.length) reference = score.measures;
  }
  if (std::isfinite(limit)) reference.curvature_change = std::min(reference.curvature_change, 6.0 * limit);
  return reference;
}

std::string infeasible_sentence(const Problem& problem, const SideOutcome& outcome, const CandidateScore& score,
                                std::int64_t evaluations) {
  std::string text = fmt::format("On the {} side no pattern fits: of {} candidates the best", to_string(outcome.side),
                                 evaluations);
  if (!score.free && outcome.contact) {
    text += fmt::format(" came {:.1f} of {:.1f} m before it met {}", score.reach * score.measures.length,
                        score.measures.length, contact_words(problem, *outcome.contact));
  } else {
    const double limit = problem.vehicle().max_curvature();
    std::vector<std::string> needs;
    if (score.measures.max_curvature > limit) {
      needs.push_back(fmt::format("a curvature of {:.3f} 1/m (limit {:.3f})", score.measures.max_curvature, limit));
    }
    if (const auto rate = problem.vehicle().limits.curvature_rate; rate && score.max_curvature_rate > *rate) {
      needs.push_back(fmt::format("a curvature rate of {:.3f} 1/m² (limit {:.3f})", score.max_curvature_rate, *rate));
    }
    text += needs.empty() ? " needs as much curvature as the limits allow, and no reserve is left" : fmt::format(" needs {}", fmt::join(needs, " and "));
  }
  return text + ".";
}

/// The search on one side, which can be halted while it is seen which side deserves the work.
class SideSearch {
 public:
  SideSearch(const PreparedDocking& prepared, const Zone& zone, const PatternDockingOptions& options, const Optimizer& optimizer,
             const PathMeasures& reference, CandidateEvaluator& evaluator, const SearchOptions& search)
      : prepared_{prepared}, zone_{zone}, options_{options}, optimizer_{optimizer}, evaluator_{evaluator}, search_{search},
        space_{search_space(zone, options.heading_range)}, start_{placement_of(prepared.problem().start())},
        dock_{placement_of(prepared.problem().goal())}, resumable_{optimizer.begin(space_, search)} {
    cost_ = [this, reference](std::span<const double> x, double enough) {
      const DockingPattern pattern = pattern_at(x);
      CandidateScore score = evaluator_.measure(pattern);
      const double objective = objective_value(options_, score.measures, reference);
      if (objective >= enough) return Evaluation{objective, 0.0, objective};
      evaluator_.check(pattern, score);
      return Evaluation{objective, score.violation(), graded_cost(score, objective)};
    };
  }
  SideSearch(const SideSearch&) = delete;
  SideSearch& operator=(const SideSearch&) = delete;

  std::int64_t evaluations() const { return search_.evaluations; }
  /// Goes on to a share of all its evaluations; all at once where the optimizer cannot be halted.
  void advance(double share, Budget& budget) {
    if (search_.evaluations < 1) return;
    if (resumable_) {
      resumable_->advance(cost_, static_cast<std::int64_t>(std::ceil(share * static_cast<double>(search_.evaluations))), budget);
    } else if (plain_.best.empty()) {
      plain_ = optimizer_.minimise(cost_, space_, search_, budget);
    }
  }
  const SearchResult& result() const { return resumable_ ? resumable_->result() : plain_; }
  bool is_feasible() const { return !result().best.empty() && result().cost < infeasible_costs; }
  SideOutcome outcome(bool given_up, const Budget& budget) const;

 private:
  DockingPattern pattern_at(std::span<const double> x) const {
    return docking_pattern(start_, dock_, transition_placement(prepared_.task(), zone_, x), options_.leads);
  }

  const PreparedDocking& prepared_;
  const Zone& zone_;
  const PatternDockingOptions& options_;
  const Optimizer& optimizer_;
  CandidateEvaluator& evaluator_;
  SearchOptions search_;
  SearchSpace space_;
  Placement start_, dock_;
  CostFunction cost_;
  std::unique_ptr<ResumableSearch> resumable_;
  SearchResult plain_;
};

SideOutcome SideSearch::outcome(bool given_up, const Budget& budget) const {
  const Problem& problem = prepared_.problem();
  const SearchResult& found = result();
  SideOutcome outcome;
  outcome.side = zone_.side;
  if (found.best.empty()) {
    outcome.sentence = not_searched_sentence(zone_.side, budget);
    return outcome;
  }
  outcome.searched = true;
  const DockingPattern pattern = pattern_at(found.best);
  const CandidateScore score = evaluator_.evaluate(pattern);
  outcome.path = pattern_path(splines_of(pattern));
  outcome.transition = transition_pose(prepared_.task(), zone_, found.best);
  outcome.feasible = score.feasible();
  outcome.cost = found.cost;
  if (!score.free) outcome.contact = problem.world().clearance(problem.footprint(), score.blocked_at, 1.0);
  if (outcome.feasible) {
    outcome.sentence = fmt::format(
        "On the {} side the best of {} candidates costs {:.4f}: {:.2f} m long, change of curvature {:.3f} 1/m, greatest "
        "curvature {:.3f} 1/m.",
        to_string(zone_.side), found.evaluations, outcome.cost, score.measures.length, score.measures.curvature_change,
        score.measures.max_curvature);
  } else {
    outcome.sentence = infeasible_sentence(problem, outcome, score, found.evaluations);
  }
  if (given_up) outcome.sentence += " The search there was ended, as the other side is better by far.";
  return outcome;
}

/// Both sides get a first share; then a side that is worse by far than the other one is given up.
std::vector<SideOutcome> search_sides(const PreparedDocking& prepared, const PatternDockingOptions& options, const Optimizer& optimizer,
                                      std::uint64_t seed, bool second_choice, Budget& budget) {
  const DockingTask& task = prepared.task();
  CandidateEvaluator evaluator{prepared};
  const PathMeasures reference = reference_measures(prepared.problem(), task, options.leads, evaluator);
  SideShares shares{task.zones, options.sides, options.evaluations, budget, second_choice};
  std::vector<std::unique_ptr<SideSearch>> searches;  // nullptr: a side that is not searched
  for (const Zone& zone : task.zones) {
    searches.push_back(nullptr);
    if (zone.left_out() || !is_wanted(options.sides, zone.side)) continue;
    SearchOptions search;
    search.population = options.population;
    search.seed = seed + (zone.side == Side::left ? 0 : 1);
    search.evaluations = shares.next();
    searches.back() = std::make_unique<SideSearch>(prepared, zone, options, optimizer, reference, evaluator, search);
  }
  double best = std::numeric_limits<double>::infinity();
  for (const auto& search : searches) {
    if (!search) continue;
    search->advance(first_share, budget);
    if (search->is_feasible()) best = std::min(best, search->result().cost);
  }
  std::vector<SideOutcome> outcomes;
  for (std::size_t i = 0; i < searches.size(); ++i) {
    const Zone& zone = task.zones[i];
    if (searches[i]) {
      const bool given_up = std::isfinite(best) && !(searches[i]->is_feasible() && searches[i]->result().cost <= by_far * best);
      if (!given_up) searches[i]->advance(1.0, budget);
      outcomes.push_back(searches[i]->outcome(given_up, budget));
      continue;
    }
    SideOutcome outcome;
    outcome.side = zone.side;
    outcome.sentence = zone.left_out() ? left_out_sentence(zone) : fmt::format("The {} side was not asked for.", to_string(zone.side));
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

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
  if (const SideOutcome* best = best_of(outcomes)) {
    return Planned{best->path, explain(problem, options_, *best, outcomes, task.zones.front().of), alternatives_of(task, outcomes, best)};
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
  failure.failure.reason += fmt::format("; the second choice {} found none either: {}", fallback_->name(), both.failure.reason);
  failure.failure.pose = both.failure.pose;
  if (both.failure.point) failure.failure.point = both.failure.point;
  failure.alternatives.insert(failure.alternatives.end(), both.alternatives.begin(), both.alternatives.end());
  return tl::unexpected{std::move(failure)};
}

}  // namespace waywright
