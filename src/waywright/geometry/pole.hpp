// The point inside a polygon that is farthest from its outline: where a name stands best.
#pragma once

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// The pole of inaccessibility, the middle of the largest disc that the ring's area holds: a point whose distance from the outline is the greatest less at most `precision` (m, > 0).
/// Where the centre of area is as good, that point. Of more than some thousand cells looked at, the best found. A ring without area gives the mean of its corners.
/// Quadtree of cells with upper bounds, after Agafonkin's polylabel (2016). @pre not empty
Vec2 pole_of_inaccessibility(const Ring& ring, double precision);

}  // namespace waywright
