// Shortens a path of lines and arcs by Reeds–Shepp curves between places on it.
#pragma once

#include <cstdint>

#include "waywright/path/path.hpp"
#include "waywright/planner/steering/arc_motion.hpp"
#include "waywright/planner/steering/reeds_shepp.hpp"

namespace waywright {

/// First the curve from end to end, then `attempts` between places drawn by `seed`; each is taken where it is
/// shorter and free. What is kept of the path has been tested before, so that the whole stays free at every
/// step. Ends early where the test's limits are spent. Same arguments, same bits.
///
/// Law: never longer than `path`; ends where it ends, up to 1e-9; where the curve from end to end is free,
/// that curve.
Path shortened(const Path& path, const ReedsShepp& curves, MotionTest& test, int attempts,
               std::uint64_t seed);

}  // namespace waywright
