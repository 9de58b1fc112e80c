// The wavefront: how many moves each cell is from the goal, and down it.
//
// Source: the navigation-field publication, §4.1; J. Barraquand, B. Langlois, J.-C. Latombe: Numerical potential field techniques for robot path planning, IEEE T-SMC 22
// (1992).
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "waywright/planner/grid/grid_graph.hpp"

namespace waywright {

/// Values of cells, row by row as the graph has them: 0 not reached, 2 the goal, one more with each move.
struct Wavefront {
  static constexpr std::uint32_t goal_value = 2;
  std::vector<std::uint32_t> values;
  std::int64_t reached = 0;  ///< cells
  std::int64_t expanded = 0; ///< of them, that it was passed on from
  bool is_stopped = false;   ///< before all that can be reached was

  bool reaches(std::size_t cell) const { return values[cell] != 0; }
};

/// From the goals outwards, every free neighbour of a cell with value v that has none gets v + 1. Linear in the number of cells. `is_free` is asked of moves that the
/// graph does not know; `stops` every 1024 cells. At most
/// `most` cells are passed on from.
Wavefront wavefront(const GridGraph& graph, const std::vector<Cell>& goals, const std::function<bool(Cell, int move)>& is_free, const std::function<bool()>& stops,
                    std::int64_t most = std::numeric_limits<std::int64_t>::max());

/// Down from a cell that was reached, each time to a neighbour whose value is one less: the first in the order east, north-east, north … (so published), or where
/// `clearance` is told (m, of each cell) the one farthest from what is blocked.
std::vector<Cell> way_down(const Wavefront& front, const GridGraph& graph, Cell from, const std::function<bool(Cell, int move)>& is_free, const std::function<double(Cell)>& clearance = {});

}  // namespace waywright
