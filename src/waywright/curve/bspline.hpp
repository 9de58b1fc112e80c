// Cubic B-splines as Bézier spans.
#pragma once

#include <span>

#include "waywright/curve/curve.hpp"

namespace waywright {

/// The clamped uniform cubic B-spline with these control points (knots 0, 0, 0, 0, 1, 2, …, m, m, m, m with m = points − 3), exactly, one span between
/// neighbouring knots: C² where they meet. It begins at the first point towards the second, and ends at the last one, coming from the one before.
/// @pre at least 4 points
Spans bspline_spans(std::span<const Vec2> points);

}  // namespace waywright
