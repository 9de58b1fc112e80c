// Where a path's speed is limited by zones.
#pragma once

#include <optional>
#include <vector>

#include "waywright/scenario/problem.hpp"
#include "waywright/speed/speed.hpp"

namespace waywright {

/// The least limit of the zones that the footprint may touch: on each step between samples (what it sweeps on the straight motion between them, grown by `tolerance` m, by which
/// the true motion may leave that, and by the pose error), and at each sample. So a limit holds by at most a step, 5 cm, longer than it has to. Empty where no zone limits speed.
LimitsAlong zone_limits(const Problem& problem, const std::vector<Sample>& samples, double tolerance);

/// The slowest zone that the footprint touches at a pose; nullptr: none.
const ZoneRules::SpeedLimit* slowest_zone_at(const Problem& problem, const Pose& pose);

}  // namespace waywright
