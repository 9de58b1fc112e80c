// What moves and then stands in the way becomes an obstacle that stays.
#pragma once

#include <atomic>

#include "waywright/planner/registry.hpp"

namespace waywright {

/// A convex polygon that holds a footprint at a pose, grown by `room` m.
Ring outline_that_holds(const Footprint& footprint, const Pose& pose, double room = 0.0);

/// Pieces one after another.
Path joined(Path first, const Path& then);

/// The path up to `s` m, then the way of another plan: what the scenario's planner finds from where that leaves it.
struct WayOn {
  double s = 0.0;      ///< m of the path that is kept
  Plan plan;           ///< from there on, of a problem of its own in which nothing moves
  Path whole;
};
/// The path up to `s` m; of no length worth it empty, which is where the problem begins.
Path kept_until(const Path& path, double s);
/// Plans on from the end of what is kept, at which the vehicle stands. `mission`: where to; `more`: obstacles beside the problem's. Errors as of solve().
Parsed<WayOn> detour(const Problem& problem, Path kept, const Mission& mission, const std::vector<Ring>& more, const std::atomic<bool>* cancel);

/// Of a plan that is hindered by what stands in its way: it waits there as long as the obstacle's patience says, then goes on by a way around it. By what comes to meet it: a way
/// beside what it is predicted to sweep until then. Any other plan, and one that nothing is found for, is returned as it is. Errors as of solve().
Parsed<Plan> led_around(const Problem& problem, Plan plan, const std::atomic<bool>* cancel = nullptr);

}  // namespace waywright
