// From a map to a world of stars.
#pragma once

#include <string>

#include "waywright/core/result.hpp"
#include "waywright/planner/field/star_world.hpp"
#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

/// Where every polygon, grown by what the disc needs, is seen whole from a place in it, the boundary from one too, and all are apart: from the middle of the largest circle
/// in the kernel of each. Else the area in which the disc's middle can be, joined to the start, whose rims, whatever their shape, are trees of stars. The failure says what
/// stands against it: walls, scan points and cells; start and goal in areas apart; what cannot be cut or drawn in.
tl::expected<StarWorld, std::string> star_world(const PlaneSpace& space, Vec2 start, Vec2 goal);

/// m, from a place to the nearest edge of the polygons that it was made of, less what they were grown by; of the boundary too. With trees also to the rims that those have.
class RimDistance {
 public:
  RimDistance(const PlaneSpace& space, const StarWorld& world) : space_{space}, world_{world} {}
  double at(Vec2 q) const;

 private:
  const PlaneSpace& space_;
  const StarWorld& world_;
};

}  // namespace waywright
