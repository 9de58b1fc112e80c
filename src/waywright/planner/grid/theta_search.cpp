#include "waywright/planner/grid/theta_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr std::uint32_t from_start = std::numeric_limits<std::uint32_t>::max();

struct Waiting {
  double bound = 0.0, length = 0.0;
  std::uint32_t cell = 0;
};
/// Least bound first, then the one farther on, then the lower index.
bool later(const Waiting& a, const Waiting& b) {
  if (a.bound != b.bound) return a.bound > b.bound;
  return a.length != b.length ? a.length < b.length : a.cell > b.cell;
}

/// A line costs its length, whichever way it is driven.
struct PlainLines {
  static constexpr bool has_zones = false;
  double cost(Vec2 a, Vec2 b) const { return distance(a, b); }
  double least(Vec2 a, Vec2 b) const { return distance(a, b); }
  bool may_be_driven(Vec2, Vec2) const { return true; }
};

struct ZonedLines {
  static constexpr bool has_zones = true;
  const ZoneRules& zones;
  double cost(Vec2 a, Vec2 b) const { return zones.weighs() ? zones.cost(a, b) : distance(a, b); }
  double least(Vec2 a, Vec2 b) const { return zones.least_factor() * distance(a, b); }
  bool may_be_driven(Vec2 a, Vec2 b) const { return zones.may_be_driven(a, b); }
};

}  // namespace

ThetaAnswer ThetaSearch::run(const GridGraph& graph, const GridFrame& frame, const Sight& sight, const ThetaQuery& query) {
  if (query.zones != nullptr) return run(graph, frame, sight, query, ZonedLines{*query.zones});
  return run(graph, frame, sight, query, PlainLines{});
}

template <class Lines>
ThetaAnswer ThetaSearch::run(const GridGraph& graph, const GridFrame& frame, const Sight& sight, const ThetaQuery& query, const Lines& lines) {
  if (visits_.size() != graph.cells()) {
    visits_.assign(graph.cells(), Visit{});
    generation_ = 0;
  }
  if (++generation_ == 0) {
    std::fill(visits_.begin(), visits_.end(), Visit{});
    generation_ = 1;
  }
  const auto width = static_cast<std::uint32_t>(graph.columns());
  const auto cell_of = [&](std::uint32_t i) { return Cell{static_cast<int>(i % width), static_cast<int>(i / width)}; };
  const auto middle_of = [&](std::uint32_t i) { return i == from_start ? query.start : frame.centre(cell_of(i)); };
  std::vector<Waiting> open;
  const auto push = [&](std::uint32_t cell, double length, std::uint32_t parent) {
    visits_[cell] = {length, parent, generation_, false};
    open.push_back({length + lines.least(middle_of(cell), query.goal), length, cell});
    std::push_heap(open.begin(), open.end(), later);
  };
  const auto moves_from = [&](std::uint32_t i) {
    unsigned mask = graph.free_moves()[i];
    if (graph.asked_moves().empty()) return mask;
    for (unsigned rest = graph.asked_moves()[i]; rest != 0; rest &= rest - 1) {
      if (query.is_free(cell_of(i), __builtin_ctz(rest))) mask |= 1U << __builtin_ctz(rest);
    }
    return mask;
  };
  const auto neighbour = [&](std::uint32_t i, int move) {
    const Move m = moves[static_cast<std::size_t>(move)];
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(i) + static_cast<std::int64_t>(m.row) * width + m.column);
  };

  // Moves to the neighbours from which a move leads here: without one-way zones the same.
  const auto moves_into = [&](std::uint32_t i) {
    unsigned mask = 0;
    const Cell here = cell_of(i);
    for (int move = 0; move < all_moves; move += steps_of(graph.neighbours())) {
      const Move m = moves[static_cast<std::size_t>(move)];
      const Cell there{here.column + m.column, here.row + m.row};
      if (!graph.contains(there)) continue;
      const std::size_t from = graph.index(there);
      const unsigned back = 1U << opposite(move);
      const bool is_open = (graph.free_moves()[from] & back) != 0 || (!graph.asked_moves().empty() && (graph.asked_moves()[from] & back) != 0 && query.is_free(there, opposite(move)));
      if (is_open) mask |= 1U << move;
    }
    return mask;
  };

  ThetaAnswer answer;
  for (const GridEnd& s : query.starts) {
    const auto cell = static_cast<std::uint32_t>(graph.index(s.cell));
    const Visit& v = visits_[cell];
    const double length = s.length * frame.cell;
    if (v.generation != generation_ || v.length > length) push(cell, length, from_start);
  }
  double best = std::numeric_limits<double>::infinity();
  std::uint32_t last = from_start;
  while (!open.empty() && open.front().bound < best) {
    std::pop_heap(open.begin(), open.end(), later);
    const Waiting at = open.back();
    open.pop_back();
    Visit& here = visits_[at.cell];
    if (here.is_closed || here.length != at.length) continue;
    if (query.expansions && answer.expansions == *query.expansions) {
      answer.ended = SearchEnd::expansions;
      return answer;
    }
    if ((answer.expansions & 255) == 0 && query.budget != nullptr && query.budget->exhausted()) {
      answer.ended = query.budget->canceled() ? SearchEnd::canceled : SearchEnd::timed_out;
      return answer;
    }
    ++answer.expansions;
    const unsigned mask = moves_from(at.cell);
    const bool is_seen = lines.may_be_driven(middle_of(here.parent), middle_of(at.cell)) &&
                         sight.is_free(middle_of(here.parent), middle_of(at.cell), here.parent == from_start ? query.end_margin : query.margin);
    if (!is_seen) {
      // Then it is reached from one of its neighbours, the one that supposed it among them.
      here.length = std::numeric_limits<double>::infinity();
      for (unsigned rest = Lines::has_zones ? moves_into(at.cell) : mask; rest != 0; rest &= rest - 1) {
        const std::uint32_t next = neighbour(at.cell, __builtin_ctz(rest));
        const Visit& v = visits_[next];
        if (v.generation != generation_ || !v.is_closed) continue;
        const double length = v.length + lines.cost(middle_of(next), middle_of(at.cell));
        if (length >= here.length) continue;
        here.length = length;
        here.parent = next;
      }
      if (!std::isfinite(here.length)) continue;
    }
    here.is_closed = true;
    for (const GridEnd& g : query.goals) {
      if (graph.index(g.cell) != at.cell) continue;
      const double whole = here.length + g.length * frame.cell;
      if (whole < best) {
        best = whole;
        last = at.cell;
      }
    }
    const std::uint32_t parent = here.parent;
    const double before = parent == from_start ? 0.0 : visits_[parent].length;
    const Vec2 parent_middle = middle_of(parent);
    for (unsigned rest = mask; rest != 0; rest &= rest - 1) {
      const std::uint32_t next = neighbour(at.cell, __builtin_ctz(rest));
      const Visit& v = visits_[next];
      double length = before + lines.cost(parent_middle, middle_of(next));
      std::uint32_t through = parent;
      if constexpr (Lines::has_zones) {  // the straight line need not be the cheapest, nor allowed
        const double past_here = here.length + lines.cost(middle_of(at.cell), middle_of(next));
        if (past_here < length || !lines.may_be_driven(parent_middle, middle_of(next))) {
          length = past_here;
          through = at.cell;
        }
      }
      if (v.generation == generation_ && (v.is_closed || v.length <= length)) continue;
      push(next, length, through);
    }
  }
  if (last == from_start) return answer;
  answer.ended = SearchEnd::found;
  answer.points.push_back(query.goal);
  for (std::uint32_t i = last; i != from_start; i = visits_[i].parent) answer.points.push_back(middle_of(i));
  answer.points.push_back(query.start);
  std::reverse(answer.points.begin(), answer.points.end());
  return answer;
}

}  // namespace waywright
