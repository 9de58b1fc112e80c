// Where a straight way lies inside a ring.
#pragma once

#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// A part of a straight way, in shares of it from its beginning.
struct WayPart {
  double begin = 0.0, end = 0.0;
};

/// The parts of the way from `from` to `to` whose points lie inside the ring and more than `depth` m from its outline, in order. Decided exactly (up to rounding): what is
/// nearer than that to an edge is an interval of the way. Where both points are the same, one stretch from 0 to 1 or none.
/// @pre depth > 0
std::vector<WayPart> stretches_deeper_than(const Ring& ring, double depth, Vec2 from, Vec2 to);

/// Appends the shares of the way, between its ends, at which it may cross the outline: every true crossing is among them.
void add_crossings(const Ring& ring, Vec2 from, Vec2 to, std::vector<double>& shares);

/// Distance of a point inside the ring from its outline, m; 0 where it is not inside.
inline double depth_in(const Ring& ring, Vec2 point) { return inner_radius(ring, point); }

}  // namespace waywright
