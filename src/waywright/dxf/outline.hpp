// Curves as they survive every insertion of a block, and the chords that stand for them, on the curve or to one side of it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright::dxf {

/// A corner on the line (weight 0), or what lies between two corners: one control point of a piece of a conic (weight above 0: the rational
/// quadratic Bézier curve of both corners, which every arc of at most 90° and of an ellipse is, cosine of half of its angle), or control
/// points (weight under 0) of a flat piece of which nothing is known but that it lies within their hull.
/// Scaling, turning, mirroring and shearing the points does the same to the curve.
struct Knot {
  Vec2 at{};
  double weight = 0.0;
};
using Chain = std::vector<Knot>;  ///< begins with a corner, and ends with one unless it is closed

/// Between two corners: within the hull of these and the control points.
inline constexpr double within_hull = -1.0;

Chain chain_of(const Polyline& line);

/// An arc from its last corner on; `bulge` is the tangent of a quarter of its angle, counter-clockwise positive.
/// @pre the chain is not empty
void add_arc(Chain& chain, Vec2 to, double bulge);

/// Part of an ellipse: centre + cos(u) · `major` + sin(u) · `minor`, for u from `from` over `sweep` rad, 0 < sweep ≤ 2π. A whole turn ends
/// where it begins.
Chain elliptic_arc(Vec2 center, Vec2 major, Vec2 minor, double from, double sweep);

enum class Side {
  on,    ///< corners on the curve
  left,  ///< the curve is nowhere to the left of the chords, looking along it
  right  ///< nowhere to the right
};

/// Chords whose points are within the tolerance of the curve, and the curve within it of them (of pieces known by their hull: as flat as they came).
/// @param closed  the curve goes on from the last knot to the first
/// @return empty where it takes more than `most` points
std::optional<Polyline> chords_of(const Chain& chain, bool closed, Side side, double tolerance, std::size_t most);

/// Area enclosed by a closed chain in m², positive for counter-clockwise; exact up to rounding but for pieces known by their hull, whose chord counts.
double signed_area(const Chain& chain);

}  // namespace waywright::dxf
