// Places on a plan that a reader looks for first: where it is tight, where it touches, where the vehicle
// stops.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waywright/judge/plan.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

struct Spot {
  Pose pose{};             ///< of the vehicle
  Vec2 point{};            ///< of what stands nearest there
  double clearance = 0.0;  ///< m, at the pose itself, without the pose error
  std::string against;     ///< its name
};

/// At a station the gap at the shelf is chosen, and mostly the least clearance. This is the tightest sample
/// off the straight stretch at the shelf; empty where the stretch is not the tightest, or there is none.
std::optional<Spot> tightest_off_straight(const Problem& problem, const Plan& plan);

/// Where what was tried in vain first comes nearer than it may to each thing that it meets; of an end that
/// cannot be, that end.
std::vector<Spot> blocked_spots(const Problem& problem, const Plan& plan);

/// Of a mission in legs: the samples with which a leg after the first begins.
std::vector<std::size_t> leg_borders(const Plan& plan);

/// Places between changes of direction where the curvature jumps and the vehicle stands still. Sample
/// indices.
std::vector<std::size_t> steering_stops(const Plan& plan);

}  // namespace waywright
