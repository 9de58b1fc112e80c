// Shortens a way between states by motions of the same steering between places on it.
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/path/path.hpp"
#include "waywright/planner/steering/arc_motion.hpp"
#include "waywright/planner/steering/steering.hpp"

namespace waywright {

/// First the curve from end to end, then `attempts` between places drawn by `seed`; each is taken where it is
/// shorter and free. What is kept of the path has been tested before, so that the whole stays free at every
/// step. Ends early where the test's limits are spent. Same arguments, same bits. @pre the steering is one of curves
///
/// Law: never longer than `path`; ends where it ends, up to 1e-9; where the curve from end to end is free,
/// that curve.
Path shortened(const Path& path, const Steering& curves, MotionTest& test, int attempts, std::uint64_t seed);

/// The same of any symmetric steering, over the states of a way. Parts of its motions are motions themselves.
///
/// Law: never costs more; the same ends.
std::vector<Pose> shortened(std::vector<Pose> states, const Steering& steering, MotionTest& test, int attempts, std::uint64_t seed);

/// What a way along states costs, m.
double cost_of(const Steering& steering, const std::vector<Pose>& states);

}  // namespace waywright
