// A clearance field in little room: what lies near each other in the plane lies near each other in memory.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "waywright/map/clearance_field.hpp"

namespace waywright {

/// Tiles of 8 × 8 cells, each a line of a processor's cache, a byte a cell: an eighth to a sixth of the field's memory, and a line across the map touches a fraction of the
/// lines and pages. Beside what the field tells they tell where all is blocked, and how far around.
///
/// Law: at(p) is no more than the field's value where that tells and not all of p's cell is blocked; where the field says no more than `sharp` it is less by `step` (m) at
/// most, elsewhere by 2 % at most (more where the field goes from `sharp` to over thirty times that).
class ClearanceTiles {
 public:
  ClearanceTiles() = default;
  ClearanceTiles(const World& world, const ClearanceField& field, double sharp);

  /// Lower bound in m of the distance from a point to anything blocked; under 0 outside the region, in its rim, and where all is blocked: see depth.
  double at(Vec2 point) const {
    const double column = (point.x - origin_.x) * cells_per_metre_, row = (point.y - origin_.y) * cells_per_metre_;
    if (!(column >= 0.0 && row >= 0.0 && column < columns_ && row < rows_)) return not_told;
    return meanings_[values_[index(static_cast<std::uint32_t>(static_cast<std::int32_t>(column)), static_cast<std::uint32_t>(static_cast<std::int32_t>(row)))]];
  }
  /// Of what `at` gave for a point: all places as near as that (m) to it are blocked; negative where it does not tell.
  static double depth(double at) { return 2.0 * not_told - at; }
  /// Of the same: the place is blocked for sure.
  static bool is_blocked(double at) { return at < 1.5 * not_told; }
  double step() const { return step_; }

 private:
  static constexpr std::uint32_t side = 8;  // cells of a tile
  static constexpr double not_told = -1.0;  // blocked places have twice that less their depth
  std::size_t index(std::uint32_t column, std::uint32_t row) const { return ((std::size_t{row / side} * tiles_ + column / side) * side + row % side) * side + column % side; }
  void choose_meanings(double sharp, double greatest, double cell);

  Vec2 origin_{};
  double cells_per_metre_ = 0.0, columns_ = 0.0, rows_ = 0.0, step_ = 1.0;
  std::size_t tiles_ = 0;  // in a row: an odd number, so that tiles above each other do not fight for the same places of a cache
  std::array<double, 256> meanings_{};  // of a cell's number: not told; distances, ascending; from `first_depth` on depths, ascending
  std::vector<std::uint8_t> values_;
};

}  // namespace waywright
