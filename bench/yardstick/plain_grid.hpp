// The yardstick of grid searches: plain code as it stands in textbooks, nothing of ours. Frozen; also an oracle of the tests.
#pragma once

#include <cstdint>
#include <vector>

namespace yardstick {

/// Cells row by row, not 0: blocked. A diagonal move needs both cells beside it free (`loose`: one); a knight's move both that it crosses.
struct Grid {
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> blocked;
  std::vector<float> danger;  ///< empty, or for each cell: a move costs its length times 1 + the mean of its ends' dangers
  int neighbours = 8;         ///< 4, 8, 16
  bool loose = false;
};

struct Found {
  bool found = false;
  double cost = 0.0;
  std::int64_t expansions = 0;
  std::vector<int> cells;  ///< indices
};

/// A* with a priority queue of doubles and hash maps from cell to cost and parent; the heuristic is the Euclidean distance. `no_heuristic`: Dijkstra.
Found textbook_astar(const Grid& grid, int start, int goal, bool no_heuristic = false);

/// The same with a binary heap and flat arrays; the heuristic is the exact free way for 4 and 8 neighbours, Euclidean for 16.
Found heap_astar(const Grid& grid, int start, int goal, bool no_heuristic = false);

/// Exact squared distances between cell centres by looking at every pair of cells in a row (after distances along columns).
std::vector<std::int32_t> plain_distances(const Grid& grid);

}  // namespace yardstick
