// Blocked cells as pieces without holes, each with its outline: a simple polygon, so that a map of cells can become one of polygons.
//
// Cells that touch belong together, at a corner too, since nothing passes between them. A piece that encloses free cells would need an outline with holes, which
// polygons here do not have. So it is cut along the grid's lines: from each free region that is enclosed, one cut goes left from its leftmost cell and one right
// from its rightmost, each to the next free cell.
//
// Why that is enough: where a cut to the left ends, the free region's leftmost cell is farther left than that of the region where it began. So a chain of such cuts
// leads from every enclosed region to what lies outside, another one to the right, and whatever surrounded the region is taken apart by the two. The two sides of a
// cut are in different pieces: a way around from one to the other would surround the region at one of its ends, and would have to cross a chain of that region's.
//
// Where two cells of a piece touch at a corner alone, its outline would meet itself there; it goes past the corner, half a cell before it to half a cell after it.
// What that adds is within a quarter of a cell of blocked cells.
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/map/distance_field.hpp"

namespace waywright {

/// A place in half cells from the grid's lower left corner, y upwards.
struct HalfCell {
  std::int32_t x = 0, y = 0;
  friend constexpr bool operator==(HalfCell, HalfCell) = default;
};

struct CellPiece {
  std::vector<HalfCell> outline;  ///< counter-clockwise, simple, no three corners in a line; the first one is the lowest of the leftmost
  std::int64_t cells = 0;         ///< blocked cells in it
  bool is_bridged = false;        ///< its outline goes past corners where cells touch
};

/// All pieces: together they hold every blocked cell, and nothing else but what bridges corners. Outside of the grid nothing is blocked. `blocked`: columns × rows,
/// row by row from the top; not 0: blocked. @pre columns, rows ≤ DistanceField::longest_side
std::vector<CellPiece> pieces_of(int columns, int rows, const std::vector<std::uint8_t>& blocked);

}  // namespace waywright
