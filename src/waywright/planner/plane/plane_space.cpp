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
constexpr std::size_t first_pieces = 4, most_pieces = 12;  // of a line that are looked at at once

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
  table_ = ClearanceTiles{problem.world(), field_, options.sharp};
  slack_ = field_.slack() + table_.step();
  table_reach_ = options.sharp;
  const double slack = field_.slack();
  std::int64_t cells = 0;
  for (const float value : field_.values()) cells += value >= 0.0F && value + slack > needed_ ? 1 : 0;
  free_area_ = static_cast<double>(cells) * field_.cell() * field_.cell();
}

bool PlaneSpace::is_free(Vec2 point, double margin) const {
  const double known = table_.at(point);
  if (known > margin) return true;
  if ((known >= 0.0 && known + slack_ <= std::min(margin, table_reach_)) || ClearanceTiles::is_blocked(known)) return false;
  return keeps(point, point, margin, known > 0.0);
}

bool PlaneSpace::is_free(Vec2 from, Vec2 to, double margin) const {
  const double length = distance(from, to);
  if (!(length > 0.0)) return is_free(from, margin);
  return is_free_between(from, to, length, table_.at(from) - margin, table_.at(to) - margin, margin, nullptr);
}

/// What both ends do not cover is cut into pieces, which are looked at in their middles and do not wait for each other: the middle's room covers the piece, or part of
/// it, and what is left is cut in two, or something is too near there for sure. What stays open when pieces are short, or are many, is asked of the outlines.
bool PlaneSpace::is_free_between(Vec2 from, Vec2 to, double length, double room_from, double room_to, double margin, Line* line) const {
  if (!(length > 0.0)) return is_free(from, margin);
  const Vec2 along = (1.0 / length) * (to - from);
  const double shortest = 0.25 * field_.cell();  // half a piece; less than that leads nowhere
  const double begin = std::max(0.0, room_from), end = length - std::max(0.0, room_to);  // what is not known to be free yet
  if (begin > end) return true;
  const double half_of_first = 0.5 * (end - begin) / static_cast<double>(first_pieces);
  std::array<double, first_pieces> middles, told;
  for (std::size_t i = 0; i < first_pieces; ++i) {
    middles[i] = begin + static_cast<double>(2 * i + 1) * half_of_first;
    told[i] = table_.at(from + middles[i] * along);
  }
  const double least = *std::min_element(told.begin(), told.end()) - margin;
  if (least > half_of_first) {
    // The discs that cover the line reach so far beyond it that they cover all that is as near as that, between them, too.
    if (line != nullptr) line->around = std::min({0.5 * (least - half_of_first), room_from, room_to});
    return true;
  }
  double most = -1.0;  // blocked, as a share of the distance: what hides most
  for (std::size_t i = 0; i < first_pieces; ++i) {
    const double blocked = blocked_around(told[i], margin);
    if (blocked < 0.0) continue;
    if (line == nullptr) return false;
    if (!(blocked > most * middles[i])) continue;
    most = blocked / middles[i];
    line->hit = middles[i];
    line->blocked = blocked;
  }
  if (most >= 0.0) return false;
  struct Stretch {
    double middle, half;
  };
  std::array<Stretch, 2 * most_pieces> memory, other_memory;
  Stretch *pieces = memory.data(), *parts = other_memory.data();
  std::size_t count = 0;
  double open_begin = length, open_end = 0.0;
  const auto cut = [&](double middle, double half, double known) {  // what of a piece is left, to `parts`
    const double covered = std::max(0.0, known - margin);
    if (covered > half) return;
    if (half < shortest) {
      open_begin = std::min(open_begin, middle - half);
      open_end = std::max(open_end, middle + half);
      return;
    }
    const double quarter = 0.5 * (half - covered);
    parts[count++] = {middle - covered - quarter, quarter};
    parts[count++] = {middle + covered + quarter, quarter};
  };
  for (std::size_t i = 0; i < first_pieces; ++i) cut(middles[i], half_of_first, told[i]);
  while (count > 0 && count <= most_pieces) {
    std::swap(pieces, parts);
    const std::size_t pieces_left = std::exchange(count, 0);
    for (std::size_t i = 0; i < pieces_left; ++i) {
      const auto [middle, half] = pieces[i];
      const double known = table_.at(from + middle * along);
      if (const double blocked = blocked_around(known, margin); blocked >= 0.0) {
        if (line != nullptr) line->hit = middle, line->blocked = blocked;
        return false;
      }
      cut(middle, half, known);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    open_begin = std::min(open_begin, parts[i].middle - parts[i].half);
    open_end = std::max(open_end, parts[i].middle + parts[i].half);
  }
  if (open_begin > open_end) return true;
  const Vec2 first = open_begin > 0.0 ? from + open_begin * along : from;
  return keeps(first, open_end < length ? from + open_end * along : to, margin, table_.at(first) > 0.0);
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

bool PlaneSpace::keeps(Vec2 from, Vec2 to, double margin, bool is_outside) const {
  const std::array<Vec2, 2> ends{from, to};
  const std::span ring{ends.data(), from == to ? 1U : 2U};
  return is_outside ? problem_.world().index().is_clear(ring, margin) : problem_.world().is_free(ring, margin);
}

}  // namespace waywright
