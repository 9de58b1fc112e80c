// The field that a planner goes down, in the picture of its plan.
#pragma once

#include <vector>

#include "waywright/judge/field_picture.hpp"
#include "waywright/report/scene_parts.hpp"

namespace waywright {

/// Values as tints, contours and streamlines: to be drawn under all else, so that the map lies over it. Within a size of its own whatever the field: of too many lines
/// the finest detail is left out, then every second contour.
void draw_field(SvgWriter& svg, const FieldPicture& field);
/// The trap, minima, saddles; of those that would hide each other the first in this order.
void draw_field_marks(SvgWriter& svg, const FieldPicture& field);
std::vector<LegendEntry> field_legend(const FieldPicture& field, const View& view);

}  // namespace waywright
