// From a map to a world of stars.
#pragma once

#include <string>

#include "waywright/core/result.hpp"
#include "waywright/planner/field/star_world.hpp"
#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

/// Every polygon, grown by what the disc needs, from the middle of the largest circle in its kernel; the boundary drawn in likewise. The failure says what is no star
/// (with its name), what touches what, and that walls, scan points and cells are none.
tl::expected<StarWorld, std::string> star_world(const PlaneSpace& space);

/// m, from a place to the nearest edge of the polygons that it was made of, less what they were grown by; of the boundary too.
class RimDistance {
 public:
  explicit RimDistance(const PlaneSpace& space) : space_{space} {}
  double at(Vec2 q) const;

 private:
  const PlaneSpace& space_;
};

}  // namespace waywright
