// A potential without local minima on any map: harmonic between cells, drawn off at walls.
//
// Sources: C. I. Connolly, J. B. Burns, R. Weiss: Path planning using Laplace's equation, ICRA 1990; the walls' absorption in part is ours.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "waywright/planner/grid/grid_frame.hpp"

namespace waywright {

/// Nodes are the middles of cells. w is 1 at the goal's nodes and at each other free one the sum of its free neighbours' over (their number + absorption × that of the
/// neighbours it cannot be driven to): the chance that a walk at random comes to the goal before walls have taken it.
///
/// Law: every free node that is connected to the goal and is none of its own has a free neighbour with a greater w (as far as numbers reach: w is no less than 1e-300
/// where it is told at all).
class HarmonicField {
 public:
  struct Options {
    std::int64_t most_unknowns = std::numeric_limits<std::int64_t>::max();  ///< with more nothing is solved, and all values are 0
    double absorption = 0.1;  ///< in (0, 1]: 1 as published; less keeps nearer to walls and fades more slowly
  };
  /// `is_free`: can the disc stand at a cell's middle; `may_drive`: straight from one middle to the next. Solved directly (sparse Cholesky), so that small values are as
  /// exact as great ones: no difference is formed of anything but diagonals.
  /// @pre goals are free
  HarmonicField(const GridFrame& frame, const std::vector<Cell>& goals, const std::function<bool(Cell)>& is_free, const std::function<bool(Cell, Cell)>& may_drive, const Options& options);

  const GridFrame& frame() const { return frame_; }
  /// w of a node; 0 where it is blocked or not connected to the goal, or so far off that numbers do not reach (reaches() says which).
  double at(Cell c) const { return frame_.contains(c) ? values_[index(c)] : 0.0; }
  bool reaches(Cell c) const { return frame_.contains(c) && (links_[index(c)] != 0 || values_[index(c)] > 0.0); }  ///< connected to the goal
  bool may_drive(Cell from, Cell to) const;  ///< between neighbours
  std::int64_t unknowns() const { return unknowns_; }
  bool is_over() const { return is_over_; }  ///< there were more than allowed

  /// w between nodes, bilinear, and its slope; w = 0 beyond the grid.
  struct Value {
    double w = 0.0;
    Vec2 gradient{};  ///< 1/m
  };
  Value at(Vec2 world) const;

 private:
  std::size_t index(Cell c) const { return static_cast<std::size_t>(c.row) * static_cast<std::size_t>(frame_.columns) + static_cast<std::size_t>(c.column); }

  GridFrame frame_;
  std::vector<double> values_;
  std::vector<std::uint8_t> links_;  // bit i: to the i-th of right, up, left, down
  std::int64_t unknowns_ = 0;
  bool is_over_ = false;
};

}  // namespace waywright
