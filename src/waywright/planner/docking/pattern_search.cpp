#include "waywright/planner/docking/pattern_search.hpp"

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
constexpr double infeasible_costs = 100.0;  // graded costs from here on stand for what is not feasible

/// Where a path first comes nearer to something than it may, to 2 cm: for words, which the search has no time for.
struct FirstContact {
  double driven = 0.0;  ///< m
  std::optional<Contact> contact;
};
FirstContact first_contact(const Problem& problem, const Path& path) {
  for (const Sample& s : sample(path, problem.footprint().radius(), 0.01, 0.02)) {
    const Contact contact = problem.world().clearance(problem.footprint(), s.pose(), problem.required_clearance() + 0.01);
    if (contact.clearance < problem.required_clearance()) return {s.s, contact};
  }
  return {};
}

std::string infeasible_sentence(const Problem& problem, const SideOutcome& outcome, const CandidateScore& score,
                                std::int64_t evaluations) {
  std::string text = fmt::format("On the {} side no pattern fits: of {} candidates the best", to_string(outcome.side),
                                 evaluations);
  if (outcome.contact) {
    text += fmt::format(" came {:.1f} of {:.1f} m before it met {}", outcome.reach, score.measures.length, contact_words(problem, *outcome.contact));
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
      return evaluation_of(evaluator_, pattern_at(x), enough, [&](const PathMeasures& m) { return objective_value(options_, m, reference); });
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
  if (!score.free) {
    const FirstContact first = first_contact(problem, outcome.path);
    // The search wants a little more room than is required: then where that is missing.
    outcome.contact = first.contact ? first.contact : problem.world().clearance(problem.footprint(), score.blocked_at, 1.0);
    outcome.reach = first.contact ? first.driven : score.reach * score.measures.length;
  }
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

}  // namespace

double objective_value(const PatternDockingOptions& options, const PathMeasures& path, const PathMeasures& reference) {
  return options.objective == DockingObjective::normalised
             ? normalised_cost(path, reference, options.weights)
             : exponential_cost(path, reference, options.weights);
}

PathMeasures reference_measures(const PreparedDocking& prepared, const PatternLeads& leads) {
  const Problem& problem = prepared.problem();
  const DockingTask& task = prepared.task();
  CandidateEvaluator evaluator{prepared};
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

std::vector<SideOutcome> search_sides(const PreparedDocking& prepared, const PatternDockingOptions& options, const Optimizer& optimizer,
                                      std::uint64_t seed, bool second_choice, Budget& budget) {
  const DockingTask& task = prepared.task();
  CandidateEvaluator evaluator{prepared};
  const PathMeasures reference = reference_measures(prepared, options.leads);
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

}  // namespace waywright
