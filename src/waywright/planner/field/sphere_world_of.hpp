// From a map to a world of discs that covers all that is blocked in it.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "waywright/core/result.hpp"
#include "waywright/planner/field/sphere_world.hpp"
#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

/// The smallest circle around points. @pre not empty
Disc enclosing_disc(const std::vector<Vec2>& points);

struct CoveringWorld {
  SphereWorld world;               ///< for the disc's middle: obstacles grown, the outside drawn in by what it needs
  std::vector<std::string> names;  ///< of the obstacles, in order
  Vec2 goal{};                     ///< the first of the goals that is free in it
};

/// Every polygon by the smallest circle around it, what is outside by the greatest circle about the middle of the boundary that touches none of its edges (around all
/// that there is, where nothing bounds the map). The failure says what does not fit: discs that meet, what lies beyond the outer one, a start or goal inside one,
/// walls, scan points and cells, which are no discs. Any of the goals will do.
/// @pre there is a goal
tl::expected<CoveringWorld, std::string> covering_world(const PlaneSpace& space, Vec2 start, std::span<const Vec2> goals);
inline tl::expected<CoveringWorld, std::string> covering_world(const PlaneSpace& space, Vec2 start, Vec2 goal) { return covering_world(space, start, std::span{&goal, 1}); }

}  // namespace waywright
