#include "waywright/planner/tree/tree_session.hpp"

#include <limits>

#include "waywright/planner/plane/plane_ends.hpp"

namespace waywright {
namespace {

constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();

struct Ends {
  PlaneEnd start, goal;
};
std::optional<Ends> ends_of(const PlaneSpace& space) {
  const auto start = plane_start(space);
  const FreeGoal* free = space.problem().free_goal();
  const auto goal = free != nullptr && !free->is_point() ? std::optional<PlaneEnd>{PlaneEnd{}} : plane_goal(space);
  if (!start || !goal) return std::nullopt;
  return Ends{*start, *goal};
}

std::optional<Path> path_of(const PlaneTree& tree, const PlaneSpace& space, const Ends& ends) {
  if (!tree.is_found()) return std::nullopt;
  Path path = plane_path(space, ends.start, taut_way(tree.way(), space), ends.goal);
  if (path.pieces.empty()) return std::nullopt;
  return path;
}

}  // namespace

std::optional<Path> TreeSession::plan(const Problem& problem, Budget& budget) {
  const PlaneSpace space{problem};
  const auto ends = ends_of(space);
  if (!ends) return std::nullopt;
  calls_ = 0;
  tree_.grow(space, options_, ends->start.at, target_of(problem, ends->goal.at), seed_, budget, budget.evaluations_left().value_or(no_limit));
  budget.count_evaluations(tree_.statistics().edges);
  return path_of(tree_, space, *ends);
}

std::optional<Path> TreeSession::replan(const Problem& problem, const Map& appeared, std::int64_t more, Budget& budget) {
  const PlaneSpace space{problem};
  const auto ends = ends_of(space);
  if (!ends) return std::nullopt;
  World only{appeared};
  only.build();
  kept_.take(tree_);
  // Nodes are looked for as far as an edge may be long: the proven radius has become small in a tree that is large.
  const PlaneTarget target = target_of(problem, ends->goal.at);
  if (!kept_.carry_over(space, only, ends->start.at, options_.radius > 0.0 ? options_.radius : options_.step, target)) return std::nullopt;
  budget.count_evaluations(kept_.statistics().lines + kept_.statistics().near);
  PlaneTreeOptions options = options_;
  options.samples = more;
  tree_.grow_on(kept_.nodes(), space, options, target, seed_ + ++calls_, budget, budget.evaluations_left().value_or(no_limit));
  budget.count_evaluations(tree_.statistics().edges);
  return path_of(tree_, space, *ends);
}

}  // namespace waywright
