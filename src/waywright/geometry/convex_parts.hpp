// A simple polygon as a union of convex ones, so that swept areas can be bounded by convex hulls.
#pragma once

#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// Convex rings whose union is the ring's area: the ring itself where it is convex, else triangles by ear clipping; where
/// rounding leaves no ear, the hull of the rest, so that the union never is less than the area.
/// @pre simple, counter-clockwise
std::vector<Ring> convex_parts(const Ring& ring);

}  // namespace waywright
