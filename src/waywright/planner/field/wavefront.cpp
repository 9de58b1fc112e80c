#include "waywright/planner/field/wavefront.hpp"

#include <algorithm>

namespace waywright {
namespace {

/// Calls `seen(neighbour, move, whether the move is known to be free)` for each that a move leads to that may be.
template <class Seen>
void neighbours_of(const GridGraph& graph, Cell c, Seen&& seen) {
  const std::size_t at = graph.index(c);
  const unsigned known = graph.free_moves()[at], asked = graph.asked_moves().empty() ? 0U : graph.asked_moves()[at];
  for (unsigned rest = known | asked; rest != 0; rest &= rest - 1) {
    const int i = __builtin_ctz(rest);
    const Move m = moves[static_cast<std::size_t>(i)];
    seen(Cell{c.column + m.column, c.row + m.row}, i, (known >> i & 1U) != 0);
  }
}

}  // namespace

Wavefront wavefront(const GridGraph& graph, const std::vector<Cell>& goals, const std::function<bool(Cell, int move)>& is_free, const std::function<bool()>& stops, std::int64_t most) {
  Wavefront front;
  front.values.assign(graph.cells(), 0);
  std::vector<Cell> waiting;
  for (const Cell c : goals) {
    if (front.values[graph.index(c)] != 0) continue;
    front.values[graph.index(c)] = Wavefront::goal_value;
    waiting.push_back(c);
  }
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    if (front.expanded == most || ((i & 1023) == 0 && stops())) {
      front.is_stopped = true;
      break;
    }
    ++front.expanded;
    const Cell at = waiting[i];
    const std::uint32_t next = front.values[graph.index(at)] + 1;
    neighbours_of(graph, at, [&](Cell to, int move, bool is_known) {
      std::uint32_t& value = front.values[graph.index(to)];
      if (value != 0) return;
      if (!is_known && !is_free(to, opposite(move))) return;  // it will be driven from there to here
      value = next;
      waiting.push_back(to);
    });
  }
  front.reached = static_cast<std::int64_t>(waiting.size());
  return front;
}

std::vector<Cell> way_down(const Wavefront& front, const GridGraph& graph, Cell from, const std::function<bool(Cell, int move)>& is_free, const std::function<double(Cell)>& clearance) {
  std::vector<Cell> way{from};
  while (front.values[graph.index(way.back())] > Wavefront::goal_value) {
    const std::uint32_t wanted = front.values[graph.index(way.back())] - 1;
    Cell best = way.back();
    double farthest = -1.0;
    neighbours_of(graph, way.back(), [&](Cell to, int move, bool is_known) {
      if (front.values[graph.index(to)] != wanted || (farthest >= 0.0 && !clearance)) return;
      if (!is_known && !is_free(way.back(), move)) return;
      const double room = clearance ? std::max(0.0, clearance(to)) : 0.0;
      if (room <= farthest) return;
      best = to;
      farthest = room;
    });
    if (farthest < 0.0) break;  // cannot be: who was reached was reached from such a neighbour
    way.push_back(best);
  }
  return way;
}

}  // namespace waywright
