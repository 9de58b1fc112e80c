// What is left of a plan, held against what has appeared on it: how much of it is free, and where the vehicle can stop.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "waywright/judge/plan.hpp"
#include "waywright/scenario/problem.hpp"
#include "waywright/scenario/seen_obstacles.hpp"

namespace waywright {

/// Where the vehicle is on a plan after some seconds, and the way from there on.
struct RestOfPlan {
  Path path;              ///< the same curves; of a turn on the spot what is left of it
  Pose pose{};
  StartMotion motion;
  double driven = 0.0;    ///< m
  Path stopping{};        ///< where it turns on the spot: what it turns on by until it is at rest, the beginning of `path`; else empty
  double turning = 0.0;   ///< rad/s, at most, at which it turns then
};
/// Empty where the vehicle is in a shelf's pocket then. @pre the plan is solved, its samples are its path's; 0 ≤ t < their end
std::optional<RestOfPlan> rest_of(const Plan& plan, const Problem& problem, double t);

/// s after which the vehicle has first come `s` metres far. @pre the samples carry t and speed
double time_at(const std::vector<Sample>& samples, double s);

/// What stands still, held against a way. Law: `clearance` is a lower bound over the continuous motion, the pose error taken off.
struct HeldAgainst {
  bool is_free = false;        ///< by the scenario's clearance, at every pose within the pose error
  double clearance = 0.0;      ///< m
  std::int64_t queries = 0;
};
HeldAgainst held_against(const Map& still, const Problem& problem, const Path& way, const std::atomic<bool>* cancel);

/// Stretches of a way on which something is too near, by looking at its samples.
struct Blocked {
  struct Stretch {
    double begin = 0.0, end = 0.0;  ///< m, of places that are free, before and behind it
    double near = 0.0;              ///< m, of the first place that is not
  };
  std::vector<Stretch> stretches;
  bool ends_blocked = false;  ///< the last one reaches to the end of the way
  std::size_t obstacle = 0;   ///< source of `still`'s world, of the first
  std::string name;           ///< likewise, "obstacle 0"
};
Blocked blocked_stretches(const Map& still, const Problem& problem, const std::vector<Sample>& way);

/// m along the way after which the vehicle can stand, braking as hard as its limits allow: of the problem's start. Empty where the way's limits leave no such place.
std::optional<double> braking_distance(const Problem& problem, const std::vector<Sample>& way);

}  // namespace waywright
