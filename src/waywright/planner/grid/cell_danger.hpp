// The danger coefficient of the safe-A* publication: what blocked cells near a place add up to.
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/map/distance_field.hpp"

namespace waywright {

/// ψ = Σ (q/d)^C · a over blocked cells whose middles are d ≤ R₁ away, with a the area of a cell in m². The publication's cells are of one metre; the area makes the figure
/// mean the same on finer ones. Formula (5).
struct DangerRule {
  double reach = 1.5;     ///< m, R₁
  double scale = 2.0;     ///< m, q
  int exponent = 1;       ///< C
};

/// Immutable; safe to read from many threads. Keeps 6 bytes a cell, 10 where the reach is more than five cells.
class CellDanger {
 public:
  /// `occupied`: columns × rows, row by row, not 0: blocked.
  CellDanger(int columns, int rows, double cell, const std::vector<std::uint8_t>& occupied, const DangerRule& rule);

  /// ψ of a cell. Where the reach is more than five cells, cells are counted in square blocks, each as if all of it were at its middle; blocks grow threefold outwards, and
  /// the cells around the one that asks are counted one by one, so that danger grows towards what is blocked. No cell asks for more than 120 blocks and 8 for each size.
  double at(Cell c) const;
  const DistanceField& field() const { return field_; }  ///< of the occupied cells; what lies outside the grid counts as free
  double reach_in_cells() const { return reach_; }

 private:
  struct Part {
    int column, row;  ///< of the block's upper left cell, from the one that asks
    int side;         ///< of the block
    double weight;    ///< of each of its cells
  };
  std::int64_t count(int column, int row, int side) const;

  int columns_ = 0, rows_ = 0;
  double reach_ = 0.0;
  std::vector<Part> parts_;
  std::vector<std::uint8_t> occupied_;
  std::vector<std::uint32_t> sums_;  ///< of occupied cells above and to the left, with a rim; only for blocks
  DistanceField field_;
};

}  // namespace waywright
