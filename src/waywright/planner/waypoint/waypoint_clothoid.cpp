#include "waywright/planner/waypoint/waypoint_clothoid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/planner/waypoint/candidates.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

constexpr std::size_t most_kept = 16;  // of the best candidates, for the proof
constexpr double degrees = 180.0 / pi;

struct Candidate {
  std::vector<double> x;
  Evaluation evaluation;
};

/// The best candidates seen, best last.
class Best {
 public:
  void look(std::span<const double> x, const Evaluation& evaluation) {
    if (!kept_.empty() && !(evaluation.graded < kept_.back().evaluation.graded)) return;
    if (kept_.size() == most_kept) kept_.erase(kept_.begin());
    kept_.push_back({{x.begin(), x.end()}, evaluation});
  }
  const std::vector<Candidate>& kept() const { return kept_; }

 private:
  std::vector<Candidate> kept_;
};

std::string courses_of(const Problem& problem, std::span<const double> x) {
  std::string text;
  for (std::size_t i = 0; i < problem.scenario().waypoints.size(); ++i) text += fmt::format("{}{:.1f}°", i == 0 ? "" : ", ", wrap(x[i]) * degrees);
  return text;
}

std::string counted(std::int64_t n, const char* one) { return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s"); }

std::string limits_sentence(const Problem& problem, const Clothoids& chain, Continuity continuity) {
  std::string text = continuity == Continuity::g2
                         ? fmt::format("Each leg is three clothoids: curvature goes on without jumps, at most {:.4f} 1/m", greatest_curvature(chain))
                         : fmt::format("Each leg is one clothoid: curvature jumps at waypoints; it is at most {:.4f} 1/m", greatest_curvature(chain));
  if (const double limit = problem.vehicle().max_curvature(); std::isfinite(limit)) text += fmt::format(" (the vehicle can {:.4f})", limit);
  text += fmt::format(", its rate at most {:.4f} 1/m²", greatest_curvature_rate(chain));
  if (const auto& rate = problem.vehicle().limits.curvature_rate) text += fmt::format(" (limit {:.4f})", *rate);
  return text + ".";
}

std::string measures_sentence(const TrajectoryMeasures& m) {
  return fmt::format("At {} poses of equal distance the footprint's corners are {:.3f} m from obstacles in the mean and {:.3f} m at least; {} in contact.",
                     m.distance.size(), mean_distance(m), least_distance(m), counted(poses_in_contact(m), "pose") + (poses_in_contact(m) == 1 ? " is" : " are"));
}

std::vector<Pose> picture_of(const Clothoids& chain) {
  std::vector<Pose> poses;
  sample_evenly(chain, std::clamp<std::size_t>(static_cast<std::size_t>(length_of(chain) / 0.12), 2, 1000), poses);
  return poses;
}

/// Does the body cover the point that follows the path?
bool contains_origin(const Footprint& footprint) { return footprint.is_disc() || contains(footprint.polygon, Vec2{}); }

/// Why the best candidate cannot be driven.
PlanningFailure failure_of(const Problem& problem, WaypointCandidates& candidates, const Clothoids& chain, std::int64_t looked, const Budget& budget) {
  PlanningFailure failure;
  failure.failure.status = budget.canceled() ? Status::canceled : budget.cut_short() ? Status::timed_out : Status::no_path;
  std::string why;
  const WaypointCandidates::Tightest tightest = candidates.tightest_of(chain);
  if (!candidates.is_beyond_limits(chain)) {
    const std::string obstacle = problem.world().source_name(tightest.contact.source);
    why = tightest.contact.clearance >= problem.required_clearance() && tightest.contact.clearance > 0.0
              ? fmt::format("comes too near to something between the poses looked at, near {} at ({:.3f}, {:.3f})", obstacle, tightest.contact.point.x, tightest.contact.point.y)
          : tightest.contact.clearance > 0.0
              ? fmt::format("comes as near as {:.4f} m to {} at ({:.3f}, {:.3f}), and {:.4f} m are required", tightest.contact.clearance, obstacle, tightest.contact.point.x,
                            tightest.contact.point.y, problem.required_clearance())
              : fmt::format("touches {} at ({:.3f}, {:.3f})", obstacle, tightest.contact.point.x, tightest.contact.point.y);
    failure.failure.pose = tightest.pose;
    failure.failure.point = tightest.contact.point;
  } else {
    why = fmt::format("bends with {:.4f} 1/m, changing by {:.4f} 1/m² at most, which the vehicle cannot", greatest_curvature(chain), greatest_curvature_rate(chain));
  }
  failure.failure.reason = fmt::format("of {} through the waypoints none can be driven; the best one {}", counted(looked, "chain") + " of clothoids", why);
  failure.explanation.push_back(limits_sentence(problem, chain, candidates.options().continuity));
  failure.alternatives.push_back({"best candidate", false, std::nullopt, "It " + why + ".", picture_of(chain), {}});
  return failure;
}


/// A waypoint that has to be met where nothing can be: no search would help.
std::optional<PlanningFailure> blocked_waypoint(const Problem& problem) {
  const Scenario& scenario = problem.scenario();
  if (scenario.waypoint_radius > 0.0) return std::nullopt;
  for (std::size_t i = 0; i < scenario.waypoints.size(); ++i) {
    const Vec2 at = scenario.waypoints[i];
    const Contact contact = problem.world().clearance(std::span{&at, 1}, 0.0, 1e-9);
    const bool is_covered = contains_origin(problem.footprint());
    if (contact.clearance > 0.0 || !is_covered) continue;
    PlanningFailure failure;
    failure.failure = {Status::no_path,
                       fmt::format("waypoint {} at ({:.3f}, {:.3f}) is {} {}", i + 1, at.x, at.y, contact.outside ? "outside" : "in", problem.world().source_name(contact.source)),
                       make_pose(at, 0.0), at};
    return failure;
  }
  return std::nullopt;
}

}  // namespace

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
  Best best;
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

  const std::vector<Candidate>& kept = best.kept();
  if (kept.empty() || !candidates.chain_at(kept.back().x)) {
    PlanningFailure failure;
    failure.failure.status = budget.canceled() ? Status::canceled : budget.cut_short() ? Status::timed_out : Status::no_path;
    failure.failure.reason = kept.empty() ? "the search was ended before it looked at a candidate"
                                          : fmt::format("none of {} has a chain of clothoids from waypoint to waypoint", counted(looked, "candidate"));
    return tl::unexpected{std::move(failure)};
  }

  // What the samples of the search did not see, the proof does.
  std::size_t chosen = kept.size() - 1;
  std::size_t refused = 0;
  if (options_.objective == WaypointObjective::metres || options_.objective == WaypointObjective::pwavg_margin) {
    ProofWorkspace proving{problem};
    ProofOptions proof;
    proof.cancel = budget.cancel_flag();
    for (std::size_t i = kept.size(); i-- > 0 && !(kept[i].evaluation.violation > 0.0);) {
      const auto chain = candidates.chain_at(kept[i].x);
      if (chain && prove(problem, problem.whole_path(path_of(*chain)), proof, proving).holds()) {
        chosen = i;
        refused = kept.size() - 1 - i;
        break;
      }
    }
  }

  const Candidate& answer = kept[chosen];
  const Clothoids chain = *candidates.chain_at(answer.x);
  // The publication's functions weigh contact against other things, and show what they chose. Ours asks for a path that can be driven.
  if (options_.objective == WaypointObjective::metres && answer.evaluation.violation > 0.0) {
    return tl::unexpected{failure_of(problem, candidates, chain, looked, budget)};
  }
  Planned planned;
  planned.path = path_of(chain);
  const std::size_t waypoints = problem.scenario().waypoints.size();
  const std::string value = fmt::format("{:.6g}", answer.evaluation.objective);
  if (waypoints > 0) {
    planned.explanation.push_back(fmt::format("Of {}, these courses at the waypoints are best: {}. Objective {}: {}; it is {} here, and {} with the courses halfway "
                                              "between those to and from each waypoint.",
                                              counted(looked, "candidate"), courses_of(problem, answer.x), to_string(options_.objective), meaning_of(options_.objective), value,
                                              of_middle.violation > 0.0 ? "not feasible" : fmt::format("{:.6g}", of_middle.objective)));
  } else {
    planned.explanation.push_back("There are no waypoints to choose courses at: start and goal alone decide the path.");
  }
  if (is_too_wide) planned.explanation.push_back(fmt::format("lattice_search takes at most {} variables; with {} differential evolution searched in its place.", LatticeSearch::most_variables, space.dimension()));
  if (refused > 0) planned.explanation.push_back(fmt::format("{} cost less, and the proof refused {}.", counted(static_cast<std::int64_t>(refused), "candidate"), refused == 1 ? "it" : "them"));
  planned.explanation.push_back(limits_sentence(problem, chain, options_.continuity));
  planned.explanation.push_back(measures_sentence(candidates.measures_of(chain, FitnessForm::published, false)));
  planned.alternatives.push_back({"courses chosen", true, answer.evaluation.objective, limits_sentence(problem, chain, options_.continuity), picture_of(chain), {}});
  if (waypoints > 0) {
    if (const auto plain = candidates.chain_at(middle)) {
      Alternative alternative{"courses halfway", false, std::nullopt, "The courses halfway between those to and from each waypoint.", picture_of(*plain), {}};
      if (!(of_middle.violation > 0.0)) alternative.cost = of_middle.objective;
      planned.alternatives.push_back(std::move(alternative));
    }
  }
  return planned;
}

}  // namespace waywright
