#include "waywright/planner/grid/disc_graph.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace waywright {
namespace {

// How near a move that the strict rule allows comes to blocked cells, in cells: straight and diagonal ones pass the sides of cells half a cell away,
// a knight's move passes a corner at 1/(2√5).
constexpr double beside_king = 0.5;
constexpr double beside_knight = 0.2236;

}  // namespace

GridGraph disc_graph(const GridFrame& frame, const CellBounds& bounds, Neighbours neighbours, double needed) {
  const double beside = (neighbours == Neighbours::sixteen ? beside_knight : beside_king) * frame.cell - 1e-6;
  if (bounds.is_cells_alone() && needed < beside) return {frame.columns, frame.rows, bounds.occupied(), neighbours, CornerRule::strict};

  const std::size_t cells = static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
  std::vector<std::uint16_t> free(cells, 0), asked(cells, 0);
  const double longest = (neighbours == Neighbours::sixteen ? 2.23607 : neighbours == Neighbours::eight ? 1.41422 : 1.0) * frame.cell;
  bool is_any_asked = false;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) {
      const Cell here{column, row};
      const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.columns) + static_cast<std::size_t>(column);
      const double low = bounds.at_least(here);
      if (low < needed && bounds.at_most(here) <= needed) continue;
      const bool is_wide = low >= needed + longest;  // (low + (low − ℓ) − ℓ)/2
      for (int i = 0; i < all_moves; i += steps_of(neighbours)) {
        const Move m = moves[static_cast<std::size_t>(i)];
        const Cell there{column + m.column, row + m.row};
        if (!frame.contains(there)) continue;
        const auto bit = static_cast<std::uint16_t>(1U << i);
        const double length = std::sqrt(static_cast<double>(m.column * m.column + m.row * m.row)) * frame.cell;
        if (is_wide || 0.5 * (low + bounds.at_least(there) - length) > needed) {
          free[at] = static_cast<std::uint16_t>(free[at] | bit);
        } else if (bounds.at_most(there) > needed) {
          asked[at] = static_cast<std::uint16_t>(asked[at] | bit);
          is_any_asked = true;
        }
      }
    }
  }
  if (!is_any_asked) asked.clear();
  return {frame.columns, frame.rows, neighbours, std::move(free), std::move(asked)};
}

}  // namespace waywright
