// Polygons out of an SVG drawing, as Bench-MR keeps its scenes: outlines of straight lines.
//
// Taken: `path` (M L H V Z and their small letters), `polygon`, `polyline`, `line`, `rect`, in groups with any transform. What SVG would fill is solid, closed or not; what
// it would not (`fill: none`) is a wall without width. Curves, `use` and outlines with holes are refused: what cannot be read may be an obstacle.
#pragma once

#include <string>

#include "waywright/core/result.hpp"
#include "waywright/map/map.hpp"

namespace waywright {

/// `scale`: m a user unit. x to the right, y upwards, from the lower left corner of the viewBox; where there is none, from the drawing's own origin. What was left out
/// (hidden elements, texts) is in the notes.
Parsed<Map> decode_svg_map(const std::string& bytes, const std::string& name, double scale);

}  // namespace waywright
