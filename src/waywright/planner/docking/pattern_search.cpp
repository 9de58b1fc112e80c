#include "waywright/planner/docking/pattern_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "waywright/planner/docking/side_search.hpp"

namespace waywright {
namespace {

// The publication's reference transition point in front of and beside the shelf, for its largest curvature of 0.8 1/m.
constexpr Vec2 published_reference{4.0, 3.5};
constexpr double published_curvature = 0.8;

constexpr std::array shares_of_work{0.3, 0.5, 0.75, 1.0};  // of the evaluations of a side: after each of them sides are compared
constexpr double by_far = 1.1;              // a side that costs more than this times the other one's best is given up
constexpr int steady = 128;                 // evaluations for which the best one stands before it is told of
constexpr double infeasible_costs = 100.0;  // graded costs from here on stand for what is not feasible

}  // namespace

/// The search on one side, which can be halted while it is seen which side deserves the work.
class PatternSearch::OneSide {
 public:
  OneSide(const PreparedDocking& prepared, const TransitionZone& zone, const PatternDockingOptions& options, const Optimizer& optimizer,
          const PathMeasures& reference, CandidateEvaluator& evaluator)
      : prepared_{prepared}, zone_{zone}, options_{options}, optimizer_{optimizer}, evaluator_{evaluator}, reference_{reference},
        space_{search_space(zone, options.heading_range)}, dock_{placement_of(prepared.problem().goal())},
        cost_{[this](std::span<const double> x, double enough) {
          const Evaluation e = evaluation_of(evaluator_, pattern_at(x), enough, [this](const PathMeasures& m) { return objective_value(options_, m, reference_); });
          if (watched_) watch(x, e);
          return e;
        }} {
    search_.population = options.population;
    search_.evaluations = options.evaluations * harder_times;
    resumable_ = optimizer.begin(space_, search_);
  }
  OneSide(const OneSide&) = delete;
  OneSide& operator=(const OneSide&) = delete;

  /// `told`: each time that this side's best stands for a while. It may be empty.
  void start_over(const PatternStart& start, std::int64_t evaluations, std::uint64_t seed, std::function<void(const OneSide&)> told) {
    watched_ = std::move(told);
    best_ = infeasible_costs;
    start_ = start;
    search_.evaluations = evaluations;
    search_.seed = seed;
    plain_ = {};
    if (resumable_) resumable_->start_over(search_);
  }
  void extend(std::int64_t evaluations) {
    search_.evaluations = evaluations;
    plain_ = {};
    if (resumable_) resumable_->extend(evaluations);
  }
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
  void tell(SideFound& found) const {
    const SearchResult& result = this->result();
    found.wanted = true;
    found.evaluations = result.evaluations;
    found.searched = !result.best.empty();
    if (found.searched) tell(result.best, result.cost, found);
  }
  double best_so_far() const { return best_; }
  void tell_so_far(SideFound& found) const {
    found.wanted = found.searched = true;
    tell(std::span{best_at_}.first(space_.dimension()), best_, found);
  }

 private:
  void tell(std::span<const double> x, double cost, SideFound& found) const {
    found.transition = transition_placement(prepared_.task(), zone_, x);
    found.pattern = pattern_at(x);
    found.score = evaluator_.evaluate(found.pattern);
    found.feasible = found.score.feasible();
    found.cost = cost;
  }
  void watch(std::span<const double> x, const Evaluation& e) {
    if (e.graded < best_) {
      best_ = e.graded;
      std::copy(x.begin(), x.end(), best_at_.begin());
      stood_ = 0;
    } else if (best_ < infeasible_costs && ++stood_ == steady) {
      watched_(*this);
    }
  }

  DockingPattern pattern_at(std::span<const double> x) const {
    return docking_pattern(start_, dock_, transition_placement(prepared_.task(), zone_, x), options_.leads);
  }

  const PreparedDocking& prepared_;
  const TransitionZone& zone_;
  const PatternDockingOptions& options_;
  const Optimizer& optimizer_;
  CandidateEvaluator& evaluator_;
  PathMeasures reference_;
  SearchOptions search_;
  SearchSpace space_;
  PatternStart start_;
  Placement dock_;
  CostFunction cost_;
  std::unique_ptr<ResumableSearch> resumable_;
  SearchResult plain_;
  std::function<void(const OneSide&)> watched_;
  double best_ = infeasible_costs;  // so far, while watched
  std::array<double, 3> best_at_{};
  int stood_ = 0;                   // evaluations
};

PatternSearch::PatternSearch(const PreparedDocking& prepared, const PatternDockingOptions& options, const Optimizer& optimizer)
    : prepared_{prepared}, options_{options}, evaluator_{prepared} {
  const PathMeasures reference = reference_measures(prepared, options.leads);
  for (const TransitionZone& zone : prepared.task().zones) {
    const bool wanted = !zone.left_out() && is_wanted(options.sides, zone.side);
    sides_.push_back(wanted ? std::make_unique<OneSide>(prepared, zone, options, optimizer, reference, evaluator_) : nullptr);
  }
  found_.resize(sides_.size());
}

PatternSearch::~PatternSearch() = default;

std::vector<SideFound>& PatternSearch::search(const PatternEntry& entry, std::int64_t evaluations, std::uint64_t seed, bool second_choice, Budget& budget) {
  const std::vector<TransitionZone>& zones = prepared_.task().zones;
  evaluator_.enter_with(entry.speed);
  SideShares shares{zones, options_.sides, evaluations, budget, second_choice};
  watched_ = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (!sides_[i]) continue;
    OneSide& side = *sides_[i];
    std::function<void(const OneSide&)> told;
    if (watch_) {
      told = [this, i](const OneSide& of) {
        if (!(of.best_so_far() < watched_)) return;
        SideFound found;
        of.tell_so_far(found);
        if (!found.feasible) return;
        watched_ = found.cost;
        watch_(i, found);
      };
    }
    side.start_over(entry.start, shares.next(), seed + (zones[i].side == Side::left ? 0 : 1), std::move(told));
  }
  return compare_sides(budget);
}

std::vector<SideFound>& PatternSearch::search_on(std::int64_t evaluations, Budget& budget) {
  for (const auto& side : sides_) {
    if (side) side->extend(evaluations);
  }
  return compare_sides(budget);
}

std::vector<SideFound>& PatternSearch::compare_sides(Budget& budget) {
  for (SideFound& found : found_) found = {};
  for (const double share : shares_of_work) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (!sides_[i] || found_[i].given_up) continue;
      sides_[i]->advance(share, budget);
      if (sides_[i]->is_feasible()) best = std::min(best, sides_[i]->result().cost);
    }
    if (!std::isfinite(best)) continue;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (sides_[i] && !(sides_[i]->is_feasible() && sides_[i]->result().cost <= by_far * best)) found_[i].given_up = true;
    }
  }
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (sides_[i]) sides_[i]->tell(found_[i]);
  }
  return found_;
}

SideFound* best_of(std::vector<SideFound>& found) {
  SideFound* best = nullptr;
  for (SideFound& side : found) {
    if (side.feasible && !side.refused && (best == nullptr || side.cost < best->cost)) best = &side;
  }
  return best;
}

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
  for (const TransitionZone& zone : task.zones) {
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

}  // namespace waywright
