#include "waywright/planner/ompl/ompl_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "waywright/core/random.hpp"
#include "waywright/geometry/polygon.hpp"
#include "waywright/planner/ompl/ompl_words.hpp"
#include "waywright/planner/steering/search_ends.hpp"
#include "waywright/planner/steering/shortcut.hpp"
#include "waywright/planner/steering/spaces.hpp"
#include "waywright/planner/steering/way_words.hpp"

namespace waywright {
namespace {

constexpr double enough = 1e-6;        // of the cost: nothing less can be
constexpr double no_way = 1e-9;        // m
constexpr double kept_for_shortcuts = 0.1;  // of the work of optimising planners
constexpr int region_goals = 16;       // places of a goal's region that are aimed at

/// What the vehicle, the task and the planner do not go together with; empty: nothing.
std::string refusal(const Problem& problem, SteeringKind space, SamplingPlanner planner, std::string_view name, const OmplOptions& options) {
  if (space == SteeringKind::dubins && planner == SamplingPlanner::prm_star) {
    return fmt::format("{} drives the motions of its roadmap both ways, and Dubins curves lead forwards alone: give space reeds_shepp", name);
  }
  if (std::string reason = space_refusal(problem, space, name, label(planner)); !reason.empty()) return reason;
  if (problem.free_goal() != nullptr && options.goal_straight > 0.0) return fmt::format("{} cannot end in a straight run at a goal that leaves the heading free", name);
  return {};
}

/// The way ends where it first comes into the goal's region, to a centimetre.
std::vector<Pose> cut_at_region(std::vector<Pose> states, const Ring& area) {
  constexpr double step = 0.01;  // m
  for (std::size_t i = 1; i < states.size(); ++i) {
    const Vec2 from = states[i - 1].position(), way = states[i].position() - from;
    const int steps = static_cast<int>(std::ceil(norm(way) / step));
    for (int k = 1; k < steps; ++k) {
      const Vec2 there = from + (static_cast<double>(k) / steps) * way;
      if (!contains(area, there)) continue;
      states.resize(i + 1);
      states[i] = make_pose(there, 0.0);
      return states;
    }
  }
  return states;
}

/// One plan: what the steps of it share.
class Planning {
 public:
  Planning(const Problem& problem, Budget& budget, SamplingPlanner planner, const OmplOptions& options, std::uint64_t seed, SteeringKind space)
      : problem_{problem},
        budget_{budget},
        planner_{planner},
        options_{options},
        seed_{seed},
        steering_{make_steering(problem, space, options.of_space())},
        test_{problem, limits(), budget, space == SteeringKind::plane ? Footprint{{}, problem.footprint().radius()} : problem.footprint()} {}

  PlanningResult run() {
    search_.error = prepare();
    std::optional<std::vector<Pose>> direct;
    if (search_.error.empty()) direct = direct_way();
    if (direct && (!is_optimising(planner_) || cost_of(*steering_, *direct) <= (1.0 + enough) * least())) {
      search_.states = *direct;
    } else if (search_.error.empty()) {
      search();
      // Turns on the spot can be cheaper in more than one motion, so that it had to be looked for.
      if (direct && (search_.states.empty() || cost_of(*steering_, *direct) <= cost_of(*steering_, search_.states))) search_.states = *direct;
    }
    if (search_.states.empty()) return tl::unexpected{failure()};
    return answer();
  }

 private:
  MotionTestLimits limits() const {
    MotionTestLimits limits;
    limits.placements = budget_.limits().samples.value_or(options_.checks);
    limits.motions = budget_.evaluations_left().value_or(std::numeric_limits<std::int64_t>::max());
    limits.resolution = options_.resolution;
    return limits;
  }

  /// Ends of the search; or why there is none.
  std::string prepare() {
    const Pose& start = problem_.start();
    const Pose& goal = problem_.goal();
    start_ = {start, std::nullopt};
    goal_ = {goal, std::nullopt};
    const FreeGoal* free = problem_.free_goal();
    if (free != nullptr && problem_.is_goal(start, 0.0, 0.0)) return "the start is at the goal already, there is nothing to drive";
    if (free == nullptr && is_same(start, goal)) return "start and goal are the same pose, there is nothing to drive";
    const bool backwards_too = steering_->kind() != SteeringKind::dubins;
    if (steering_->has_headings()) start_ = end_of_search(test_, start, true, backwards_too);
    if (options_.goal_straight > 0.0) {
      goal_ = goal_with_run(test_, goal, options_.goal_straight);
      if (!goal_.run) return fmt::format("the straight run of {:g} m into the goal is not free", options_.goal_straight);
    } else if (steering_->has_headings()) {
      goal_ = end_of_search(test_, goal, false, backwards_too);
    }
    goals_ = {goal_.pose};
    if (!steering_->has_headings() && !disc_fits(start_.pose)) return no_place("start");
    if (free != nullptr && !free->is_point()) return draw_goals(*free);
    if (!steering_->has_headings() && !disc_fits(goal_.pose)) return no_place("goal");
    return {};
  }

  bool is_same(const Pose& a, const Pose& b) const {
    if (steering_->has_headings()) return steering_->between(a, b).empty();
    return distance(a.position(), b.position()) <= no_way && std::abs(shorter_turn(a.heading, b.heading)) <= no_way;
  }

  bool disc_fits(const Pose& pose) { return problem_.footprint().is_disc() || test_.pose_free(pose) || test_.spent(); }
  std::string no_place(const char* where) const {
    return fmt::format("the disc of {:.3f} m around the footprint, which could turn anywhere, does not keep the required clearance at the {}: the space \"turns\" plans for the footprint itself",
                       problem_.footprint().radius(), where);
  }

  /// Places in the region that are aimed at; or why there is none.
  std::string draw_goals(const FreeGoal& free) {
    constexpr int tries = 100 * region_goals;
    Random random = Random::stream(seed_, 2);
    const Box box = bounding_box(free.area);
    goals_.clear();
    int inside = 0;
    for (int i = 0; i < tries && static_cast<int>(goals_.size()) < region_goals && !test_.spent(); ++i) {
      const double x = random.uniform(box.low.x, box.high.x);
      const Pose place{x, random.uniform(box.low.y, box.high.y), 0.0};
      if (!contains(free.area, place.position())) continue;
      ++inside;
      if (test_.pose_free(place)) goals_.push_back(place);
    }
    if (!goals_.empty()) return {};
    goals_ = {goal_.pose};  // for words alone
    if (test_.spent()) return "its budget was spent before a free place in the goal's region was found";
    return fmt::format("none of the {} places drawn in the goal's region is free for a disc of {:.3f} m", inside, problem_.footprint().radius());
  }

  double least() const {
    double least = std::numeric_limits<double>::infinity();
    for (const Pose& goal : goals_) least = std::min(least, steering_->least(start_.pose, goal));
    return least;
  }

  std::optional<std::vector<Pose>> direct_way() {
    const Pose& goal = *std::min_element(goals_.begin(), goals_.end(), [this](const Pose& a, const Pose& b) { return steering_->distance(start_.pose, a) < steering_->distance(start_.pose, b); });
    if (!test_.motion_free(steering_->between(start_.pose, goal))) return std::nullopt;
    return std::vector<Pose>{start_.pose, goal};
  }

  void search() {
    SamplingQuery query;
    query.start = start_.pose;
    query.goals = goals_;
    query.region = search_region(problem_, steering_->is_curve() ? turning_radius(problem_, options_.of_space()) : 0.0, steering_->is_curve());
    query.kept = options_.simplify ? kept_for_shortcuts : 0.0;
    search_ = sampling_search(planner_, options_.library, query, *steering_, test_, seed_);
  }

  Alternative alternative() const {
    Alternative alternative;
    alternative.name = library::name_of_alternative(planner_, steering_->kind());
    return alternative;
  }

  library::Told told() const { return {planner_, *steering_, test_, budget_, search_}; }

  PlanningFailure failure() {
    budget_.count_evaluations(test_.motions());
    Path nearest;
    if (search_.nearest.size() > 1) nearest = path_along_states(*steering_, search_.nearest, start_.pose, std::nullopt);
    return library::failed(told(), problem_, nearest, alternative());
  }

  /// Into the goal's pose, or where its heading is free, as the last drive has it.
  Path path_of_states(const std::vector<Pose>& states) const {
    return path_along_states(*steering_, states, start_.pose, problem_.free_goal() != nullptr ? std::nullopt : std::optional{goal_.pose});
  }

  PlanningResult answer() {
    std::vector<Pose> states = search_.states;
    const Path found = path_of_states(states);
    Path middle = found;
    if (options_.simplify && steering_->is_curve() && !found.pieces.empty()) {
      middle = shortened(found, *steering_, test_, options_.shortcuts, seed_);
    } else if (options_.simplify && !steering_->is_curve()) {
      states = shortened(std::move(states), *steering_, test_, options_.shortcuts, seed_);
    }
    if (problem_.free_goal() != nullptr && !problem_.free_goal()->is_point()) states = cut_at_region(std::move(states), problem_.free_goal()->area);
    if (!steering_->is_curve()) middle = path_of_states(states);
    budget_.count_evaluations(test_.motions());

    Planned planned;
    planned.path = with_runs(*steering_, start_, middle, goal_);
    if (planned.path.pieces.empty()) {
      search_.error = "start and goal are the same place, there is nothing to drive";
      return tl::unexpected{library::failed(told(), problem_, {}, alternative())};
    }
    std::optional<double> before;
    if (options_.simplify) before = length(with_runs(*steering_, start_, found, goal_));
    const bool is_shortest = is_optimising(planner_) && steering_->is_curve() && !start_.run && !goal_.run && length(planned.path) <= (1.0 + enough) * least();
    planned.explanation = library::explain(told(), planned.path, before, is_shortest);
    if (!steering_->has_headings() && !problem_.footprint().is_disc()) {
      planned.explanation.push_back(fmt::format("It was searched for the disc around the footprint, {:.3f} m, which can turn wherever it can stand; space turns finds narrower ways.", problem_.footprint().radius()));
    }
    Alternative chosen = alternative();
    chosen.chosen = true;
    chosen.cost = length(planned.path);
    chosen.is_length = true;
    chosen.outcome = library::outcome_of(planned.path);
    chosen.poses = poses_along(planned.path);
    planned.alternatives.push_back(std::move(chosen));
    return planned;
  }

  const Problem& problem_;
  Budget& budget_;
  SamplingPlanner planner_;
  const OmplOptions& options_;
  std::uint64_t seed_;
  std::unique_ptr<const Steering> steering_;
  MotionTest test_;
  StateEnd start_, goal_;
  std::vector<Pose> goals_;
  SamplingResult search_;
};

}  // namespace

std::string_view OmplPlanner::name() const {
  switch (planner_) {
    case SamplingPlanner::rrt_connect: return "ompl_rrt_connect";
    case SamplingPlanner::rrt_star: return "ompl_rrt_star";
    case SamplingPlanner::informed_rrt_star: return "ompl_informed_rrt_star";
    case SamplingPlanner::bit_star: return "ompl_bit_star";
    case SamplingPlanner::ait_star: return "ompl_ait_star";
    case SamplingPlanner::prm_star: return "ompl_prm_star";
    case SamplingPlanner::kpiece: break;
  }
  return "ompl_kpiece";
}

PlanningResult OmplPlanner::plan(const Problem& problem, Budget& budget) const {
  const SteeringKind space = chosen_space(problem, options_.of_space(), false);
  if (std::string reason = refusal(problem, space, planner_, name(), options_); !reason.empty()) {
    PlanningFailure refused;
    refused.failure.status = Status::no_path;
    refused.failure.reason = reason;
    refused.explanation.push_back(reason + ".");
    Alternative alternative;
    alternative.name = library::name_of_alternative(planner_, space);
    alternative.outcome = reason + ".";
    refused.alternatives.push_back(std::move(alternative));
    return tl::unexpected{std::move(refused)};
  }
  return Planning{problem, budget, planner_, options_, seed_, space}.run();
}

}  // namespace waywright
