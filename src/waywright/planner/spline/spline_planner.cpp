#include "waywright/planner/spline/spline_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/planner/spline/guide.hpp"
#include "waywright/planner/spline/spline_words.hpp"
#include "waywright/planner/waypoint/best_candidates.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

constexpr double unsolvable = 1e30;
constexpr std::int64_t searches = 5;  // of the published form: length, risk, turning, energy, and all together

/// One search after another with the same variables, the plainest candidate first in each.
class Search {
 public:
  Search(const SplineCandidates& candidates, const Optimizer& optimizer, int population, std::uint64_t seed, Budget& budget)
      : candidates_{candidates}, optimizer_{optimizer}, population_{population}, seed_{seed}, budget_{budget} {}

  /// Evaluates at most `evaluations` ≥ 1 candidates; how many it did.
  std::int64_t minimise(const std::function<Evaluation(std::span<const double>)>& cost, std::int64_t evaluations) {
    if (budget_.exhausted()) return 0;
    of_plainest = cost(candidates_.plainest());
    budget_.count_evaluations();
    SearchOptions search;
    search.evaluations = evaluations - 1;
    search.population = population_;
    search.seed = seed_++;
    if (search.evaluations < 1) return 1;
    return 1 + optimizer_.minimise([&](std::span<const double> x, double) { return cost(x); }, candidates_.space(), search, budget_).evaluations;
  }

  Evaluation of_plainest{};  ///< of the last search

 private:
  const SplineCandidates& candidates_;
  const Optimizer& optimizer_;
  int population_;
  std::uint64_t seed_;
  Budget& budget_;
};

double length_of(const std::vector<Vec2>& way) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) sum += distance(way[i], way[i + 1]);
  return sum;
}

Evaluation plain(double value) { return {value, 0.0, value}; }

/// Weights by the publication's normalisation, each extremum by a search of its own: what the best curve found has, without its penalty.
SplineWeights searched_weights(SplineCandidates& candidates, Search& search, std::int64_t evaluations, std::int64_t& looked) {
  const auto extremum_of = [&](double (*of)(const SplineMeasures&)) {
    double least = std::numeric_limits<double>::infinity(), extremum = 0.0;
    looked += search.minimise(
        [&](std::span<const double> x) {
          const auto curve = candidates.curve_at(x);
          if (!curve) return plain(unsolvable);
          const SplineMeasures m = candidates.measures_of(*curve);
          const double value = of(m) + collision_penalty * m.collisions;
          if (value < least) {
            least = value;
            extremum = of(m);
          }
          return plain(value);
        },
        evaluations);
    return extremum;
  };
  const double length = extremum_of([](const SplineMeasures& m) { return m.length; });
  const double risk = extremum_of([](const SplineMeasures& m) { return m.risk; });
  const double turning = extremum_of([](const SplineMeasures& m) { return m.turning; });
  const double energy = -extremum_of([](const SplineMeasures& m) { return -m.energy; });
  return normalised_weights(length, risk, 0.0, turning, energy);
}

}  // namespace

PlanningResult SplinePlanner::plan(const Problem& problem, Budget& budget) const {
  Guide guide;
  if (options_.space == ControlSpace::guide) guide = guide_for(problem, options_.wanted_clearance, budget);
  const bool is_guided = !guide.corners.empty();
  SplineCandidates candidates{problem, options_, guide.corners};
  const bool is_too_wide = candidates.space().dimension() > LatticeSearch::most_variables && dynamic_cast<const LatticeSearch*>(optimizer_.get()) != nullptr;
  Search search{candidates, is_too_wide ? *for_many_ : *optimizer_, options_.population, seed_, budget};
  const bool is_ours = options_.objective == SplineObjective::metres;
  std::int64_t evaluations = budget.limits().evaluations.value_or(options_.evaluations);
  std::int64_t looked = 0;

  SplineWeights weights = options_.curve == SplineForm::cubic ? SplineWeights{} : weights_of_ga;
  const bool normalises = !is_ours && options_.normalises && evaluations >= searches;
  if (normalises) {
    evaluations /= searches;
    weights = searched_weights(candidates, search, evaluations, looked);
    weights.time = std::min(100.0, problem.vehicle().limits.speed);  // L_min / T_min: both are least on the same curve
  }
  BestCandidates best;
  const std::int64_t before = looked;
  looked += search.minimise(
      [&](std::span<const double> x) {
        Evaluation e = plain(unsolvable);
        if (is_ours) e = candidates.in_metres(x);
        else if (const auto curve = candidates.curve_at(x)) e = plain(fitness_of(candidates.measures_of(*curve), weights));
        best.look(x, e);
        return e;
      },
      evaluations);
  const std::int64_t of_all = looked - before;

  const std::vector<BestCandidates::Candidate>& kept = best.kept();
  if (kept.empty() || !candidates.curve_at(kept.back().x)) return tl::unexpected{failure_without_curve(looked, budget)};

  // What the samples of the search did not see, the proof does. The publication's form shows what it chose, whatever that touches.
  std::size_t chosen = kept.size() - 1;
  if (is_ours) {
    ProofWorkspace proving{problem};
    ProofOptions proof;
    proof.cancel = budget.cancel_flag();
    for (std::size_t i = kept.size(); i-- > 0 && !(kept[i].evaluation.violation > 0.0);) {
      const auto curve = candidates.curve_at(kept[i].x);
      if (!curve || !prove(problem, problem.whole_path(path_of(problem, *curve)), proof, proving).holds()) continue;
      chosen = i;
      break;
    }
  }
  const std::size_t refused = kept.size() - 1 - chosen;
  const BestCandidates::Candidate& answer = kept[chosen];
  const SplineCurve curve = *candidates.curve_at(answer.x);
  if (is_ours && answer.evaluation.violation > 0.0) return tl::unexpected{failure_of(problem, options_, candidates, curve, looked, budget)};

  Planned planned;
  planned.path = path_of(problem, curve);
  const SplineCandidates::Parts parts = candidates.parts_of(curve);
  const std::vector<Vec2> points = candidates.control_points(answer.x);
  auto& text = planned.explanation;
  text.push_back(points_sentence(options_, points, answer.evaluation.objective, search.of_plainest, of_all, is_guided));
  if (is_guided) {
    const std::string disc = fmt::format("a disc of {:.3f} m, {}", guide.disc, guide.disc < problem.footprint().radius() ? "half the footprint's width" : "which holds the footprint");
    text.push_back(guide.corners.size() == 2 ? fmt::format("They were looked for about the straight line, which is free for {}.", disc)
                                             : fmt::format("They were looked for about a shortest way for {}: {:.3f} m in {} straight lines.", disc, length_of(guide.corners), guide.corners.size() - 1));
  } else if (options_.space == ControlSpace::guide) {
    text.push_back("They were looked for about the straight line: not even a disc of half the footprint's width was found a way.");
  }
  if (is_too_wide) text.push_back(fmt::format("lattice_search takes at most {} variables; with {} the publication's own optimizer searched in its place.", LatticeSearch::most_variables, candidates.space().dimension()));
  if (refused > 0) text.push_back(fmt::format("{} cost less, and the proof refused {}.", refused == 1 ? "1 candidate" : fmt::format("{} candidates", refused), refused == 1 ? "it" : "them"));
  if (is_ours) {
    text.push_back(parts_sentence(parts));
  } else {
    text.push_back(fitness_sentence(candidates.measures_of(curve), weights, options_.samples));
    text.push_back(normalises ? fmt::format("Its weights are by searches for the least length, risk and turning and the most energy left, {} curves in all.", before)
                              : "Its weights are the published ones.");
  }
  text.push_back(curve_sentence(problem, options_, curve, parts, candidates.ends()));
  planned.alternatives.push_back({"control points chosen", true, answer.evaluation.objective, curve_sentence(problem, options_, curve, parts, candidates.ends()), picture_of(problem, curve), {}});
  if (const auto plain_curve = candidates.curve_at(candidates.plainest())) {
    Alternative alternative{!is_guided ? "control points on the straight line" : "control points on the guide", false, std::nullopt, "What the search begins with.", picture_of(problem, *plain_curve), {}};
    if (!(search.of_plainest.violation > 0.0)) alternative.cost = search.of_plainest.objective;
    planned.alternatives.push_back(std::move(alternative));
  }
  return planned;
}

}  // namespace waywright
