// Lines of equal value over a grid of values.
//
// Source: W. E. Lorensen, H. E. Cline: Marching cubes, SIGGRAPH 1987, in the plane; where two corners of a square across from each other are above the level and two
// are not, the mean of the four says which are joined.
#pragma once

#include <span>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

struct ContourLine {
  Polyline points;         ///< in steps of the grid: node (column, row) lies at (column, row)
  bool is_closed = false;  ///< from the last point back to the first
};

/// The level's lines over nodes `values[row · columns + column]`. What is not finite is no node: lines end at squares with such a corner, and at the grid's rim.
///
/// Laws: values on the left of a line (x to the right, y up) are no less than the level, on its right less; every point lies on an edge of the grid, each edge holds at
/// most one; a line that is not closed begins and ends on edges of one square alone. So lines of one level do not cross, and those of another level keep apart.
/// @pre values.size() = columns · rows
std::vector<ContourLine> contour_lines(std::span<const double> values, int columns, int rows, double level);

/// Fewer points: all that are left out lie within `tolerance` of the lines between those that are kept. Both ends are kept.
/// (Ramer 1972; Douglas and Peucker 1973.)
Polyline simplified(const Polyline& line, double tolerance);

}  // namespace waywright
