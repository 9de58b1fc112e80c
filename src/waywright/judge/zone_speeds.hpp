// Speeds that others claim, held against the zones that limit them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waywright/scenario/problem.hpp"

namespace waywright {

/// A pose of the vehicle's origin and how fast it is there.
struct PoseSpeed {
  Pose pose{};
  double speed = 0.0;  ///< m/s; its sign does not matter
};

/// The first of them, in words, that is faster than a zone allows which the footprint touches there (a thousandth for rounding).
std::optional<std::string> check_zone_speeds(const Problem& problem, const std::vector<PoseSpeed>& speeds);

}  // namespace waywright
