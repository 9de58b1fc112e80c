// Where a disc's middle can be, as polygons: the area around a place, with its holes.
#pragma once

#include <functional>
#include <string>

#include "waywright/core/result.hpp"
#include "waywright/geometry/boolean.hpp"

namespace waywright {

/// m: the arcs about corners are replaced by edges that are farther out, by no more than this.
constexpr double free_region_tolerance = 5e-4;

/// All that keeps `distance` (and at most the tolerance more) from the obstacles and the boundary and is joined to `at`. No corner of it is straight. The failure says
/// what is in the way; `stops`, asked again and again, ends it early. @pre rings simple, counter-clockwise; distance > 0
tl::expected<Region, std::string> free_region(const Ring& boundary, const std::vector<Ring>& obstacles, double distance, Vec2 at, const std::function<bool()>& stops = {});

}  // namespace waywright
