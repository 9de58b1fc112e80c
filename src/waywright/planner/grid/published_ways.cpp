#include "waywright/planner/grid/published_ways.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "waywright/metrics/grid_metrics.hpp"

namespace waywright {
namespace {

void take_cells(const std::vector<Cell>& cells, std::vector<Vec2>& points) {
  for (const Cell c : cells) {
    const Vec2 p = middle_of(c);
    if (points.empty() || points.back() != p) points.push_back(p);
  }
}

/// On to a place in steps of a cell at most.
void take_straight(Vec2 to, std::vector<Vec2>& points) {
  const Vec2 from = points.back();
  if (from == to) return;
  const std::vector<Vec2> ends{from, to};
  const std::vector<Vec2> between = with_points_between(ends, 1.0);
  points.insert(points.end(), between.begin() + 1, between.end());
}

}  // namespace

PublishedWays::PublishedWays(CellMap cells, double cell, PublishedMethod method, const Options& options)
    : cells_{std::move(cells)},
      method_{method},
      options_{options},
      clearance_{options.clearance / cell},
      graph_{cells_.columns, cells_.rows, cells_.blocked, method == PublishedMethod::boundary ? Neighbours::sixteen : method == PublishedMethod::danger ? options.neighbours : Neighbours::eight,
             CornerRule::loose},
      danger_{cells_.columns, cells_.rows, cell, cells_.occupied, options.danger} {
  if (method == PublishedMethod::boundary) obstacles_.emplace(cells_.columns, cells_.rows, cells_.occupied);
}

PublishedWay PublishedWays::way(Cell start, Cell goal, PublishedSearch& search, std::optional<std::int64_t> expansions, Budget* budget) const {
  if (cells_.is_blocked(start) || cells_.is_blocked(goal)) {
    PublishedWay none;
    none.known_at_once = true;
    return none;
  }
  if (method_ == PublishedMethod::line) return line(start, goal, search, expansions, budget);
  if (method_ == PublishedMethod::boundary) return boundary(start, goal, search, expansions, budget);
  const GridAnswer answer = search.run(graph_, method_ == PublishedMethod::danger ? &danger_ : nullptr, start, goal, expansions, budget);
  PublishedWay way;
  way.ended = answer.ended;
  way.known_at_once = answer.known_at_once;
  way.expansions = answer.expansions;
  take_cells(answer.cells, way.points);
  return way;
}

PublishedWay PublishedWays::line(Cell start, Cell goal, PublishedSearch& search, std::optional<std::int64_t> expansions, Budget* budget) const {
  const Vec2 from = middle_of(start), to = middle_of(goal);
  const double whole = distance(from, to);
  auto detours = detours_of(cells_, from, to, options_.around, [&](Vec2 a, Vec2 b) { return !first_crossing(cells_, a, b); });
  PublishedWay way;
  way.ended = SearchEnd::found;
  std::vector<std::vector<Cell>> found;
  for (std::size_t i = 0; i < detours.size();) {
    const Detour& d = detours[i];
    const Cell begin = d.begin <= 0.0 ? start : cell_on(from, to, d.begin), end = d.end >= whole ? goal : cell_on(from, to, d.end);
    std::optional<std::int64_t> left;
    if (expansions) left = *expansions - way.expansions;
    const GridAnswer answer = search.run(graph_, nullptr, begin, end, left, budget);
    way.expansions += answer.expansions;
    ++way.local;
    if (answer.ended == SearchEnd::found) {
      found.push_back(answer.cells);
      ++i;
      continue;
    }
    // An end that is free can lie in a pocket.
    if (answer.ended == SearchEnd::unreachable) {
      if (const auto next = widened(detours, i, whole)) {
        i = *next;
        found.resize(i);
        continue;
      }
    }
    way.ended = answer.ended;
    way.known_at_once = answer.known_at_once && way.expansions == 0;
    return way;
  }
  way.points.push_back(from);
  for (const std::vector<Cell>& cells : found) {
    take_straight(middle_of(cells.front()), way.points);
    take_cells(cells, way.points);
  }
  take_straight(to, way.points);
  return way;
}

/// No occupied cell's middle nearer than the clearance to a straight line. Row by row what is near enough.
bool PublishedWays::is_clear(Vec2 from, Vec2 to) const {
  if (from.y > to.y) std::swap(from, to);
  const Vec2 way = to - from;
  const double squared = squared_norm(way);
  const int first = static_cast<int>(std::max(0.0, std::ceil(from.y - clearance_))), last = static_cast<int>(std::min(cells_.rows - 1.0, std::floor(to.y + clearance_)));
  for (int row = first; row <= last; ++row) {
    const auto x_at = [&](double y) { return way.y == 0.0 ? from.x : from.x + way.x * std::clamp((y - from.y) / way.y, 0.0, 1.0); };
    double low = x_at(row - clearance_), high = way.y == 0.0 ? to.x : x_at(row + clearance_);
    if (low > high) std::swap(low, high);
    const int left = static_cast<int>(std::max(0.0, std::ceil(low - clearance_))), right = static_cast<int>(std::min(cells_.columns - 1.0, std::floor(high + clearance_)));
    for (int column = left; column <= right; ++column) {
      if (cells_.occupied[cells_.index({column, row})] == 0) continue;
      const Vec2 p = middle_of({column, row});
      const double t = squared == 0.0 ? 0.0 : std::clamp(dot(p - from, way) / squared, 0.0, 1.0);
      if (squared_norm(p - (from + t * way)) < clearance_ * clearance_) return false;
    }
  }
  return true;
}

PublishedWay PublishedWays::boundary(Cell start, Cell goal, PublishedSearch& search, std::optional<std::int64_t> expansions, Budget* budget) const {
  PublishedWay way;
  const Vec2 from = middle_of(start), to = middle_of(goal);
  BoundaryTask task{cells_, *obstacles_, danger_, from, to, [&](Cell c) { return !first_crossing(cells_, middle_of(c), to) && is_clear(middle_of(c), to); }, false,
                    [&] { return budget != nullptr && budget->exhausted(); }};
  way.boundary = boundary_points(task);
  if (way.boundary.kind == BoundaryAnswer::Kind::straight) {
    way.ended = SearchEnd::found;
    way.points.push_back(from);
    take_straight(to, way.points);
    return way;
  }
  way.fell_back = way.boundary.kind == BoundaryAnswer::Kind::none;
  const GridAnswer answer = search.run(graph_, &danger_, start, way.fell_back ? goal : way.boundary.last, expansions, budget);
  way.ended = answer.ended;
  way.known_at_once = answer.known_at_once;
  way.expansions = answer.expansions;
  take_cells(answer.cells, way.points);
  if (answer.ended == SearchEnd::found) take_straight(to, way.points);
  return way;
}

}  // namespace waywright
