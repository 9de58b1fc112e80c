// What a scenario's zones do to the moves between cells: which go against a direction, and what a metre of each costs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "waywright/planner/grid/grid_frame.hpp"
#include "waywright/planner/grid/lattice.hpp"

namespace waywright {

/// Immutable once made. Most cells lie wholly inside or outside of every zone and share their figures with others; moves that come near an outline are cut there exactly
/// (ZoneRules). 4 bytes a cell, and 64 or 128 more for each near an outline.
class GridZones {
 public:
  GridZones() = default;
  /// Refused where outlines with many corners come near so many cells that it would take minutes.
  static tl::expected<GridZones, std::string> make(const ZoneRules& rules, const GridFrame& frame, Neighbours neighbours);

  /// No zone directs or weighs.
  bool empty() const { return index_.empty(); }
  bool weighs() const { return weighs_; }
  double least_factor() const { return least_factor_; }  ///< of a metre anywhere
  double most_factor() const { return most_factor_; }

  /// Does this move from the cell break a directed zone's rule? @pre not empty
  bool is_against(std::size_t cell, int move) const { return (against_[index_[cell]] >> move & 1) != 0; }
  std::uint16_t against(std::size_t cell) const { return against_[index_[cell]]; }
  /// What a metre of this move costs on the average. @pre not empty, and the move is one of the neighbourhood's
  double factor(std::size_t cell, int move) const {
    return factors_[static_cast<std::size_t>(index_[cell]) * static_cast<std::size_t>(per_cell_) + static_cast<std::size_t>(move) / static_cast<std::size_t>(stride_)];
  }

 private:
  struct Work;
  bool weighs_ = false;
  double least_factor_ = 1.0, most_factor_ = 1.0;
  int per_cell_ = 1, stride_ = 1;
  std::vector<std::uint32_t> index_;    ///< of each cell, into what follows; 0: no zone
  std::vector<std::uint16_t> against_;  ///< bit i: move i
  std::vector<double> factors_;         ///< `per_cell_` each
};

}  // namespace waywright
