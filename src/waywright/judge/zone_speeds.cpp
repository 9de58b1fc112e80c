#include "waywright/judge/zone_speeds.hpp"

#include <fmt/format.h>

#include <cmath>

#include "waywright/speed/zone_speed.hpp"

namespace waywright {

std::optional<std::string> check_zone_speeds(const Problem& problem, const std::vector<PoseSpeed>& speeds) {
  constexpr double slack = 1e-3;  // share of the speed
  if (!problem.zones().limits_speed()) return std::nullopt;
  for (const PoseSpeed& at : speeds) {
    const ZoneRules::SpeedLimit* zone = slowest_zone_at(problem, at.pose);
    if (zone == nullptr || std::abs(at.speed) <= zone->speed * (1.0 + slack)) continue;
    return fmt::format("in {} at ({:.3f}, {:.3f}) the vehicle drives {:.4g} m/s, and at most {:.4g} m/s are allowed", zone->title, at.pose.x, at.pose.y, std::abs(at.speed), zone->speed);
  }
  return std::nullopt;
}

}  // namespace waywright
