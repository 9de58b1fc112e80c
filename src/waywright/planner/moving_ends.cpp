#include "waywright/planner/moving_ends.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "waywright/proof/moving_clearance.hpp"

namespace waywright {
namespace {

std::string too_near(const Problem& problem, const char* end, const Pose& pose, const std::string& who) {
  const double required = problem.required_clearance();
  return fmt::format("at the {} pose ({:.3f}, {:.3f}, {:.4f} rad) {} {}", end, pose.x, pose.y, pose.heading, who,
                     required > 0.0 ? fmt::format("is nearer to the footprint than the {:.4f} m that are required", required) : std::string{"touches the footprint"});
}

/// Does it keep the pose from some time on, for ever? Since when.
std::optional<double> stays_at(const MovingClearance& clearance, const Pose& pose, std::size_t obstacle) {
  std::vector<TimeSpan> spans;
  clearance.blocked(pose, pose, obstacle, 0.0, MovingClearance::for_ever, spans);
  if (spans.empty() || !std::isinf(spans.back().end)) return std::nullopt;
  return spans.back().begin;
}

Failure at_goal(const Problem& problem, std::size_t obstacle, double since, const std::string& more) {
  Failure failure;
  failure.status = Status::goal_in_collision;
  failure.pose = problem.last_pose();
  failure.reason = fmt::format("{} from {:.2f} s after the start on, for good{}", too_near(problem, "goal", problem.last_pose(), who_moves(problem.scenario().moving[obstacle], obstacle)), since, more);
  return failure;
}

}  // namespace

std::string who_moves(const MovingObstacle& obstacle, std::size_t index) {
  return obstacle.name.empty() ? fmt::format("moving obstacle {} of the scenario's list", index + 1) : fmt::format("{} (moving obstacle {})", one_line(obstacle.name), index + 1);
}

std::optional<Failure> moving_at_ends(const Problem& problem) {
  const std::vector<MovingObstacle>& moving = problem.scenario().moving;
  if (moving.empty()) return std::nullopt;
  const double required = problem.required_clearance();
  const MovingClearance clearance{problem, required, 0.0};
  for (std::size_t o = 0; o < moving.size(); ++o) {
    const Pose& start = problem.first_pose();
    if (clearance.distance_at(start, o, 0.0, required + 1.0) > required) continue;
    std::vector<TimeSpan> spans;
    clearance.blocked(start, start, o, 0.0, MovingClearance::for_ever, spans);
    Failure failure;
    failure.status = Status::start_in_collision;
    failure.pose = start;
    failure.reason = too_near(problem, "start", start, who_moves(moving[o], o)) + " when the plan begins, ";
    failure.reason += spans.empty() || !std::isinf(spans.front().end) ? fmt::format("until {:.2f} s after it", spans.empty() ? 0.0 : spans.front().end) : std::string{"and stays there for good"};
    return failure;
  }
  if (problem.free_goal() != nullptr) return std::nullopt;
  for (std::size_t o = 0; o < moving.size(); ++o) {
    // What the bounds take for a contact and is none is left to the proof.
    const auto since = stays_at(clearance, problem.last_pose(), o);
    if (since && *since == 0.0 && clearance.distance_at(problem.last_pose(), o, 0.0, required + 1.0) <= required) return at_goal(problem, o, 0.0, "");
  }
  return std::nullopt;
}

std::optional<Failure> moving_at_goal(const Problem& problem, const Plan& plan) {
  if (!plan.hindrance || plan.hindrance->kind != Hindrance::Kind::stands || problem.free_goal() != nullptr) return std::nullopt;
  const std::size_t o = plan.hindrance->obstacle;
  const double required = problem.required_clearance();
  const MovingClearance clearance{problem, required, 0.0};
  const auto since = stays_at(clearance, problem.last_pose(), o);
  if (!since || clearance.distance_at(problem.last_pose(), o, *since + 1.0, required + 1.0) > required) return std::nullopt;
  return at_goal(problem, o, *since, fmt::format(", and the vehicle is there after {:.2f} s at the soonest", plan.metrics.travel_time));
}

}  // namespace waywright
