// A* as the safe-A* publication has it: the danger coefficient is part of what is expected, not of what is paid, and what was expanded is never looked at again. So
// the way found need not be the shortest, nor the one of least danger: for comparison. What is meant to be driven has danger in its cost (GridGraph::set_danger).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "waywright/planner/grid/cell_danger.hpp"
#include "waywright/planner/grid/grid_search.hpp"

namespace waywright {

/// Memory of one search after another, 16 bytes a cell; for one thread at a time.
class PublishedSearch {
 public:
  /// From start to goal by free moves of the graph, least f = g + h first, then least h, then the older entry; h is the straight distance plus `danger` (may be null), in
  /// cells. Lengths are counts of moves, so equal ones are equal. Cells lie in the grid.
  GridAnswer run(const GridGraph& graph, const CellDanger* danger, Cell start, Cell goal, std::optional<std::int64_t> expansions, Budget* budget);

 private:
  struct Visit {
    std::int32_t straight = 0, diagonal = 0, knight = 0;
    std::uint16_t generation = 0;
    std::uint8_t came_by = 0;
    std::uint8_t is_closed = 0;
  };
  std::vector<Visit> visits_;
  std::uint16_t generation_ = 0;
};

}  // namespace waywright
