// Where a taut way of a disc can end on the edge of a region, but for where it comes straight at it.
#pragma once

#include <vector>

#include "waywright/planner/plane/plane_space.hpp"
#include "waywright/planner/plane/plane_target.hpp"

namespace waywright {

/// The region's corners, and where its edge comes as near to an obstacle as `radius`: a way that slides along an obstacle into the region ends there. Of the latter only
/// those that keep more than `margin`. Of a point that point. @pre margin < radius
std::vector<Vec2> region_ends(const PlaneSpace& space, const PlaneTarget& target, double radius, double margin);

}  // namespace waywright
