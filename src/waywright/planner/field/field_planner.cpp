#include "waywright/planner/field/field_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "waywright/planner/field/sphere_world_of.hpp"
#include "waywright/planner/grid/grid_words.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/plane/plane_target.hpp"
#include "waywright/planner/plane/rounded_way.hpp"
#include "waywright/planner/roadmap/least_length.hpp"

namespace waywright {
namespace {

using grid::counted;
using grid::failure;
using grid::place;

constexpr double thinning = 0.002;        // m
constexpr double rim_share = 0.2;         // of the distance to the nearest rim, that a step is long at most
constexpr double shortest_step = 1e-6;    // of the outer disc's radius
constexpr int region_points = 24;         // a side, that are looked at in a region for one where the disc can stand

/// Where in the goal's area the way is to end: as near to the start as the disc can stand.
std::optional<Vec2> point_of(const PlaneTarget& target, const PlaneSpace& space, Vec2 start) {
  if (const Vec2 near = target.nearest(start); space.is_free(near)) return near;
  if (target.is_point()) return std::nullopt;
  Vec2 low = target.area.front(), high = low;
  for (const Vec2 p : target.area) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  std::optional<Vec2> best;
  for (int j = 0; j < region_points; ++j) {
    for (int i = 0; i < region_points; ++i) {
      const Vec2 p{low.x + (i + 0.5) / region_points * (high.x - low.x), low.y + (j + 0.5) / region_points * (high.y - low.y)};
      if (contains(target.area, p) && space.is_free(p) && (!best || distance(p, start) < distance(*best, start))) best = p;
    }
  }
  return best;
}

std::vector<Pose> picture_of(const std::vector<Vec2>& points) {
  std::vector<Pose> poses;
  const std::size_t every = std::max<std::size_t>(1, points.size() / 2000);
  for (std::size_t i = 0; i + 1 < points.size(); i += every) poses.push_back(make_pose(points[i], angle_of(points[i + 1] - points[i])));
  return poses;
}

}  // namespace

class FieldPlanner::Ready {
 public:
  explicit Ready(const Problem& problem) : space_{problem} {}
  Ready(const Ready&) = delete;
  Ready& operator=(const Ready&) = delete;

  bool is_for(const Problem& problem) const { return &problem == &space_.problem(); }

  PlanningResult plan(const FieldPlannerOptions& options, std::string_view name, Budget& budget) const {
    const Problem& problem = space_.problem();
    if (auto reason = nothing_to_plan(problem, name)) return tl::unexpected{failure(Status::no_path, std::move(*reason))};
    if (budget.exhausted()) return tl::unexpected{stopped(budget, 0)};
    const auto start = plane_start(space_);
    const bool is_region = problem.free_goal() != nullptr && !problem.free_goal()->is_point();
    auto goal = is_region ? std::optional<PlaneEnd>{PlaneEnd{}} : plane_goal(space_);
    if (start && is_region) {
      const auto at = point_of(target_of(problem, {}), space_, start->at);
      if (at) goal->at = *at;
      else goal.reset();
    }
    if (!start || !goal) {
      budget.count_evaluations();
      return tl::unexpected{no_room(space_, !start)};
    }
    std::vector<std::string> text;
    Descent descent;
    const std::int64_t most = std::min(options.steps, budget.evaluations_left().value_or(std::numeric_limits<std::int64_t>::max()));
    if (options.method == FieldMethod::potential) {
      const PotentialField field{space_, options.potential, goal->at};
      const auto down = [&](Vec2 q) -> std::optional<FieldStep> {
        const auto value = field.at(q);
        if (!value) return std::nullopt;
        return FieldStep{-value->gradient, value->potential};
      };
      descent = descend(down, start->at, goal->at, options.descent, most, budget);
      text.push_back(fmt::format("Down the potential of the goal's attraction ({:g}, conic from {:g} m) and the repulsion of what is nearer than {:g} m ({:g}): {} of at most {:g} m.",
                                 options.potential.attraction, options.potential.conic_from, options.potential.reach, options.potential.repulsion, counted(descent.steps, "step"),
                                 options.descent.speed * options.descent.period));
    } else {
      const auto covering = covering_world(space_, start->at, goal->at);
      if (!covering) {
        budget.count_evaluations();
        return tl::unexpected{failure(Status::no_path, "a navigation function on a world of discs needs each obstacle in a disc apart from the others: " + covering.error())};
      }
      double kappa = options.kappa;
      if (kappa == 0.0) {
        const ChosenKappa chosen = choose_kappa(covering->world, goal->at);
        kappa = chosen.kappa;
        text.push_back(chosen.is_shown ? fmt::format("κ = {:g} is the least of those looked at whose navigation function has as many saddles as there are discs, {}, and no minimum but the goal.", kappa,
                                                     covering->world.obstacles.size())
                                       : fmt::format("No κ up to {:g} was shown to leave no minimum but the goal.", kappa));
      } else {
        const std::vector<CriticalPoint> points = critical_points({covering->world, goal->at, kappa});
        for (const CriticalPoint& c : points) {
          if (c.is_minimum) text.push_back(fmt::format("With κ = {:g} there is another minimum than the goal, at {}.", kappa, place(c.at)));
        }
      }
      const NavigationFunction function{covering->world, goal->at, kappa};
      const double radius = covering->world.outside.radius;
      DescentOptions follow = options.descent;
      follow.period = 1.0;
      follow.speed = options.step * radius;
      follow.goal_tolerance = 2.0 * follow.speed;
      follow.patience = std::numeric_limits<int>::max();
      follow.may_creep = true;
      const auto down = [&](Vec2 q) -> std::optional<FieldStep> {
        const double rim = function.distance_to_rim(q);
        if (!(rim > 0.0)) return std::nullopt;
        const Vec2 slope = function.slope(q);
        const double steep = norm(slope);
        if (!(steep > 0.0)) return FieldStep{};
        return FieldStep{(-std::clamp(rim_share * rim, shortest_step * radius, follow.speed) / steep) * slope, 0.0};
      };
      descent = descend(down, start->at, goal->at, follow, most, budget);
      text.push_back(fmt::format("Down the navigation function of κ = {:g} on the disc of {:.3f} m around ({:.3f}, {:.3f}) with {} in it: {}.", kappa, radius, covering->world.outside.centre.x,
                                 covering->world.outside.centre.y, counted(static_cast<std::int64_t>(covering->world.obstacles.size()), "disc"), counted(descent.steps, "step")));
    }
    if (descent.ended != DescentEnd::goal) return tl::unexpected{trapped(descent, goal->at, std::move(text), name, budget)};
    descent.points.push_back(goal->at);
    return explained(descent, *start, *goal, std::move(text), budget);
  }

 private:
  PlanningFailure stopped(const Budget& budget, std::int64_t steps) const {
    if (budget.canceled()) return failure(Status::canceled, fmt::format("canceled after {}", counted(steps, "step")));
    return failure(Status::timed_out, fmt::format("the {:g} s of its budget were over after {}", budget.limits().seconds.value_or(0.0), counted(steps, "step")));
  }

  PlanningFailure trapped(const Descent& descent, Vec2 goal, std::vector<std::string> text, std::string_view name, const Budget& budget) const {
    if (descent.ended == DescentEnd::canceled || descent.ended == DescentEnd::timed_out) return stopped(budget, descent.steps);
    const std::string where = fmt::format("{}, {:.3f} m from the goal", place(descent.last), distance(descent.last, goal));
    std::string reason;
    switch (descent.ended) {
      case DescentEnd::local_minimum: reason = fmt::format("{} is trapped in a local minimum at {}: attraction and repulsion cancel there", name, where); break;
      case DescentEnd::oscillation: reason = fmt::format("{} goes to and fro about {}, and gets no nearer", name, where); break;
      case DescentEnd::blocked: reason = fmt::format("a step of {} leads to {}, where the disc cannot stand", name, where); break;
      default: reason = fmt::format("{} did not reach the goal in {}: it came to {}", name, counted(descent.steps, "step"), where); break;
    }
    PlanningFailure failed = failure(Status::no_path, reason, make_pose(descent.last, 0.0));
    Alternative tried;
    tried.name = std::string{name};
    tried.outcome = reason + ".";
    tried.poses = picture_of(descent.points);
    failed.alternatives.push_back(std::move(tried));
    failed.explanation = std::move(text);
    failed.explanation.push_back(reason + ".");
    return failed;
  }

  PlanningResult explained(const Descent& descent, const PlaneEnd& start, const PlaneEnd& goal, std::vector<std::string> text, Budget& budget) const {
    Planned planned;
    const std::vector<Vec2> points = thinned_way(space_, descent.points, thinning);
    planned.path = rounded_path(space_, start, points, goal);
    if (planned.path.pieces.empty()) return tl::unexpected{failure(Status::no_path, "start and goal are the same place, there is nothing to drive")};
    if (start.run != 0 || goal.run != 0) text.push_back(run_sentence(space_, start, goal));
    text.push_back(driving_sentence(space_.problem(), planned.path));
    if (std::string bound = bound_sentence(least_length(space_, budget), length(planned.path)); !bound.empty()) text.push_back(std::move(bound));
    planned.explanation = std::move(text);
    return planned;
  }

  PlaneSpace space_;
};

FieldPlanner FieldPlanner::prepared(const Problem& problem) const {
  FieldPlanner planner = *this;
  planner.ready_ = std::make_shared<const Ready>(problem);
  return planner;
}

PlanningResult FieldPlanner::plan(const Problem& problem, Budget& budget) const {
  if (ready_ && ready_->is_for(problem)) return ready_->plan(options_, name_, budget);
  return Ready{problem}.plan(options_, name_, budget);
}

}  // namespace waywright
