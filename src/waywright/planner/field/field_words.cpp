#include "waywright/planner/field/field_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "waywright/planner/field/navigation_descent.hpp"
#include "waywright/planner/field/star_world_of.hpp"
#include "waywright/planner/grid/grid_words.hpp"

namespace waywright {
namespace {

using grid::counted;
using grid::failure;
using grid::place;

std::vector<Pose> picture_of(const std::vector<Vec2>& points) {
  std::vector<Pose> poses;
  const std::size_t every = std::max<std::size_t>(1, points.size() / 2000);
  for (std::size_t i = 0; i + 1 < points.size(); i += every) poses.push_back(make_pose(points[i], angle_of(points[i + 1] - points[i])));
  return poses;
}

std::string beside(const PlaneSpace& space, Vec2 q) {
  const auto nearest = nearest_polygon(space, q);
  if (!nearest) return {};
  return fmt::format(", {:.3f} m from the rim of {}", std::max(0.0, nearest->distance), nearest->obstacle ? fmt::format("obstacle {}", *nearest->obstacle) : std::string{"the boundary"});
}

}  // namespace

std::string end_of_descent(const Descent& descent, Vec2 goal, const PlaneSpace& space, const Budget& budget, std::string_view who) {
  const Vec2 at = descent.minimum.value_or(descent.last);
  const std::string where = fmt::format("{}, {:.3f} m from the goal", place(at), distance(at, goal));
  switch (descent.ended) {
    case DescentEnd::local_minimum:
      return fmt::format("{} is trapped in a local minimum at {}{}", who, where, who == "potential_field" ? ": attraction and repulsion cancel there" : "");
    case DescentEnd::oscillation: return fmt::format("{} goes to and fro about {}, and gets no nearer", who, where);
    case DescentEnd::stalled:
      return fmt::format("{} stalls at {}{}: {} led no farther, though by its gradient and Hessian the field has no minimum there", who, where, beside(space, descent.last), counted(DescentOptions{}.window, "step"));
    case DescentEnd::blocked: return fmt::format("a step of {} leads to {}, where the disc cannot stand", who, where);
    default: break;
  }
  if (is_used_up(budget))
    return fmt::format("the limit of {} was reached before the goal: {} came to {}", counted(budget.limits().evaluations.value_or(0), "evaluation"), who, where);
  return fmt::format("{} did not reach the goal in {}: it came to {}", who, counted(descent.steps, "step"), where);
}

PlanningFailure stopped(const Budget& budget, std::int64_t steps) {
  if (budget.canceled()) return failure(Status::canceled, fmt::format("canceled after {}", counted(steps, "step")));
  return failure(Status::timed_out, fmt::format("the {:g} s of its budget were over after {}", budget.limits().seconds.value_or(0.0), counted(steps, "step")));
}

PlanningFailure not_at_goal(const Descent& descent, Vec2 goal, const PlaneSpace& space, std::vector<std::string> text, std::string_view name, const Budget& budget) {
  if (descent.ended == DescentEnd::canceled || descent.ended == DescentEnd::timed_out) return stopped(budget, descent.steps);
  const std::string reason = end_of_descent(descent, goal, space, budget, name);
  PlanningFailure failed = failure(Status::no_path, reason, make_pose(descent.minimum.value_or(descent.last), 0.0));
  Alternative tried;
  tried.name = std::string{name};
  tried.outcome = reason + ".";
  tried.poses = picture_of(descent.points);
  failed.alternatives.push_back(std::move(tried));
  failed.explanation = std::move(text);
  failed.explanation.push_back(reason + ".");
  return failed;
}

}  // namespace waywright
