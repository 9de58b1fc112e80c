// What single entities are.
#pragma once

#include <string>

#include "waywright/dxf/drawing.hpp"
#include "waywright/dxf/groups.hpp"
#include "waywright/dxf/outline.hpp"
#include "waywright/dxf/spline.hpp"

namespace waywright::dxf {

/// LINE, LWPOLYLINE, POLYLINE (no mesh), ARC, CIRCLE, ELLIPSE, SPLINE, SOLID, TRACE.
bool is_outline(const Item& entity);
bool is_curved(const Item& entity);  ///< made of arcs wholly or in part, or a spline

/// In capitals; names in DXF differ by more than that or are the same.
std::string capitals(std::string_view text);
std::string layer_of(const Item& entity);  ///< in capitals, "0" where none is given

/// Every number that places the entity is finite and of a size that can be worked with; else a sentence.
std::optional<InputError> check_numbers(const Item& entity, const std::string& file);

double number(const Item& entity, int code, double otherwise);
int whole_number(const Item& entity, int code, int otherwise);

/// Of ARC, CIRCLE, ELLIPSE and polylines with bulges: the curve in the coordinates that the entity's points have. Closed ones end at the
/// corner at which they begin.
Chain curve_of(const Item& entity);

SplineCurve spline_of(const Item& entity);
std::vector<Vec2> fit_points_of(const Item& entity);

}  // namespace waywright::dxf
