#include "waywright/judge/entry.hpp"

#include <fmt/format.h>

namespace waywright {

bool can_be_entered(const Problem& problem, const std::vector<Sample>& samples, SpeedWorkspace& workspace) {
  const auto& motion = problem.motion();
  return !motion || can_start_with(samples, problem.vehicle(), motion->speed, workspace);
}

std::optional<Violation> check_entry(const Problem& problem, const std::vector<Sample>& samples, SpeedWorkspace& workspace) {
  if (can_be_entered(problem, samples, workspace)) return std::nullopt;
  return Violation{fmt::format("the vehicle begins at {:.4f} m/s, and from more than {:.4f} m/s the path cannot be driven within the vehicle's limits",
                               problem.motion()->speed, greatest_start_speed(samples, problem.vehicle(), workspace)),
                   problem.first_pose()};
}

}  // namespace waywright
