// From a map to a world of stars.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include "waywright/core/result.hpp"
#include "waywright/planner/field/star_world.hpp"
#include "waywright/planner/field/tree_world.hpp"
#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

/// Where every polygon, grown by what the disc needs, is seen whole from a place in it, the boundary from one too, and all are apart: stars, each about the middle of the
/// largest circle in its kernel. Else the area in which the disc's middle can be, joined to the start, whose rims, whatever their shape, are trees of stars. The failure says
/// what stands against it: walls, scan points and cells; start and goal in areas apart; what cannot be cut or drawn in.
using StarsOrTrees = std::variant<StarWorld, TreeMap>;
tl::expected<StarsOrTrees, std::string> stars_or_trees(const PlaneSpace& space, Vec2 start, Vec2 goal, const std::function<bool()>& stops = {});
/// Trees alone, with all grown by `spare` metres more.
tl::expected<TreeMap, std::string> trees_with(const PlaneSpace& space, Vec2 start, Vec2 goal, double spare, const std::function<bool()>& stops = {});

/// The obstacle (by its number in the map; none: the boundary) whose edge is nearest to a place, and m to it less what all was grown by. Empty of a map without polygons.
struct NearestPolygon {
  double distance = 0.0;
  std::optional<std::size_t> obstacle;
};
std::optional<NearestPolygon> nearest_polygon(const PlaneSpace& space, Vec2 q);

/// m, from a place to the nearest edge of the map's polygons, less what they were grown by; of the boundary too.
double distance_to_polygons(const PlaneSpace& space, Vec2 q);

}  // namespace waywright
