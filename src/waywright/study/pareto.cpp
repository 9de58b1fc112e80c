#include "waywright/study/pareto.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "waywright/judge/judge.hpp"
#include "waywright/optimizer/pagmo/front.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/solve_words.hpp"
#include "waywright/planner/waypoint/candidates.hpp"
#include "waywright/planner/waypoint/describe.hpp"
#include "waywright/planner/waypoint/waypoint_words.hpp"
#include "waywright/study/front_folder.hpp"

namespace waywright {
namespace {

using Figures = std::array<double, 3>;  // length, −clearance, greatest curvature

Figures figures_of(const Plan& plan) { return {plan.metrics.length, -plan.certificate.clearance, plan.metrics.max_curvature}; }

bool is_no_better(const Figures& a, const Figures& b) {
  return a[0] >= b[0] && a[1] >= b[1] && a[2] >= b[2];
}

/// At most `count` points that are spread over the front: the ends of each objective, then whatever is farthest from those taken.
std::vector<std::size_t> spread(const std::vector<FrontPoint>& front, std::size_t count) {
  Figures low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const FrontPoint& p : front) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p.objectives[k]);
      high[k] = std::max(high[k], p.objectives[k]);
    }
  }
  const auto apart = [&](std::size_t a, std::size_t b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double range = high[k] - low[k];
      if (range > 0.0) sum += (front[a].objectives[k] - front[b].objectives[k]) / range * (front[a].objectives[k] - front[b].objectives[k]) / range;
    }
    return sum;
  };
  std::vector<std::size_t> taken;
  for (std::size_t k = 0; k < 3 && taken.size() < std::min(count, front.size()); ++k) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < front.size(); ++i) {
      if (front[i].objectives[k] < front[best].objectives[k]) best = i;
    }
    if (std::find(taken.begin(), taken.end(), best) == taken.end()) taken.push_back(best);
  }
  while (taken.size() < std::min(count, front.size())) {
    std::size_t farthest = 0;
    double most = -1.0;
    for (std::size_t i = 0; i < front.size(); ++i) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const std::size_t t : taken) nearest = std::min(nearest, apart(i, t));
      if (nearest > most) {
        most = nearest;
        farthest = i;
      }
    }
    if (!(most > 0.0)) break;
    taken.push_back(farthest);
  }
  std::sort(taken.begin(), taken.end());
  return taken;
}

}  // namespace

Parsed<void> check_pareto(const Scenario& scenario) {
  if (scenario.planner.name == "waypoint_clothoid") return {};
  return tl::unexpected{InputError{"", "planner.name", fmt::format("{} has no candidates to trade against each other", scenario.planner.name), "waypoint_clothoid"}};
}

Parsed<Front> pareto(const Problem& problem, const ParetoOptions& options) {
  const Scenario& scenario = problem.scenario();
  if (auto can = check_pareto(scenario); !can) return tl::unexpected{can.error()};
  auto parameters = complete_parameters(scenario.planner);
  if (!parameters) return tl::unexpected{parameters.error()};
  for (const char* unused : {"objective", "form", "optimizer", "samples", "margin", "clearance_weight", "bend_weight"}) {
    if (scenario.planner.parameters.contains(unused)) {
      return tl::unexpected{InputError{"", fmt::format("planner.{}", unused), "it has no part in trading length, clearance and curvature against each other", "no such parameter"}};
    }
  }
  const WaypointOptions waypoint = waypoint_options(*parameters);
  Front front;
  Budget budget{scenario.budget, options.cancel};
  WaypointCandidates candidates{problem, waypoint};
  SearchOptions search;
  const bool names_evaluations = scenario.planner.parameters.contains("evaluations");
  search.evaluations = scenario.budget.evaluations.value_or(names_evaluations ? waypoint.evaluations : options.evaluations);
  search.population = scenario.planner.parameters.contains("population") ? waypoint.population : options.population;
  search.seed = scenario.seed;
  if (auto failure = blocked_waypoint(problem)) {
    front.reason = std::move(failure->failure.reason);
    return front;
  }
  std::vector<double> nearest;  // to feasible
  double least = std::numeric_limits<double>::infinity();
  const std::vector<FrontPoint> found = search_front(
      [&](std::span<const double> x) {
        const WaypointCandidates::Figures f = candidates.figures_at(x);
        if (f.violation < least) {
          least = f.violation;
          nearest.assign(x.begin(), x.end());
        }
        return TradeOff{{f.length, -f.clearance, f.curvature}, f.violation};
      },
      candidates.space(), search, budget);
  front.evaluations = budget.evaluations();
  front.found = found.size();
  for (const std::size_t i : spread(found, options.points)) {
    const auto chain = candidates.chain_at(found[i].x);
    if (!chain) continue;
    Plan plan = judge(problem, problem.whole_path(path_of(*chain)), options.cancel);
    if (budget.canceled()) break;
    if (plan.status != Status::solved) {
      if (front.refused++ == 0) front.reason = fmt::format("the proof refused what the search found, first of it: {}", plan.reason);
      continue;
    }
    plan.planner = scenario.planner.name;
    plan.parameters = *parameters;
    plan.effort.evaluations = front.evaluations;
    plan.reproducible = !budget.canceled() && !budget.cut_short();
    front.plans.push_back(std::move(plan));
  }
  front.is_cut_short = budget.canceled() || budget.cut_short();
  std::stable_sort(front.plans.begin(), front.plans.end(), [](const Plan& a, const Plan& b) { return figures_of(a) < figures_of(b); });
  // What was proven differs a little from what the search saw.
  std::vector<Plan> best;
  for (Plan& plan : front.plans) {
    const bool is_beaten = std::any_of(best.begin(), best.end(), [&](const Plan& other) { return is_no_better(figures_of(plan), figures_of(other)); });
    if (!is_beaten) best.push_back(std::move(plan));
  }
  front.plans = std::move(best);
  if (!front.plans.empty()) {
    front.reason.clear();
  } else if (front.reason.empty()) {
    const auto chain = std::isfinite(least) ? candidates.chain_at(nearest) : std::nullopt;
    front.reason = found.empty() && chain ? failure_of(problem, candidates, *chain, front.evaluations, budget).failure.reason
                   : found.empty()        ? failure_without_chain(problem, front.evaluations, std::nullopt, budget).failure.reason
                                          : "the search was ended before the proof had looked at what it found";
  }
  for (std::size_t i = 0; i < front.plans.size(); ++i) {
    Plan& plan = front.plans[i];
    plan.explanation = {front.plans.size() == 1 ? "The only trade-off between length, clearance and curvature that was found and proven."
                                                : fmt::format("One of {} trade-offs between length, clearance and curvature, number {} by length; none of the others is better in all three.",
                                                              front.plans.size(), i + 1),
                        proof_sentence(problem, plan)};
  }
  return front;
}

std::string front_text(const Front& front) {
  if (front.plans.empty()) return fmt::format("  none: {}\n", front.reason);
  std::string text = "  no    length m   clearance m   curvature 1/m   Σ|Δκ| 1/m    time s\n";
  for (std::size_t i = 0; i < front.plans.size(); ++i) {
    const Plan& p = front.plans[i];
    text += fmt::format("  {:2} {:11.3f} {:13.4f} {:15.4f} {:11.3f} {:9.2f}\n", i + 1, p.metrics.length, p.certificate.clearance, p.metrics.max_curvature, p.metrics.curvature_change,
                        p.metrics.travel_time);
  }
  return text;
}

std::string front_csv(const Front& front) {
  std::string csv = "number,length,clearance,mean_clearance,max_curvature,max_curvature_rate,curvature_change,travel_time,plan\n";
  for (std::size_t i = 0; i < front.plans.size(); ++i) {
    const Plan& p = front.plans[i];
    csv += fmt::format("{},{},{},{},{},{},{},{},{}/plan.json\n", i + 1, p.metrics.length, p.certificate.clearance, p.metrics.mean_clearance, p.metrics.max_curvature,
                       p.metrics.max_curvature_rate, p.metrics.curvature_change, p.metrics.travel_time, front_plan_folder(i));
  }
  return csv;
}

}  // namespace waywright
