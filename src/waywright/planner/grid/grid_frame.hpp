// Where the cells of a grid planner lie in the world, and what is known of each from a distance transform.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "waywright/map/distance_field.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// Row 0 is the top, as in CellGrid.
struct GridFrame {
  Frame frame;        ///< of the lower left corner
  double cell = 0.0;  ///< m
  int columns = 0, rows = 0;
  bool is_native = false;  ///< the cells are those of the map's own grid
  std::size_t native = 0;  ///< which of the map's grids

  Vec2 centre(Cell c) const { return frame.to_world(Vec2{(c.column + 0.5) * cell, (rows - c.row - 0.5) * cell}); }
  /// In cells from the upper left corner; a cell's centre has halves.
  Vec2 in_cells(Vec2 world) const {
    const Vec2 local = frame.to_local(world);
    return {local.x / cell, rows - local.y / cell};
  }
  /// The cell that a place lies in; it may be none of the grid's.
  Cell cell_at(Vec2 world) const {
    const Vec2 p = in_cells(world);
    constexpr double far = 1e9;
    return {static_cast<int>(std::floor(std::clamp(p.x, -far, far))), static_cast<int>(std::floor(std::clamp(p.y, -far, far)))};
  }
  bool contains(Cell c) const { return c.column >= 0 && c.row >= 0 && c.column < columns && c.row < rows; }
};

inline constexpr std::int64_t most_grid_cells = 1LL << 25;  ///< about 33.5 million, under 1 GiB in all

/// The map's own cells where it has a grid and `resolution` is 0 or their size; else cells of that size over all that can be driven on, 0: 0.05 m,
/// doubled until there are at most four million. What is wrong with them in one sentence otherwise.
tl::expected<GridFrame, std::string> make_grid_frame(const Problem& problem, double resolution);

/// How near to anything blocked the middle of each cell is, m: bounds from a distance transform of the cells that hold a part of an obstacle.
class CellBounds {
 public:
  CellBounds(const Problem& problem, const GridFrame& frame);
  /// No obstacle is nearer to the cell's middle than this; ≤ 0: nothing is known.
  double at_least(Cell c) const { return bound(c, low_); }
  /// Some obstacle is within this of the cell's middle; +∞ where none is known.
  double at_most(Cell c) const;
  /// Are blocked cells of one grid all that there is?
  bool is_cells_alone() const { return is_cells_alone_; }
  const std::vector<std::uint8_t>& occupied() const { return occupied_; }

 private:
  double bound(Cell c, double shift) const;
  void mark_segments(const Problem& problem, const GridFrame& frame);
  void mark_insides(const Problem& problem, const GridFrame& frame);

  double cell_ = 0.0;
  double low_ = 0.0, high_ = 0.0;  ///< cells, from the distance of middles to that of the obstacle
  bool is_cells_alone_ = false;
  std::vector<std::uint8_t> occupied_;
  DistanceField field_;
};

}  // namespace waywright
