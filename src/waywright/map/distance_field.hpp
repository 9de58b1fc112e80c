// Exact Euclidean distance transform of a grid: for every cell the squared distance, in cells, between its centre and that of the nearest
// blocked cell, as a whole number.
//
// How this differs from ClearanceField: that one is a lower bound, in metres, of how far every point of a cell is from the exact outlines
// of a World, made by asking the hierarchy of its segments; a filter. This one knows nothing but blocked cells, is exact for their
// centres, and takes time proportional to the number of cells, whatever is blocked: what grid planners and dangers are made of.
//
// Two passes (as Meijster, Roerdink, Hesselink 2000): distances along columns first; then each row is the lower envelope of parabolas, one
// a column. Where everything is near, the envelope is sought outwards from each cell, many cells at a time; where not, it is built with a
// stack of parabolas, compared by products, without a division.
//
// Laws: squared ≥ 0, and 0 exactly at blocked cells; √squared changes by at most the distance between two cells; turning over or transposing
// the grid turns over or transposes the field. The same values from every instruction set and on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace waywright {

struct Cell {
  int column = 0;
  int row = 0;
  friend constexpr bool operator==(Cell, Cell) = default;
};

/// From a cell's middle to its corners, in cells, rounded up.
inline constexpr double half_cell_diagonal = 0.7071067811866;

class DistanceField {
 public:
  static constexpr int longest_side = 16384;                                            ///< cells: distances along a column fit 16 bits
  static constexpr std::int32_t nowhere = std::numeric_limits<std::int32_t>::max();  ///< the value of all cells where nothing is blocked

  DistanceField() = default;
  /// `blocked`: columns × rows, row by row; not 0: blocked. `is_bounded`: all around the grid is blocked, too.
  /// @pre 1 ≤ columns, rows ≤ longest_side; blocked.size() == columns × rows. 6 bytes a cell are kept.
  DistanceField(int columns, int rows, std::span<const std::uint8_t> blocked, bool is_bounded) { assign(columns, rows, blocked, is_bounded); }
  /// The same; memory is reused.
  void assign(int columns, int rows, std::span<const std::uint8_t> blocked, bool is_bounded);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::int32_t squared(int column, int row) const { return squared_[index(column, row)]; }
  const std::vector<std::int32_t>& values() const { return squared_; }  ///< row by row

  /// A blocked cell that is nearest to this one: of several the one fewest columns away, left before right, above before below. One outside
  /// has a column or row of −1, `columns` or `rows`. Empty where nothing is blocked. Takes time proportional to the distance.
  std::optional<Cell> nearest(int column, int row) const;

 private:
  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column); }
  void measure_columns(std::span<const std::uint8_t> blocked);

  int columns_ = 0;
  int rows_ = 0;
  bool is_bounded_ = false;
  std::vector<std::int16_t> vertical_;  ///< cells to the nearest blocked one in the same column
  std::vector<std::int32_t> squared_;
};

}  // namespace waywright
