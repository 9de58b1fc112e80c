// An outline with fewer corners that holds all of what it held: corners are left out only where the chord that takes their place lies outside.
//
// This is what the usual simplification of polylines (Ramer 1972; Douglas and Peucker 1973) does not promise: its chords cut through what they are to go around.
//
// Laws. Of an outline O (simple, counter-clockwise) and the answer A:
//   A's corners are corners of O, in the same order; A is simple; the area of O lies in that of A;
//   no point of A's area is farther from O's than the tolerance.
// How: a chord takes the place of a chain of edges where (1) no corner of the chain is on the chord's outer side, (2) none is farther from its line than the tolerance,
// and (3) the chord meets no other edge of O. By (1) and (3) chord and chain enclose an area beside O, without anything of O in it. A line from a point in there away
// from the chord, square to it, leaves that area through the chain, by (2) within the tolerance. Two chords do not meet: one that entered the other's area would have to
// leave it through the other's chain, which (3) excludes. All of this is decided by whole numbers but for (2), which is rounded to the safe side.
#pragma once

#include <vector>

#include "waywright/map/cell_pieces.hpp"

namespace waywright {

struct OutwardOutline {
  std::vector<HalfCell> corners;
  double reached = 0.0;  ///< half cells: greatest distance of a corner that was left out from its chord
};

/// From each corner the farthest that a chord can reach. `tolerance` in half cells, ≥ 0. @pre the first corner is one of the outline's convex hull; coordinates within ±2¹⁶
OutwardOutline outward_outline(const std::vector<HalfCell>& outline, double tolerance);

/// Twice the area in square half cells; positive for counter-clockwise.
std::int64_t doubled_area(const std::vector<HalfCell>& outline);

}  // namespace waywright
