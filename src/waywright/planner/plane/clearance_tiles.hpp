// A clearance field in little room: what lies near each other in the plane lies near each other in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/map/clearance_field.hpp"

namespace waywright {

/// Tiles of 8 × 4 cells, each a line of a processor's cache, in whole numbers of 16 bits: a quarter to a third of the field's memory, and a line across the map touches a
/// fraction of the lines and pages.
///
/// Law: at(p) is no more than the field's value where that tells, and less by `step` (m) at most.
class ClearanceTiles {
 public:
  ClearanceTiles() = default;
  explicit ClearanceTiles(const ClearanceField& field);

  /// Lower bound in m of the distance from a point to anything blocked; under 0 outside the region and in its rim.
  double at(Vec2 point) const {
    const double column = (point.x - origin_.x) * cells_per_metre_, row = (point.y - origin_.y) * cells_per_metre_;
    if (!(column >= 0.0 && row >= 0.0 && column < columns_ && row < rows_)) return -1.0;
    return value(values_[index(static_cast<std::uint32_t>(static_cast<std::int32_t>(column)), static_cast<std::uint32_t>(static_cast<std::int32_t>(row)))]);
  }
  double step() const { return step_; }

 private:
  static constexpr std::uint32_t wide = 8, high = 4;  // cells
  double value(std::uint16_t number) const { return step_ * static_cast<double>(static_cast<std::int32_t>(number) - 1); }
  std::size_t index(std::uint32_t column, std::uint32_t row) const {
    return ((std::size_t{row / high} * tiles_ + column / wide) * high + row % high) * wide + column % wide;
  }

  Vec2 origin_{};
  double cells_per_metre_ = 0.0, columns_ = 0.0, rows_ = 0.0, step_ = 1.0;
  std::size_t tiles_ = 0;  // in a row: an odd number, so that tiles above each other do not fight for the same places of a cache
  std::vector<std::uint16_t> values_;  // 0: not told; else one more than steps
};

}  // namespace waywright
