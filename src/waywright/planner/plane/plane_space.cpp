#include "waywright/planner/plane/plane_space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "waywright/planner/grid/motion_check.hpp"

namespace waywright {
namespace {

constexpr double cells_across = 600.0;        // of the table, along the longer side of the region
constexpr double least_cell = 0.02;           // m
constexpr std::size_t most_cells = 1U << 20U;

/// Taut ways lie in the hull of the ends and of obstacles grown by what is kept from them; more room serves searches that are not taut.
Box region_of(const Problem& problem, double needed) {
  const World& world = problem.world();
  const Vec2 start = problem.start().position(), goal = problem.goal().position();
  std::vector<Vec2> ends{start, goal};
  if (const FreeGoal* free = problem.free_goal()) ends.insert(ends.end(), free->area.begin(), free->area.end());
  const Box between = bounding_box(ends);
  Box box = between;
  if (!world.empty()) {
    const Box known = world.bounds();
    box.low = {std::min(box.low.x, known.low.x), std::min(box.low.y, known.low.y)};
    box.high = {std::max(box.high.x, known.high.x), std::max(box.high.y, known.high.y)};
  }
  const double room = 4.0 * needed + 0.5;
  box = {box.low - Vec2{room, room}, box.high + Vec2{room, room}};
  const auto keep_inside = [&box](const Box& other) {
    box.low = {std::max(box.low.x, other.low.x), std::max(box.low.y, other.low.y)};
    box.high = {std::min(box.high.x, other.high.x), std::min(box.high.y, other.high.y)};
  };
  for (const Ring& boundary : world.map().boundaries) keep_inside(bounding_box(boundary));
  for (const CellGrid& grid : world.map().grids) {
    if (grid.bounds) keep_inside(bounding_box({grid.corner(0, 0), grid.corner(grid.columns, 0), grid.corner(0, grid.rows), grid.corner(grid.columns, grid.rows)}));
  }
  if (const auto* station = std::get_if<Station>(&problem.scenario().mission)) keep_inside(bounding_box(station->area));
  // Ends are in it whatever bounds the world, and it is never empty.
  return {{std::min(box.low.x, between.low.x) - 1e-3, std::min(box.low.y, between.low.y) - 1e-3}, {std::max(box.high.x, between.high.x) + 1e-3, std::max(box.high.y, between.high.y) + 1e-3}};
}

}  // namespace

PlaneSpace::PlaneSpace(const Problem& problem)
    : problem_{problem}, disc_{problem.footprint().radius()}, needed_{disc_ + lattice_margin(problem)}, region_{region_of(problem, needed_)} {
  const Vec2 size = region_.high - region_.low;
  ClearanceField::Options options;
  options.cell = std::max(least_cell, std::max(size.x, size.y) / cells_across);
  options.sharp = needed_ + 4.0 * options.cell;
  options.cap = needed_ + std::max(2.0, 64.0 * options.cell);
  options.most_cells = most_cells;
  field_ = ClearanceField{problem.world(), region_, options};
  table_reach_ = options.sharp;
  const double slack = field_.slack();
  std::int64_t cells = 0;
  for (const float value : field_.values()) cells += value >= 0.0F && value + slack > needed_ ? 1 : 0;
  free_area_ = static_cast<double>(cells) * field_.cell() * field_.cell();
}

bool PlaneSpace::is_free(Vec2 point, double margin) const {
  const double known = field_.at(point);
  if (known > margin) return true;
  if (known >= 0.0 && known + field_.slack() <= std::min(margin, table_reach_)) return false;
  return keeps(point, point, margin);
}

bool PlaneSpace::is_free(Vec2 from, Vec2 to, double margin) const {
  const Vec2 way = to - from;
  const double length = norm(way);
  if (!(length > 0.0)) return is_free(from, margin);
  const Vec2 along = (1.0 / length) * way;
  const double slack = field_.slack(), reach = std::min(margin, table_reach_);
  double driven = 0.0;
  while (true) {
    const Vec2 here = from + driven * along;
    const double known = field_.at(here);
    const double free = known - margin;
    if (free > 0.0) {
      driven += free;  // nothing is nearer than what is needed to any point of the way up to there
      if (driven > length) return true;
      continue;
    }
    if (known >= 0.0 && known + slack <= reach) return false;
    return keeps(here, to, margin);
  }
}

bool PlaneSpace::may_join(Vec2 from, Vec2 to) const {
  const int columns = field_.columns(), rows = field_.rows();
  const auto cell_of = [&](Vec2 p) {
    const Vec2 off = (1.0 / field_.cell()) * (p - field_.origin());
    return std::pair{std::clamp(static_cast<int>(off.x), 0, columns - 1), std::clamp(static_cast<int>(off.y), 0, rows - 1)};
  };
  const auto index = [&](int column, int row) { return (static_cast<std::size_t>(row) << field_.row_shift()) + static_cast<std::size_t>(column); };
  std::vector<bool> seen(field_.values().size(), false);
  const auto [c, r] = cell_of(from);
  const auto [goal_column, goal_row] = cell_of(to);
  std::vector<std::pair<int, int>> waiting{{c, r}};
  seen[index(c, r)] = true;
  const double slack = field_.slack();
  while (!waiting.empty()) {
    const auto [column, row] = waiting.back();
    waiting.pop_back();
    if (column == goal_column && row == goal_row) return true;
    for (int dr = -1; dr <= 1; ++dr) {
      for (int dc = -1; dc <= 1; ++dc) {  // across corners, too: a way may lead through one
        const int nc = column + dc, nr = row + dr;
        if (nc < 0 || nr < 0 || nc >= columns || nr >= rows || seen[index(nc, nr)]) continue;
        seen[index(nc, nr)] = true;
        const double value = field_.values()[index(nc, nr)];
        if (value >= 0.0 && value + slack <= needed_) continue;  // nowhere in it
        waiting.emplace_back(nc, nr);
      }
    }
  }
  return false;
}

bool PlaneSpace::keeps(Vec2 from, Vec2 to, double margin) const {
  const std::array<Vec2, 2> ends{from, to};
  return problem_.world().is_free(std::span{ends.data(), from == to ? 1U : 2U}, margin);
}

}  // namespace waywright
