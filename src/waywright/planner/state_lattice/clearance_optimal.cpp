#include "waywright/planner/state_lattice/clearance_optimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/state_lattice/lattice_search.hpp"
#include "waywright/planner/state_lattice/smoothing.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {

using grid::counted, grid::failure;

namespace {

/// As near as the proof takes two poses for one.
bool is_same_pose(const Pose& a, const Pose& b) {
  const ProofOptions proof;
  return distance(a.position(), b.position()) <= proof.position_tolerance && std::abs(shorter_turn(a.heading, b.heading)) <= proof.heading_tolerance;
}

/// "2.31 % less than".
std::string against(double cost, double bound) {
  if (!(bound > 0.0)) return fmt::format("{:.4f} m more than", cost - bound);
  return fmt::format("{:.2f} % {} than", 100.0 * std::abs(cost / bound - 1.0), cost <= bound ? "less" : "more");
}

}  // namespace

class ClearanceOptimalPlanner::Ready {
 public:
  Ready(const Problem& problem, const ClearanceOptimalOptions& options) : problem_{problem}, graph_{problem, options.lattice} {
    if (graph_.refused().empty()) rest_.emplace(graph_, graph_.options().costs, std::min(1.0, problem.zones_as_planned().least_factor()));
  }
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  bool is_for(const Problem& problem) const { return &problem == &problem_; }

  PlanningResult plan(const ClearanceOptimalOptions& options, Budget& budget) const {
    if (!graph_.refused().empty()) return tl::unexpected{failure(Status::no_path, graph_.refused())};
    if (budget.exhausted()) {
      return tl::unexpected{budget.canceled() ? failure(Status::canceled, "canceled before the search began") : failure(Status::timed_out, "the time was over before the search began")};
    }
    if (is_same_pose(problem_.start(), problem_.goal())) return tl::unexpected{failure(Status::no_path, "start and goal are the same pose, there is nothing to drive")};
    budget.count_evaluations();
    if (graph_.is_cut_off()) return tl::unexpected{failure(Status::no_path, "nothing leads from start to goal even for the largest disc in the footprint; known without a search")};
    if (graph_.goal_motions().empty()) {
      return tl::unexpected{failure(Status::no_path, fmt::format("no motion within the vehicle's limits leads from the lattice (cells of {:g} m, {} headings) into the goal", graph_.cell(), lattice_headings),
                                    problem_.goal())};
    }
    if (rest_->is_cut_off()) {
      return tl::unexpected{failure(Status::no_path, fmt::format("no chain of the lattice's motions leads from start to goal even for the largest disc in the footprint (cells of {:g} m); a finer resolution or ompl_rrt_connect may find a way",
                                                                 graph_.cell()))};
    }
    MotionCost cost{problem_, graph_.options().costs, graph_.margin()};
    const LatticeAnswer answer = search_lattice(graph_, *rest_, cost, options.gap, budget);
    budget.count_expansions(answer.expansions);
    if (answer.ended != LatticeAnswer::End::found) return tl::unexpected{nothing(answer, budget)};
    return explained(options, answer, cost, budget);
  }

 private:
  PlanningFailure nothing(const LatticeAnswer& answer, const Budget& budget) const {
    using End = LatticeAnswer::End;
    const std::string so_far = fmt::format("after {}; any way over the lattice costs at least {:.3f} m", counted(answer.expansions, "expansion"), answer.lower_bound);
    if (answer.ended == End::canceled) return failure(Status::canceled, "canceled " + so_far);
    if (answer.ended == End::timed_out) return failure(Status::timed_out, fmt::format("the {:g} s were over {}", budget.limits().seconds.value_or(0.0), so_far));
    if (answer.ended == End::too_many) return failure(Status::timed_out, "too many motions wait to be looked at " + so_far + "; a coarser resolution or a gap needs fewer");
    if (answer.ended == End::out_of_budget) return failure(Status::timed_out, fmt::format("the budget was used up {}", so_far));
    return failure(Status::no_path, fmt::format("{} that the footprint can reach in cells of {:g} m and {} headings {} searched, and none leads into the goal; a finer resolution or ompl_rrt_connect may find a way",
                                                counted(answer.expansions, "state"), graph_.cell(), lattice_headings, answer.expansions == 1 ? "was" : "were"));
  }

  PlanningResult explained(const ClearanceOptimalOptions& options, const LatticeAnswer& answer, MotionCost& cost, Budget& budget) const {
    Planned planned;
    double of_lattice = cost_of(answer.stretches, cost);
    if (!std::isfinite(of_lattice)) of_lattice = answer.cost;  // finer steps see a zone's edge that its own did not
    Smoothed way{answer.stretches, of_lattice, 0};
    if (options.smooth) way = smoothed(answer.stretches, cost, graph_.limits(), budget);
    if (!std::isfinite(way.cost)) way.cost = of_lattice;
    planned.path = path_of(way.stretches);
    const DangerCosts& c = graph_.options().costs;
    const double metres = length(planned.path), straight = distance(problem_.start().position(), problem_.goal().position());
    std::vector<std::string>& text = planned.explanation;
    text.push_back(fmt::format("A metre costs 1 + {:g}·(1 − c/{:g} m)² where the whole footprint's exact clearance is c more than required, and 1 from {:g} m on; a metre backwards {:g} times that, "
                               "one at the sharpest bend {:g} times that, a change of direction {:g} m{}.",
                               c.weight, c.range, c.range, options.lattice.costs.reverse, 1.0 + options.lattice.bend_share, c.change, graph_.options().may_turn ? fmt::format(", a radian on the spot {:g} m", c.turn) : std::string{}));
    text.push_back(fmt::format("Over a lattice of {} x {} cells of {:g} m with {} headings, and motions of bends up to {:.3f} 1/m that begin and end straight, {} costs {:.4f} m; {}. {} and {} asked for their clearance.",
                               graph_.columns(), graph_.rows(), graph_.cell(), lattice_headings, graph_.limits().curvature, options.gap > 0.0 ? "a way" : "the best way", answer.cost,
                               options.gap > 0.0 ? fmt::format("it is at most {} any way over it, none of which costs less than {:.4f} m", against(answer.cost, answer.lower_bound), answer.lower_bound)
                                                 : std::string{"no way over it costs less"},
                               counted(answer.expansions, "expansion"), counted(answer.motions, "motion")));
    if (options.smooth) {
      text.push_back(fmt::format("Smoothed off the lattice, to where small changes save nothing more, it costs {:.4f} m, {} what no way over the lattice can cost less than ({}); measured every {:g} cm the lattice's own way costs {:.4f} m.", way.cost,
                                 against(way.cost, answer.lower_bound), counted(way.evaluations, "motion") + " tried", 100.0 * fine_step,
                                 of_lattice));
    }
    text.push_back(fmt::format("It is {:.3f} m long; danger, bends{} and manoeuvres make {:+.3f} m of cost on top of that. The straight line from start to goal is {:.3f} m.", metres,
                               problem_.zones().weighs() ? ", zones" : "", way.cost - metres, straight));
    if (problem_.zones().weighs()) text.push_back("A metre in preferred and penalty zones costs its factor times that.");
    if (problem_.zones().directs()) text.push_back("No motion goes against the direction of a zone.");
    Alternative lattice{"best way over the lattice", !options.smooth, of_lattice, fmt::format("Costs {:.4f} m and is bound to the lattice's cells and headings.", of_lattice), {}, {}};
    for (const LatticeStretch& s : answer.stretches) {
      std::vector<SteppedPose> poses;
      sample_stretch(s, 0.1, look_angle, poses);
      for (const SteppedPose& p : poses) lattice.poses.push_back(p.pose);
    }
    planned.alternatives.push_back(std::move(lattice));
    if (options.smooth) planned.alternatives.push_back({"smoothed", true, way.cost, fmt::format("Costs {:.4f} m.", way.cost), {}, {}});
    return planned;
  }

  const Problem& problem_;
  LatticeGraph graph_;
  std::optional<LatticeRest> rest_;
};

ClearanceOptimalPlanner ClearanceOptimalPlanner::prepared(const Problem& problem) const {
  ClearanceOptimalPlanner planner = *this;
  planner.ready_ = std::make_shared<const Ready>(problem, options_);
  return planner;
}

PlanningResult ClearanceOptimalPlanner::plan(const Problem& problem, Budget& budget) const {
  if (ready_ && ready_->is_for(problem)) return ready_->plan(options_, budget);
  return Ready{problem, options_}.plan(options_, budget);
}

PlannerDescription clearance_optimal_description() {
  constexpr DangerCosts costs;
  constexpr LatticeOptions lattice;
  PlannerDescription d{
      "clearance_optimal",
      "length plus an integral of danger by the exact clearance of the footprint, least over a lattice of motions that the vehicle can drive, then smoothed; for all vehicles",
      {
          {.name = "danger_weight", .default_value = costs.weight, .summary = "a metre at the least clearance that is allowed costs 1 + danger_weight", .low = 0, .high = 1000},
          {.name = "danger_range", .default_value = costs.range, .summary = "so far beyond the clearance that is required there is danger", .unit = "m", .low = 0.01, .high = 20},
          {.name = "resolution", .default_value = 0.0, .summary = "size of the lattice's cells; 0: an eighth of the least radius, 0.1 to 0.5, doubled until there are at most 120000", .unit = "m", .low = 0,
           .high = 10},
          {.name = "min_radius", .default_value = lattice.min_radius, .summary = "least radius of bends, of vehicles whose curvature is not limited", .unit = "m", .low = 0.05, .high = 100},
          {.name = "reverse_cost", .default_value = costs.reverse, .summary = "metres that a metre backwards counts as; under 1: never backwards", .low = 0, .high = 100},
          {.name = "change_cost", .default_value = costs.change, .summary = "metres that a change of direction counts as", .unit = "m", .low = 0, .high = 100},
          {.name = "turn_cost", .default_value = costs.turn, .summary = "metres that a radian of turning on the spot counts as, of vehicles that can", .unit = "m", .low = 0, .high = 100},
          {.name = "bend_cost", .default_value = lattice.bend_share, .summary = "by so much a metre at the sharpest bend costs more; less at gentler ones, by the square of the curvature", .low = 0, .high = 100},
          {.name = "turns", .default_value = true, .summary = "turn on the spot, where the vehicle can"},
          {.name = "gap", .default_value = 0.0, .summary = "the way over the lattice may cost up to this share more than the best one, and is found sooner", .low = 0, .high = 10},
          {.name = "smooth", .default_value = true, .summary = "leave the lattice where that costs less"},
      },
      [](const Parameters& p, std::uint64_t) -> AnyPlanner {
        const auto number = [&](const char* key) { return std::get<double>(p.at(key)); };
        ClearanceOptimalOptions options;
        DangerCosts& c = options.lattice.costs;
        c.weight = number("danger_weight");
        c.range = number("danger_range");
        options.lattice.may_reverse = number("reverse_cost") >= 1.0;
        c.reverse = std::max(1.0, number("reverse_cost"));
        c.change = number("change_cost");
        c.turn = number("turn_cost");
        options.lattice.cell = number("resolution");
        options.lattice.min_radius = number("min_radius");
        options.lattice.bend_share = number("bend_cost");
        options.lattice.may_turn = std::get<bool>(p.at("turns"));
        options.gap = number("gap");
        options.smooth = std::get<bool>(p.at("smooth"));
        return ClearanceOptimalPlanner{options};
      }};
  d.counts_expansions = true;
  d.heeds_zones = [](const Parameters&) { return true; };
  return d;
}

}  // namespace waywright
