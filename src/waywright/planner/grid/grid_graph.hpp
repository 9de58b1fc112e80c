// Cells and the moves between them that are free: what a grid search runs on. Immutable once built; safe to read from many threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "waywright/planner/grid/grid_zones.hpp"
#include "waywright/planner/grid/lattice.hpp"

namespace waywright {

/// Of diagonal moves past blocked cells: `strict` needs both cells beside it free, `loose` one of them (as published; a vehicle with a width
/// cannot drive it: for reproductions alone). A knight's move needs both cells that it crosses free, either way.
enum class CornerRule { strict, loose };

class GridGraph {
 public:
  static constexpr int longest_side = DistanceField::longest_side;

  GridGraph() = default;
  /// Every move between free cells that the rule allows. `blocked`: columns × rows, row by row, not 0: blocked.
  /// @pre 1 ≤ columns, rows ≤ longest_side
  GridGraph(int columns, int rows, std::span<const std::uint8_t> blocked, Neighbours neighbours, CornerRule corners);
  /// The same with free moves told one by one: bit i of a cell's mask is move i. Of `asked` moves somebody has to be asked when the search comes there;
  /// empty: none. Components then hold what is connected by moves of either kind.
  /// Moves must be there both ways and end inside the grid.
  GridGraph(int columns, int rows, Neighbours neighbours, std::vector<std::uint16_t> free, std::vector<std::uint16_t> asked);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t cells() const { return free_.size(); }
  Neighbours neighbours() const { return neighbours_; }
  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column); }
  std::size_t index(Cell c) const { return index(c.column, c.row); }
  bool contains(Cell c) const { return c.column >= 0 && c.row >= 0 && c.column < columns_ && c.row < rows_; }

  const std::vector<std::uint16_t>& free_moves() const { return free_; }
  const std::vector<std::uint16_t>& asked_moves() const { return asked_; }

  /// What nearness costs in a cell, in 1/256 of the way through it: a move of length ℓ costs ℓ·(1 + (d₁ + d₂)/512), with the cells at its ends.
  /// @pre as many as there are cells
  void set_danger(std::span<const std::uint16_t> danger);
  std::span<const std::uint16_t> danger() const { return danger_.empty() ? std::span<const std::uint16_t>{} : std::span{danger_}.subspan(margin(), cells()); }
  /// Numbers that can be read before the first cell's danger and behind the last one's.
  std::size_t margin() const { return 2 * static_cast<std::size_t>(columns_) + 8; }
  std::uint16_t most_danger() const { return most_danger_; }

  /// Takes out the moves that break a directed zone's rule, and weighs the others. Components stay those of the moves that were there both ways.
  /// @pre made for these cells and this neighbourhood
  void set_zones(GridZones zones);
  const GridZones& zones() const { return zones_; }

  /// False where no way can lead from one to the other, known from preparation. (Beyond 65 534 components it is not known of all.)
  bool may_be_connected(Cell a, Cell b) const;
  /// How many components there are, single blocked cells not counted.
  std::int64_t components() const { return components_; }

 private:
  void label_components();

  int columns_ = 0, rows_ = 0;
  Neighbours neighbours_ = Neighbours::eight;
  std::vector<std::uint16_t> free_, asked_;
  std::vector<std::uint16_t> danger_;  // with a margin on either side
  std::uint16_t most_danger_ = 0;
  GridZones zones_;
  std::vector<std::uint16_t> component_;
  std::int64_t components_ = 0;
};

}  // namespace waywright
