// A grid of cells as polygons that hold every blocked cell and keep within a tolerance of them.
//
// Planners that go from corner to corner (visibility graphs) want few corners, and a wall across a grid has two at every step. The usual ways (contours, then Douglas
// and Peucker's simplification, as OpenCV's approxPolyDP does it) cut corners on either side, so that a path free of the polygons may cross an obstacle. Here cells
// become pieces without holes (cell_pieces), and outlines lose corners outwards alone (outward_outline).
//
// Laws: every blocked cell lies in the union of the polygons, and, dilated, every point within `dilate` of one; no point of a polygon is farther than the tolerance from
// a cell that is blocked (or covered by the dilation). So free space loses at most a margin of that width: places that are farther than it from everything stay free, and
// ways between them along such places stay open. All of this is meant in the grid's own frame; the corners in the world are rounded like those of cells.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/map/map.hpp"

namespace waywright {

struct TraceOptions {
  double tolerance = 0.0;  ///< m, at least half a cell
  /// Of a polygon's outline in cells: its own tolerance is that share of its length where this is less than `tolerance` (but at least half a cell), as OpenCV's users give the
  /// tolerance of approxPolyDP. A share of a long wall's outline is a long way: `tolerance` stays the bound of all.
  std::optional<double> relative{};
  double dilate = 0.0;  ///< m, ≥ 0: obstacles grow by so much: whole cells, all that the grown obstacle touches
};

struct TracedGrid {
  std::vector<Ring> obstacles;       ///< counter-clockwise, simple; they may touch and overlap
  std::optional<Ring> boundary;      ///< of a grid that bounds: its rectangle
  std::int64_t blocked = 0;          ///< cells, before
  std::int64_t covered = 0;          ///< cells, after dilating
  std::size_t corners = 0;           ///< of all polygons
  std::size_t outline_corners = 0;   ///< before corners were left out
  double reached = 0.0;              ///< m: no point of a polygon is farther from a covered cell
  double lost = 0.0;                 ///< m²: at most so much free area is in the polygons beyond the covered cells
};

/// Unknown cells are blocked. Refused: a tolerance under half a cell, more than 2²⁶ cells or 16384 a side.
Parsed<TracedGrid> trace(const CellGrid& grid, const TraceOptions& options);

/// What was made of it, in a sentence.
std::string describe(const TracedGrid& traced, const TraceOptions& options);

/// Which cells an obstacle grown by `distance` m touches; the grid may become larger where it does not bound. 0: the cells as they are.
CellGrid dilated(const CellGrid& grid, double distance);

}  // namespace waywright
