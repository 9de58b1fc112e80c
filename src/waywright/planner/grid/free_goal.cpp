#include "waywright/planner/grid/free_goal.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/geometry/polygon.hpp"
#include "waywright/planner/grid/grid_words.hpp"

namespace waywright {
namespace {

/// Which cells have their middles in a ring: row by row, those with an odd number of its edges to their left.
class Inside {
 public:
  Inside(const GridFrame& frame, const Ring& ring) : frame_{frame} {
    Ring cells;
    for (const Vec2 p : ring) cells.push_back(frame.in_cells(p) - Vec2{0.5, 0.5});  // middles have whole numbers
    const Box box = bounding_box(cells);
    const auto within = [](double v, int most) { return static_cast<int>(std::clamp(v, -1.0, static_cast<double>(most))); };
    low_ = {std::max(0, within(std::ceil(box.low.x), frame.columns)), std::max(0, within(std::ceil(box.low.y), frame.rows))};
    high_ = {within(std::floor(box.high.x), frame.columns - 1), within(std::floor(box.high.y), frame.rows - 1)};
    if (high_.column < low_.column || high_.row < low_.row) return;
    width_ = high_.column - low_.column + 1;
    inside_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(high_.row - low_.row + 1), 0);
    for (int row = low_.row; row <= high_.row; ++row) fill(row, cells, ring);
  }

  bool has(Cell c) const { return c.column >= low_.column && c.row >= low_.row && c.column <= high_.column && c.row <= high_.row && inside_[index(c)] != 0; }
  Cell low() const { return low_; }
  Cell high() const { return high_; }

 private:
  /// Where rounding could decide, the true ring is asked at the true middle, as the proof will.
  void fill(int row, const Ring& cells, const Ring& ring) {
    constexpr double near = 1e-6;  // cells
    bool is_doubtful = false;
    std::vector<double> crossings;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Vec2 a = cells[i], b = cells[(i + 1) % cells.size()];
      is_doubtful = is_doubtful || std::abs(a.y - row) < near;
      if ((a.y > row) != (b.y > row)) crossings.push_back(a.x + (row - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::sort(crossings.begin(), crossings.end());
    std::size_t left = 0;
    for (int column = low_.column; column <= high_.column; ++column) {
      while (left < crossings.size() && crossings[left] < column) ++left;
      const bool is_near = (left < crossings.size() && crossings[left] - column < near) || (left > 0 && column - crossings[left - 1] < near);
      const bool is_in = is_doubtful || is_near ? contains(ring, frame_.centre({column, row})) : left % 2 == 1;
      inside_[index({column, row})] = is_in ? 1 : 0;
    }
  }

  std::size_t index(Cell c) const { return static_cast<std::size_t>(c.row - low_.row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(c.column - low_.column); }

  const GridFrame& frame_;
  Cell low_{}, high_{-1, -1};
  int width_ = 0;
  std::vector<std::uint8_t> inside_;
};

}  // namespace

std::vector<Cell> region_cells(const Problem& problem, const GridFrame& frame) {
  const Inside inside{frame, problem.free_goal()->area};
  std::vector<Cell> cells;
  const Vec2 middle{0.5 * (inside.low().column + inside.high().column), 0.5 * (inside.low().row + inside.high().row)};
  const auto off_middle = [&](Cell c) { return squared_norm(Vec2{static_cast<double>(c.column), static_cast<double>(c.row)} - middle); };
  Cell nearest{};
  bool any = false;
  constexpr int reach = 3;  // cells around a start, as wide as connections look
  const Vec2 start = frame.in_cells(problem.start().position());
  for (int row = inside.low().row; row <= inside.high().row; ++row) {
    for (int column = inside.low().column; column <= inside.high().column; ++column) {
      const Cell c{column, row};
      if (!inside.has(c)) continue;
      if (!any || off_middle(c) < off_middle(nearest)) nearest = c;
      any = true;
      const bool is_edge = std::any_of(moves.begin(), moves.end(), [&](const Move& m) { return !inside.has({column + m.column, row + m.row}); });
      const bool is_at_start = std::abs(column + 0.5 - start.x) <= reach + 1 && std::abs(row + 0.5 - start.y) <= reach + 1;
      if (is_edge || is_at_start) cells.push_back(c);
    }
  }
  if (any) cells.insert(cells.begin(), nearest);  // searches aim at the first
  return cells;
}

std::vector<GridEnd> free_ends(const Problem& problem, const GridFrame& frame, MotionCheck& test) {
  std::vector<GridEnd> ends;
  if (problem.free_goal()->is_point()) {
    for (const DiscConnection& c : disc_connections(problem, frame, problem.goal().position(), false, test)) ends.push_back({c.cell, c.cost / frame.cell});
  } else {
    for (const Cell c : region_cells(problem, frame)) ends.push_back({c, 0.0});
  }
  return ends;
}

double least_way(const Problem& problem) {
  const Vec2 start = problem.start().position();
  const FreeGoal* free = problem.free_goal();
  return distance(start, free == nullptr || free->is_point() ? problem.goal().position() : nearest_in(free->area, start));
}

std::string goal_words(const Problem& problem) {
  const FreeGoal* free = problem.free_goal();
  return free != nullptr && !free->is_point() ? "the region" : grid::place(problem.goal().position());
}

}  // namespace waywright
