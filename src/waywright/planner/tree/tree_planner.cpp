#include "waywright/planner/tree/tree_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "waywright/planner/grid/grid_path.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/grid/search_pool.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/roadmap/state_planning.hpp"
#include "waywright/planner/tree/improved_way.hpp"
#include "waywright/planner/tree/state_tree.hpp"

namespace waywright {
namespace {

using grid::counted;

constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();

std::vector<Pose> picture_of(const std::vector<Vec2>& points) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 along = i + 1 < points.size() ? points[i + 1] - points[i] : i > 0 ? points[i] - points[i - 1] : Vec2{1.0, 0.0};
    poses.push_back(make_pose(points[i], angle_of(along)));
  }
  return poses;
}

/// Of a limited number of evaluations the global variant leaves its second part what that can use, a half at most.
std::int64_t for_refinement(const TreePlannerOptions& options, std::int64_t left) {
  if (options.method != TreeMethod::woa_global) return 0;
  const std::int64_t wanted = static_cast<std::int64_t>(options.refinement.population) * (options.refinement.iterations + 1) * std::max(1, options.rounds);
  return std::min(wanted, left / 2);
}

/// @param left of the budget before the search  @param edges what of it the tree may use
std::string lines_spent(std::int64_t edges, std::int64_t left) {
  if (edges >= left) return fmt::format("all {} of its budget were used", counted(left, "evaluation"));
  return fmt::format("{} of the {} of its budget were used, the others being kept for moving the corners of a way", edges, counted(left, "evaluation"));
}

/// Behind the tree's samples: what the swarm did is spread over twice as many steps, iterations that do not fit left out evenly.
void draw_swarm(SearchPicture& picture, const std::vector<std::vector<std::vector<Vec2>>>& iterations, const std::vector<std::vector<Vec2>>& ways) {
  if (iterations.empty()) return;
  const std::size_t all = iterations.size(), shown = std::min(all, WhaleRefinement::most_drawn);
  const std::uint32_t first = picture.steps, last = 3 * std::max<std::uint32_t>(first, 1);
  const auto step_of = [&](std::size_t iteration) { return first + static_cast<std::uint32_t>(static_cast<std::uint64_t>(last - first) * iteration / all); };
  for (std::size_t k = 1; k <= shown; ++k) {  // the last one always
    const std::size_t i = k * all / shown - 1;
    picture.swarms.push_back({iterations[i], step_of(i)});
  }
  for (std::size_t i = 0; i < ways.size(); ++i) picture.ways.push_back({ways[i], step_of((i + 1) * all / ways.size())});
  picture.steps = last;
}

/// It knows no other space.
bool is_planar(TreeMethod method) { return method == TreeMethod::woa_local || method == TreeMethod::woa_global; }

const char* tree_name(TreeMethod method) { return method == TreeMethod::rrt ? "RRT" : "RRT*"; }

StateAnswer answer_of(const StateTree& tree, const StateQuery& query, const PlaneTreeOptions& options, const char* label, const Budget& budget) {
  const StateTreeStatistics& statistics = tree.statistics();
  const std::string has = fmt::format("{} after {}", counted(static_cast<std::int64_t>(tree.size()), "node"), counted(statistics.samples, "sample"));
  StateAnswer answer;
  answer.picture = tree.picture();
  if (tree.is_found()) {
    answer.states = tree.way();
    answer.is_least = statistics.is_least;
    answer.found = fmt::format("Its tree has {}", has);
    if (statistics.samples == 0) {
      answer.found = "The motion from start to goal is free";
    } else if (options.first_path) {
      answer.found += fmt::format(" when the first way was there, of cost {:.3f} m", tree.cost());
    } else {
      answer.found += fmt::format("; the first way, of cost {:.3f} m, was there after {}, that of the best one is {:.3f} m", *statistics.first_cost, counted(statistics.first_path_after, "sample"), tree.cost());
    }
    return answer;
  }
  const std::string ended = budget.cut_short()                      ? fmt::format("the {:g} s of its budget were over", budget.limits().seconds.value_or(0.0))
                            : statistics.samples >= options.samples ? fmt::format("all {} were drawn", counted(statistics.samples, "sample"))
                            : statistics.is_stuck                   ? std::string{"no state was free that a sample could be"}
                                                                    : motions_spent(query);
  answer.missed = fmt::format("{} found no way from start to goal before {}: its tree has {}, {} tested", label, ended, has, counted(query.test.motions(), "motion"));
  answer.nearest = tree.way_to(tree.nearest_to_goal());
  return answer;
}

}  // namespace

class TreePlanner::Ready {
 public:
  Ready(const Problem& problem, const TreePlannerOptions& options) : space_{problem} {
    if (!is_planar(options.method)) kind_ = chosen_space(problem, options.space, problem.free_goal() == nullptr && !problem.footprint().is_disc() && !options.space.space && disc_serves(space_));
  }
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  bool is_for(const Problem& problem) const { return &problem == &space_.problem(); }

  PlanningResult plan(const TreePlannerOptions& options, std::string_view name, std::uint64_t seed, Budget& budget) const {
    using grid::failure;
    const Problem& problem = space_.problem();
    const std::int64_t samples = budget.limits().samples.value_or(options.tree.samples);
    if (kind_ != SteeringKind::plane) return among_states(options, name, seed, samples, budget);
    if (options.space.space) {  // it was asked for
      if (std::string reason = space_refusal(problem, kind_, name, tree_name(options.method)); !reason.empty()) return tl::unexpected{failure(Status::no_path, std::move(reason))};
    }
    if (auto reason = nothing_to_plan(problem, name)) return tl::unexpected{failure(Status::no_path, std::move(*reason))};
    if (budget.exhausted()) {
      return tl::unexpected{budget.canceled() ? failure(Status::canceled, "canceled before the search began")
                                              : failure(Status::timed_out, fmt::format("the {:g} s of its budget were over before the search began", budget.limits().seconds.value_or(0.0)))};
    }
    const auto start = plane_start(space_);
    const bool is_region = problem.free_goal() != nullptr && !problem.free_goal()->is_point();
    const auto goal = is_region ? std::optional<PlaneEnd>{PlaneEnd{}} : plane_goal(space_);
    if (!start || !goal) {
      budget.count_evaluations();  // the run that was looked for
      return tl::unexpected{no_room(space_, !start)};
    }
    PlaneTreeOptions tree_options = options.tree;
    tree_options.samples = samples;
    const std::int64_t left = budget.evaluations_left().value_or(no_limit);
    const std::int64_t edges = left == no_limit ? no_limit : left - for_refinement(options, left);
    auto lent = trees_.lend();
    PlaneTree& tree = *lent;
    std::optional<WhaleSteering> steering;
    if (options.method == TreeMethod::woa_local) steering.emplace(space_, options.steering);
    const PlaneTarget target = target_of(problem, goal->at);
    tree.grow(space_, tree_options, start->at, target, seed, budget, edges, steering ? &*steering : nullptr);
    budget.count_evaluations(tree.statistics().edges);
    if (budget.canceled()) return tl::unexpected{failure(Status::canceled, fmt::format("canceled after {}", counted(tree.statistics().samples, "sample")))};
    if (!tree.is_found()) {
      bool is_hopeless = false;
      PlanningFailure failed = nothing_found(options, tree, tree_options, target, edges, left, budget, is_hopeless);
      if (steering && failed.search) steering->draw(*failed.search);
      const std::int64_t unspent = budget.limits().samples ? samples - tree.statistics().samples : samples;
      if (is_hopeless || failed.failure.status != Status::no_path) return tl::unexpected{std::move(failed)};
      if (!is_planar(options.method) && may_turn_instead(problem, options.space) && unspent > 0 && budget.evaluations_left() != 0) {
        return after_the_disc(failed, among_states(options, name, seed, unspent, budget));
      }
      if (const std::string itself = footprint_sentence(problem); !itself.empty()) failed.failure.reason += "; " + itself;
      failed.explanation = {failed.failure.reason + "."};
      return tl::unexpected{std::move(failed)};
    }
    return explained(options, tree, tree_options, steering, *start, *goal, seed, budget);
  }

 private:
  PlanningResult among_states(const TreePlannerOptions& options, std::string_view name, std::uint64_t seed, std::int64_t samples, Budget& budget) const {
    PlaneTreeOptions tree_options = options.tree;
    tree_options.samples = samples;
    const char* label = tree_name(options.method);
    auto lent = state_trees_.lend();
    const auto search = [&](const StateQuery& query) {
      (*lent).grow(query, tree_options, seed, budget);
      return answer_of(*lent, query, tree_options, label, budget);
    };
    return StatePlanning{space_, kind_, options.space, name, label}.plan(search, options.shortens, seed, budget);
  }

  PlanningFailure nothing_found(const TreePlannerOptions& options, const PlaneTree& tree, const PlaneTreeOptions& tree_options, const PlaneTarget& target, std::int64_t edges, std::int64_t left, Budget& budget,
                                bool& is_hopeless) const {
    const PlaneTreeStatistics& statistics = tree.statistics();
    const bool is_late = budget.cut_short();
    const std::string ended = is_late                                  ? fmt::format("the {:g} s of its budget were over", budget.limits().seconds.value_or(0.0))
                              : statistics.samples >= tree_options.samples ? fmt::format("all {} were drawn", counted(statistics.samples, "sample"))
                              : statistics.edges >= edges                  ? lines_spent(edges, left)
                                                                           : std::string{"no place was free that a sample could be"};
    std::uint32_t nearest = 0;
    double missing = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
      const double off = distance(tree.place(i), target.nearest(tree.place(i)));
      if (off < missing) {
        missing = off;
        nearest = i;
      }
    }
    const Vec2 reached = tree.place(nearest);
    std::string reason = fmt::format("{} found no way from start to goal for {} of {:.3f} m before {}: {} in the tree, {} tested; nearest to the goal it came to {}, {:.2f} m off",
                                     tree_name(options.method), space_.problem().footprint().is_disc() ? "a disc" : "the disc around the footprint,", space_.disc(), ended,
                                     counted(static_cast<std::int64_t>(tree.size()), "node"), counted(statistics.edges, "line"), grid::place(reached), missing);
    if (!is_late) {
      const std::string more = unreachable_sentence(least_length(space_, budget), space_.problem());
      is_hopeless = !more.empty();
      if (is_hopeless) reason += "; " + more;
    }
    PlanningFailure failed = grid::failure(is_late ? Status::timed_out : Status::no_path, reason);
    Alternative tried;
    tried.name = tree_name(options.method);
    tried.outcome = fmt::format("{:.2f} m short of the goal.", missing);
    std::vector<Vec2> points;
    for (std::uint32_t n = nearest; n != PlaneTree::none; n = tree.parent(n)) points.insert(points.begin(), tree.place(n));
    tried.poses = picture_of(points);
    failed.alternatives.push_back(std::move(tried));
    failed.search = tree.picture();
    failed.explanation.push_back(reason + ".");
    return failed;
  }

  PlanningResult explained(const TreePlannerOptions& options, const PlaneTree& tree, const PlaneTreeOptions& tree_options, const std::optional<WhaleSteering>& steering, const PlaneEnd& start,
                           const PlaneEnd& goal, std::uint64_t seed, Budget& budget) const {
    Planned planned;
    const PlaneTreeStatistics& statistics = tree.statistics();
    const std::vector<Vec2> grown = tree.way();
    std::vector<Vec2> points = grown;
    std::vector<std::string>& text = planned.explanation;
    const auto tried = [&](std::string name, const std::vector<Vec2>& way, bool is_chosen) {
      Alternative alternative;
      alternative.name = std::move(name);
      alternative.chosen = is_chosen;
      alternative.cost = length_of_way(way);
      alternative.is_length = true;
      alternative.outcome = fmt::format("{:.3f} m with {}.", *alternative.cost, counted(static_cast<std::int64_t>(way.size() - 2), "corner"));
      alternative.poses = picture_of(way);
      planned.alternatives.push_back(std::move(alternative));
    };
    planned.search = tree.picture();
    if (steering) steering->draw(*planned.search);
    std::string what = fmt::format("This is the path of a sampling planner, {} for {} of {:.3f} m: another seed gives another path. Its tree has {} after {}, with {} tested", tree_name(options.method),
                                   space_.problem().footprint().is_disc() ? "a disc" : "the disc around the footprint,", space_.disc(), counted(static_cast<std::int64_t>(tree.size()), "node"),
                                   counted(statistics.samples, "sample"), counted(statistics.edges, "line"));
    if (grown.size() <= 2) {
      what += fmt::format("; the straight line from start to goal is free, and no way is shorter: {:.3f} m", tree.length());
    } else if (!tree_options.first_path && statistics.first_length) {
      what += fmt::format("; the first way, {:.3f} m, was there after {}, the best one is {:.3f} m", *statistics.first_length, counted(statistics.first_path_after, "sample"), tree.length());
    } else {
      what += fmt::format(" when the first way was there, {:.3f} m", tree.length());
    }
    text.push_back(what + ".");
    if (steering) {
      text.push_back(fmt::format("Each extension was aimed by the whale optimisation algorithm, {} agents in {} iterations around the sample: {} of places, {} looked along.",
                                 options.steering.population, options.steering.iterations, counted(steering->evaluations(), "evaluation"), counted(steering->lines(), "line")));
    }
    if (options.method == TreeMethod::woa_global) {
      WhaleRefinementOptions refining = options.refinement;
      refining.evaluations = budget.evaluations_left().value_or(no_limit);
      if (options.rounds > 0) {
        ImprovedWay improved = improved_way(points, space_, refining, options.rounds, seed, budget);
        points = improved.points;
        draw_swarm(*planned.search, improved.agents, improved.ways);
        budget.count_evaluations(improved.evaluations);
        text.push_back(fmt::format("The whale optimisation algorithm moved its corners in {}, corners dropped and inserted between: {:.3f} m after {}.", counted(improved.rounds, "round"),
                                   length_of_way(points), counted(improved.evaluations, "evaluation")));
      } else {
        WhaleRefinement refinement;
        std::vector<std::vector<std::vector<Vec2>>> agents;
        refinement.draw_into(&agents);
        points = refinement.refined(points, space_, refining, seed, budget);
        draw_swarm(*planned.search, agents, {points});
        budget.count_evaluations(refinement.evaluations());
        text.push_back(fmt::format("The whale optimisation algorithm moved its corners, as published: {:.3f} m after {}.", length_of_way(points), counted(refinement.evaluations(), "evaluation")));
      }
    }
    if (options.shortens) {
      const double before = length_of_way(points);
      points = taut_way(std::move(points), space_);
      const double after = length_of_way(points);
      if (after < before) text.push_back(fmt::format("Corners past which their neighbours see each other were left out: {:.3f} m.", after));
    }
    if (points != grown) tried(tree_name(options.method), grown, false);
    tried(points == grown ? tree_name(options.method) : "as driven", points, true);
    planned.path = plane_path(space_, start, points, goal);
    if (planned.path.pieces.empty()) return tl::unexpected{grid::failure(Status::no_path, "start and goal are the same place, there is nothing to drive")};
    if (start.run != 0 || goal.run != 0) text.push_back(run_sentence(space_, start, goal));
    text.push_back(driving_sentence(space_.problem(), planned.path));
    if (std::string bound = bound_sentence(least_length(space_, budget), length(planned.path)); !bound.empty()) text.push_back(std::move(bound));
    return planned;
  }

  PlaneSpace space_;
  SteeringKind kind_ = SteeringKind::plane;
  mutable SearchPool<PlaneTree> trees_;
  mutable SearchPool<StateTree> state_trees_;
};

TreePlanner TreePlanner::prepared(const Problem& problem) const {
  TreePlanner planner = *this;
  planner.ready_ = std::make_shared<const Ready>(problem, options_);
  return planner;
}

PlanningResult TreePlanner::plan(const Problem& problem, Budget& budget) const {
  if (ready_ && ready_->is_for(problem)) return ready_->plan(options_, name_, seed_, budget);
  return Ready{problem, options_}.plan(options_, name_, seed_, budget);
}

}  // namespace waywright
