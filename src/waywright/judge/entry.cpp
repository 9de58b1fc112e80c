#include "waywright/judge/entry.hpp"

#include <fmt/format.h>

#include <cmath>

namespace waywright {
namespace {

constexpr double estimated = 0.1;  // 1/m, of the curvature of poses from outside; that of curves is held exactly by the proof

}  // namespace

bool can_be_entered(const Problem& problem, const std::vector<Sample>& samples, SpeedWorkspace& workspace, const LimitsAlong& along) {
  const auto& motion = problem.motion();
  return !motion || can_start_with(samples, problem.vehicle(), motion->speed, workspace, along);
}

std::optional<Violation> check_entry(const Problem& problem, const std::vector<Sample>& samples, SpeedWorkspace& workspace, const LimitsAlong& along) {
  const auto& motion = problem.motion();
  const Vehicle& vehicle = problem.vehicle();
  if (motion && vehicle.stands_at_curvature_jumps() && std::abs(samples.front().curvature - motion->curvature) > estimated) {
    return Violation{fmt::format("the vehicle's way has a curvature of {:.3f} 1/m when the plan begins, and that of the poses is about {:.3f} 1/m",
                                 motion->curvature, samples.front().curvature),
                     problem.first_pose()};
  }
  if (can_be_entered(problem, samples, workspace, along)) return std::nullopt;
  return Violation{fmt::format("the vehicle begins at {:.4g} m/s, and the path can surely be driven within the vehicle's limits from up to {:.4g} m/s only",
                               motion->speed, greatest_start_speed(samples, vehicle, workspace, along)),
                   problem.first_pose()};
}

}  // namespace waywright
