#include "waywright/planner/waypoint/waypoint_clothoid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/planner/waypoint/best_candidates.hpp"
#include "waywright/planner/waypoint/waypoint_words.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
std::string meaning_of(WaypointObjective objective) {
  switch (objective) {
    case WaypointObjective::mlpc: return "least length, a thousandfold on contact";
    case WaypointObjective::mlmc: return "least length, times the poses in contact";
    case WaypointObjective::mdobs: return "greatest least distance";
    case WaypointObjective::avgmd: return "greatest mean distance";
    case WaypointObjective::pwavg: return "least depth in obstacles, then greatest mean distance";
    case WaypointObjective::levels: return "fewest poses within two safety distances";
    case WaypointObjective::pwavg_margin: return "greatest mean distance with the margin kept everywhere";
    case WaypointObjective::metres: return "length, nearness and bends, in metres";
  }
  return {};
}

PlanningResult WaypointClothoidPlanner::plan(const Problem& problem, Budget& budget) const {
  if (auto failure = blocked_waypoint(problem); failure && !budget.exhausted()) return tl::unexpected{std::move(*failure)};
  WaypointCandidates candidates{problem, options_};
  const SearchSpace& space = candidates.space();
  BestCandidates best;
  const auto cost = [&](std::span<const double> x, double) {
    const Evaluation e = candidates.evaluate(x);
    best.look(x, e);
    return e;
  };
  // The courses halfway between those to and from each waypoint come first: what is searched has to be better.
  std::vector<double> middle;
  for (std::size_t i = 0; i < space.dimension(); ++i) middle.push_back(0.5 * (space.low[i] + space.high[i]));
  Evaluation of_middle{};
  std::int64_t looked = 0;
  if (!budget.exhausted()) {
    of_middle = cost(middle, std::numeric_limits<double>::infinity());
    budget.count_evaluations();
    looked = 1;
  }
  SearchOptions search;
  search.evaluations = budget.limits().evaluations.value_or(options_.evaluations) - looked;
  search.population = options_.population;
  search.seed = seed_;
  const bool is_too_wide = space.dimension() > LatticeSearch::most_variables && dynamic_cast<const LatticeSearch*>(optimizer_.get()) != nullptr;
  const Optimizer& optimizer = is_too_wide ? *for_many_ : *optimizer_;
  if (looked > 0 && space.dimension() > 0 && search.evaluations > 0) looked += optimizer.minimise(cost, space, search, budget).evaluations;

  const std::vector<BestCandidates::Candidate>& kept = best.kept();
  if (kept.empty() || !candidates.chain_at(kept.back().x)) {
    std::size_t unsolved = 0;
    const bool is_known = looked > 0 && !candidates.chain_at(middle, &unsolved);
    return tl::unexpected{failure_without_chain(problem, looked, is_known ? std::optional{unsolved} : std::nullopt, budget)};
  }

  // What the samples of the search did not see, the proof does. Where it confirms no candidate's margin, the one with most clearance is taken.
  std::size_t chosen = kept.size() - 1;
  if (options_.objective == WaypointObjective::metres || options_.objective == WaypointObjective::pwavg_margin) {
    const double wanted = problem.required_clearance() + (options_.objective == WaypointObjective::pwavg_margin ? options_.margin : 0.0);
    ProofWorkspace proving{problem};
    ProofOptions proof;
    proof.cancel = budget.cancel_flag();
    double most = -1.0;
    for (std::size_t i = kept.size(); i-- > 0 && most < wanted && !(kept[i].evaluation.violation > 0.0);) {
      const auto chain = candidates.chain_at(kept[i].x);
      if (!chain) continue;
      const Proof proven = prove(problem, problem.whole_path(path_of(*chain)), proof, proving);
      const double clearance = proven.certificate.clearance + proven.certificate.tolerance;  // it may be so much
      if (!proven.holds() || clearance <= most) continue;
      most = clearance;
      chosen = i;
    }
  }
  const std::size_t refused = kept.size() - 1 - chosen;

  const BestCandidates::Candidate& answer = kept[chosen];
  const Clothoids chain = *candidates.chain_at(answer.x);
  // The publication's functions weigh contact against other things, and show what they chose. Ours asks for a path that can be driven.
  if (options_.objective == WaypointObjective::metres && answer.evaluation.violation > 0.0) {
    return tl::unexpected{failure_of(problem, candidates, chain, looked, budget)};
  }
  Planned planned;
  planned.path = path_of(chain);
  const std::size_t waypoints = problem.scenario().waypoints.size();
  planned.explanation.push_back(courses_sentence(problem, options_.objective, answer.x, answer.evaluation, of_middle, looked));
  if (is_too_wide) planned.explanation.push_back(fmt::format("lattice_search takes at most {} variables; with {} differential evolution searched in its place.", LatticeSearch::most_variables, space.dimension()));
  if (refused > 0) {
    const std::string those = counted(static_cast<std::int64_t>(refused), "candidate");
    const char* them = refused == 1 ? "it" : "them";
    planned.explanation.push_back(options_.objective == WaypointObjective::pwavg_margin
                                      ? fmt::format("{} cost less, and the proof does not confirm the margin of {:.4g} m for {}.", those, options_.margin, them)
                                      : fmt::format("{} cost less, and the proof refused {}.", those, them));
  }
  planned.explanation.push_back(limits_sentence(problem, chain, options_.continuity));
  planned.explanation.push_back(measures_sentence(candidates.measures_of(chain, FitnessForm::published, false)));
  planned.alternatives.push_back({"courses chosen", true, answer.evaluation.objective, limits_sentence(problem, chain, options_.continuity), picture_of(chain), {}});
  if (waypoints > 0) {
    if (const auto plain = candidates.chain_at(middle)) {
      const bool is_feasible = !(of_middle.violation > 0.0);
      const std::string outcome = is_feasible ? "What the search begins with." : "What the search begins with: it " + refusal_of(problem, candidates, *plain).why + ".";
      Alternative alternative{"courses halfway", false, std::nullopt, outcome, picture_of(*plain), {}};
      if (is_feasible) alternative.cost = of_middle.objective;
      planned.alternatives.push_back(std::move(alternative));
    }
  }
  return planned;
}

}  // namespace waywright
