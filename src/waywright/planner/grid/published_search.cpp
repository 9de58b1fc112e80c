#include "waywright/planner/grid/published_search.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr std::uint8_t came_from_nowhere = 255;

struct Waiting {
  double all = 0.0, rest = 0.0;
  std::uint64_t serial = 0;
  std::uint32_t cell = 0;
};
bool later(const Waiting& a, const Waiting& b) {
  if (a.all != b.all) return a.all > b.all;
  return a.rest != b.rest ? a.rest > b.rest : a.serial > b.serial;
}

}  // namespace

GridAnswer PublishedSearch::run(const GridGraph& graph, const CellDanger* danger, Cell start, Cell goal, std::optional<std::int64_t> expansions, Budget* budget) {
  GridAnswer answer;
  if (!graph.may_be_connected(start, goal)) {
    answer.known_at_once = true;
    return answer;
  }
  if (visits_.size() != graph.cells()) {
    visits_.assign(graph.cells(), Visit{});
    generation_ = 0;
  }
  if (++generation_ == 0) {
    std::fill(visits_.begin(), visits_.end(), Visit{});
    generation_ = 1;
  }
  const auto length_of = [](const Visit& v) { return MoveCounts{v.straight, v.diagonal, v.knight}.length(); };
  const auto rest_of = [&](Cell c) {
    const double columns = c.column - goal.column, rows = c.row - goal.row;
    return std::sqrt(columns * columns + rows * rows) + (danger == nullptr ? 0.0 : danger->at(c));
  };
  std::vector<Waiting> open;
  std::uint64_t serial = 0;
  const auto push = [&](Cell c, double length) {
    const double rest = rest_of(c);
    open.push_back({length + rest, rest, serial++, static_cast<std::uint32_t>(graph.index(c))});
    std::push_heap(open.begin(), open.end(), later);
  };
  visits_[graph.index(start)] = {0, 0, 0, generation_, came_from_nowhere, 0};
  push(start, 0.0);
  const auto width = static_cast<std::uint32_t>(graph.columns());
  while (!open.empty()) {
    std::pop_heap(open.begin(), open.end(), later);
    const Waiting at = open.back();
    open.pop_back();
    Visit& here = visits_[at.cell];
    if (here.is_closed != 0) continue;  // waits a second time, with a lesser length, and that came first
    if (expansions && answer.expansions == *expansions) {
      answer.ended = SearchEnd::expansions;
      return answer;
    }
    if ((answer.expansions & 255) == 0 && budget != nullptr && budget->exhausted()) {
      answer.ended = budget->canceled() ? SearchEnd::canceled : SearchEnd::timed_out;
      return answer;
    }
    ++answer.expansions;
    here.is_closed = 1;
    const Cell cell{static_cast<int>(at.cell % width), static_cast<int>(at.cell / width)};
    if (cell == goal) {
      answer.ended = SearchEnd::found;
      break;
    }
    for (unsigned rest = graph.free_moves()[at.cell]; rest != 0; rest &= rest - 1) {
      const int i = __builtin_ctz(rest);
      const Move m = moves[static_cast<std::size_t>(i)];
      const Cell next{cell.column + m.column, cell.row + m.row};
      Visit& there = visits_[graph.index(next)];
      const bool is_known = there.generation == generation_;
      if (is_known && there.is_closed != 0) continue;
      Visit by = here;
      by.is_closed = 0;
      by.came_by = static_cast<std::uint8_t>(i);
      (kind_of(i) == MoveKind::straight ? by.straight : kind_of(i) == MoveKind::diagonal ? by.diagonal : by.knight) += 1;
      const double length = length_of(by);
      if (is_known && length >= length_of(there)) continue;
      there = by;
      push(next, length);
    }
  }
  if (answer.ended != SearchEnd::found) return answer;
  for (Cell c = goal;;) {
    answer.cells.push_back(c);
    const Visit& v = visits_[graph.index(c)];
    if (v.came_by == came_from_nowhere) break;
    answer.counts.add(v.came_by);
    const Move m = moves[v.came_by];
    c = {c.column - m.column, c.row - m.row};
  }
  std::reverse(answer.cells.begin(), answer.cells.end());
  answer.cost = answer.counts.length();
  return answer;
}

}  // namespace waywright
