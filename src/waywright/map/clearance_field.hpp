// Distance to anything blocked, tabled: one number a cell that no point of the cell is nearer than. A filter for planners: what it
// calls clear is clear, what it does not is asked of the World.
#pragma once

#include <cstddef>
#include <vector>

#include "waywright/map/world.hpp"

namespace waywright {

class ClearanceField {
 public:
  struct Options {
    double cell = 0.03;             ///< m, > 0; doubled until the field has at most `most_cells`
    double sharp = 1.0;             ///< m, distances up to this are tabled as well as the cell allows
    double cap = 2.0;               ///< m, ≥ sharp: greater distances are tabled as this; those between to some cells' precision
    std::size_t most_cells = 1 << 20;
  };
  ClearanceField() = default;
  ClearanceField(const World& world, const Box& region, const Options& options);

  /// Lower bound in m of the distance from a point to anything blocked, 0 inside it; −1 outside the region and in its rim.
  float at(Vec2 point) const {
    const double column = (point.x - origin_.x) * cells_per_metre_, row = (point.y - origin_.y) * cells_per_metre_;
    if (!(column >= 0.0 && row >= 0.0 && column < columns_ && row < rows_)) return -1.0F;
    return values_[index(static_cast<int>(column), static_cast<int>(row))];
  }

  /// Greatest amount in m by which a point of a cell can be farther from everything than the cell's value says, if it says no more than
  /// `sharp`.
  double slack() const { return 1.4143 * cell_ + 1e-5; }

  Vec2 origin() const { return origin_; }  ///< low corner of the first cell
  double cell() const { return cell_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// Row-major, rows upwards; a row takes 2^row_shift values, those beyond its columns are −1.
  const std::vector<float>& values() const { return values_; }
  int row_shift() const { return row_shift_; }

 private:
  void fill(const World& world, int column, int row, const Options& options);
  void fill_block(const World& world, int column, int row, double limit, const Options& options);
  struct Block;
  Block block_at(int column, int row, int side) const;
  float& value(int column, int row) { return values_[index(column, row)]; }
  std::size_t index(int column, int row) const { return (static_cast<std::size_t>(row) << row_shift_) + static_cast<std::size_t>(column); }

  /// A segment, ready for many points.
  struct Near {
    Vec2 a, along;
    double inverse;  // 1/m²; 0 of a point
    double squared_distance(Vec2 p) const;
  };
  std::vector<Near> near_;  ///< while filling

  Vec2 origin_{};
  double cell_ = 0.0;
  double cells_per_metre_ = 0.0;
  int columns_ = 0;
  int rows_ = 0;
  int row_shift_ = 0;
  std::vector<float> values_;
};

}  // namespace waywright
