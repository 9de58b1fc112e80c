// Chains of points: fewer of them, closed, joined.
#pragma once

#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright::dxf {

/// Douglas and Peucker: some of the points, first and last among them; no point left out is farther than `tolerance` from its chord.
Polyline simplified(const Polyline& line, double tolerance);

struct Joined {
  std::vector<Polyline> closed;  ///< the first point is not repeated
  std::vector<Polyline> open;
  double widest_gap = 0.0;  ///< m, that was closed
};

/// Joins lines end to end where exactly two ends meet within rounding, and then where exactly two of those left are within `gap` of each other.
Joined joined(std::vector<Polyline> lines, double gap);

}  // namespace waywright::dxf
