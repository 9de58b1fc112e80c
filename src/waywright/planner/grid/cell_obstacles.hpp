// Obstacles on a grid as the safe-A* publication sees them: groups of blocked cells with their corners, and the rectangles that it puts around irregular ones.
//
// The groups are labelled here, by a walk over the cells: what is needed of contours is which cells hang together and the corners of their hull, and no library
// that this project links has either for a grid (OpenCV is used by benchmarks alone).
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/geometry/polygon.hpp"
#include "waywright/map/distance_field.hpp"

namespace waywright {

/// Which cells are what. In the coordinates used here the middle of a cell is (column, row), so a unit is a cell and y points down.
struct CellMap {
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> occupied;  ///< holds a part of an obstacle; not 0: yes
  std::vector<std::uint8_t> blocked;   ///< the vehicle's middle cannot be there; occupied ones among them

  bool contains(Cell c) const { return c.column >= 0 && c.row >= 0 && c.column < columns && c.row < rows; }
  std::size_t index(Cell c) const { return static_cast<std::size_t>(c.row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c.column); }
  bool is_blocked(Cell c) const { return !contains(c) || blocked[index(c)] != 0; }
};

constexpr Vec2 middle_of(Cell c) { return {static_cast<double>(c.column), static_cast<double>(c.row)}; }
Cell cell_at(Vec2 p);  ///< whose middle is nearest

class CellObstacles {
 public:
  struct Obstacle {
    Ring hull;                   ///< of the middles of its cells; one or two points where they are in a line
    std::vector<Vec2> corners;   ///< of the hull without those that stand out by less than a cell
    std::int64_t cells = 0;
    bool is_convex = false;      ///< every cell whose middle is in the hull belongs to it
  };

  /// Cells that touch, at a corner too, are one obstacle.
  CellObstacles(int columns, int rows, const std::vector<std::uint8_t>& occupied);

  static constexpr std::uint32_t none = 0xFFFFFFFF;
  std::uint32_t at(Cell c) const { return label_[static_cast<std::size_t>(c.row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c.column)]; }
  const std::vector<Obstacle>& all() const { return all_; }

 private:
  int columns_ = 0;
  std::vector<std::uint32_t> label_;
  std::vector<Obstacle> all_;
};

/// The cells with a rectangle (see `regularised`) in place of each obstacle that is not convex, unless one of the `kept_free` places would be in it.
std::vector<std::uint8_t> with_regular_obstacles(int columns, int rows, const std::vector<std::uint8_t>& occupied, const std::vector<Cell>& kept_free);

}  // namespace waywright
