#include "waywright/planner/docking/published_docking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "waywright/curve/bezier.hpp"
#include "waywright/planner/docking/side_search.hpp"

namespace waywright {
namespace {

constexpr double contact_knock_out = 1000.0;
constexpr Vec2 reference_point{4.0, 3.5};

/// Zones by the published rule: extent across the shelf against a threshold.
std::vector<TransitionZone> published_zones(const DockingTask& task, const Problem& problem, double least_side) {
  const auto* station = std::get_if<Station>(&problem.scenario().mission);
  std::vector<TransitionZone> zones = task.zones;
  if (station == nullptr) return zones;
  Ring area;
  for (const Vec2 p : station->area) area.push_back(task.frame.to_local(p));
  const double half = 0.5 * station->shelf.width;
  for (TransitionZone& zone : zones) {
    zone.polygons.clear();
    zone.width = 0.0;
    zone.needed = least_side;
    for (Ring& polygon : clip_beside(area, -half, half, zone.side)) {
      const Box box = bounding_box(polygon);
      const double extent = box.high.y - box.low.y;
      zone.width = std::max(zone.width, extent);
      if (extent >= least_side) zone.polygons.push_back(std::move(polygon));
    }
  }
  return zones;
}

}  // namespace

std::vector<Sample> published_samples(const std::array<Spline, 2>& splines, double segment) {
  std::vector<Sample> samples;
  double before = 0.0;
  for (std::size_t k = 0; k < splines.size(); ++k) {
    std::vector<ArcLengthTable> tables;
    double total = 0.0;
    for (const BezierSpan& span : splines[k].spans) {
      tables.emplace_back(span);
      total += tables.back().length();
    }
    const double steps = std::clamp(std::round(total / segment), 1.0, 100000.0);
    const auto count = static_cast<std::size_t>(steps);
    std::size_t span = 0;
    double behind = 0.0;
    for (std::size_t i = 0; i <= count; ++i) {
      const double s = total * static_cast<double>(i) / steps;
      while (span + 1 < tables.size() && s > behind + tables[span].length()) behind += tables[span++].length();
      const CurvePoint p = evaluate(splines[k].spans[span], i == count ? 1.0 : tables[span].parameter(s - behind));
      Sample sample;
      sample.s = before + s;
      sample.x = p.position.x;
      sample.y = p.position.y;
      sample.course = p.course;
      sample.heading = k == 0 ? wrap(p.course + pi) : p.course;
      sample.curvature = p.curvature;
      sample.curvature_rate = p.curvature_rate;
      sample.direction = k == 0 ? -1 : 1;
      sample.piece = k;
      samples.push_back(sample);
    }
    before += total;
  }
  return samples;
}

PublishedScore published_evaluation(const Problem& problem, const std::vector<Sample>& samples,
                                    const PathMeasures& reference, const PublishedDockingOptions& options) {
  PublishedScore score;
  score.measures = measure_samples(samples);
  score.within_curvature = score.measures.max_curvature <= problem.vehicle().max_curvature();
  const auto cost_of = [&](const PathMeasures& judged) {
    const double cost = options.objective == DockingObjective::normalised ? normalised_cost(judged, reference, options.weights)
                                                                          : exponential_cost(judged, reference, options.weights);
    return cost < contact_knock_out ? cost : contact_knock_out * (1.0 - 1e-6);
  };
  score.objective = cost_of(score.measures);
  if (!score.within_curvature) score.violation = score.measures.max_curvature / problem.vehicle().max_curvature() - 1.0;
  const Footprint& footprint = problem.footprint();
  for (const Sample& sample : samples) {
    if (problem.world().is_free(footprint, sample.pose(), problem.scenario().clearance)) continue;
    if (++score.hits == 1) {
      score.contact = problem.world().clearance(footprint, sample.pose(), problem.scenario().clearance + 1e-3);
    }
  }
  if (score.hits > 0) {
    const double share = static_cast<double>(score.hits) / static_cast<double>(samples.size());
    score.violation += share;
    score.cost = contact_knock_out + share;
    return score;
  }
  PathMeasures judged = score.measures;
  if (!score.within_curvature) judged.curvature_change *= options.curvature_factor;
  score.cost = cost_of(judged);
  return score;
}

PathMeasures published_reference(const Problem& problem, const DockingTask& task, Side side, double segment) {
  const double sign = side == Side::left ? 1.0 : -1.0;
  const Pose transition = task.frame.to_world(
      make_pose({reference_point.x, sign * reference_point.y}, transition_heading(side, task.dock.heading)));
  return measure_samples(published_samples(published_pattern(problem.start(), problem.goal(), transition), segment));
}

PublishedDockingPlanner::PublishedDockingPlanner(PublishedDockingOptions options, std::shared_ptr<const Optimizer> optimizer,
                                                 std::uint64_t seed)
    : options_{options}, optimizer_{std::move(optimizer)}, seed_{seed} {}

PlanningResult PublishedDockingPlanner::plan(const Problem& problem, Budget& budget) const {
  DockingTask task = partition(problem);
  task.zones = published_zones(task, problem, options_.least_side);
  SideShares shares{task.zones, options_.sides, options_.evaluations, budget, false};
  SearchOptions search;
  search.population = options_.population;

  std::vector<SideOutcome> outcomes;
  for (const TransitionZone& zone : task.zones) {
    SideOutcome outcome;
    outcome.side = zone.side;
    if (zone.left_out()) {
      outcome.sentence = fmt::format("The {} side is {:.3f} m across, under the {:.3f} m asked for.", to_string(zone.side),
                                     zone.width, zone.needed);
      outcomes.push_back(std::move(outcome));
      continue;
    }
    if (!is_wanted(options_.sides, zone.side)) {
      outcome.sentence = fmt::format("The {} side was not asked for.", to_string(zone.side));
      outcomes.push_back(std::move(outcome));
      continue;
    }
    const PathMeasures reference = published_reference(problem, task, zone.side, options_.segment);
    const auto splines_at = [&](std::span<const double> x) {
      return published_pattern(problem.start(), problem.goal(), transition_pose(task, zone, x));
    };
    search.seed = seed_ + (zone.side == Side::left ? 0 : 1);
    search.evaluations = shares.next();
    const SearchResult result = optimizer_->minimise(
        [&](std::span<const double> x, double) {
          const PublishedScore score =
              published_evaluation(problem, published_samples(splines_at(x), options_.segment), reference, options_);
          return Evaluation{score.objective, score.violation, score.cost};
        },
        search_space(zone, 0.0), search, budget);
    outcome.searched = !result.best.empty();
    if (outcome.searched) {
      const auto splines = splines_at(result.best);
      const PublishedScore score =
          published_evaluation(problem, published_samples(splines, options_.segment), reference, options_);
      outcome.path = pattern_path(splines);
      outcome.transition = transition_pose(task, zone, result.best);
      outcome.feasible = score.feasible();
      outcome.cost = result.cost;
      outcome.contact = score.contact;
      outcome.sentence = fmt::format("On the {} side the best of {} candidates costs {:.4f}: {:.2f} m, Σ|Δκ| {:.3f} 1/m, {}.",
                                     to_string(zone.side), result.evaluations, result.cost, score.measures.length,
                                     score.measures.curvature_change,
                                     score.hits > 0 ? fmt::format("{} sampled poses touch something", score.hits)
                                     : score.within_curvature ? "no sampled pose touches anything"
                                                              : "its curvature is over the limit");
    } else {
      outcome.sentence = not_searched_sentence(zone.side, budget);
    }
    outcomes.push_back(std::move(outcome));
  }

  if (const SideOutcome* best = best_of(outcomes)) {
    std::vector<std::string> text{
        fmt::format("The published pattern on the {} side: natural cubic splines through the transition point ({:.3f}, {:.3f}); "
                    "collision was tested at samples only, and the headings at the ends are not met exactly.",
                    to_string(best->side), best->transition.x, best->transition.y)};
    for (const SideOutcome& outcome : outcomes) text.push_back(outcome.sentence);
    return Planned{best->path, std::move(text), alternatives_of(task, outcomes, best)};
  }
  PlanningFailure failure;
  failure.failure.status = budget.canceled() ? Status::canceled : budget.cut_short() ? Status::timed_out : Status::no_path;
  failure.failure.reason = "no published docking pattern fits.";
  for (const SideOutcome& outcome : outcomes) {
    failure.failure.reason += " " + outcome.sentence;
    failure.explanation.push_back(outcome.sentence);
    if (outcome.contact) failure.failure.point = outcome.contact->point;
  }
  failure.alternatives = alternatives_of(task, outcomes, nullptr);
  return tl::unexpected{std::move(failure)};
}

}  // namespace waywright
