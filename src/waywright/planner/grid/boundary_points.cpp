#include "waywright/planner/grid/boundary_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace waywright {
namespace {

constexpr std::size_t most_corners = 1000;
constexpr int most_asked = 2000;  // cells, whether they see the goal

bool is_near_border(Vec2 p, const CellMap& cells, double reach) {
  return p.x < reach || p.y < reach || p.x > cells.columns - 1 - reach || p.y > cells.rows - 1 - reach;
}

/// Which obstacle keeps the vehicle out of a blocked cell.
std::uint32_t obstacle_at(const BoundaryTask& task, Cell cell) {
  const auto nearest = task.danger.field().nearest(cell.column, cell.row);
  return nearest ? task.obstacles.at(*nearest) : CellObstacles::none;
}

/// The cell nearest to a place that is free, without danger, and sees the goal.
std::optional<Cell> joining_cell(const BoundaryTask& task, Vec2 near) {
  const double reach = task.danger.reach_in_cells();
  const Cell middle = cell_at(near);
  const int farthest = static_cast<int>(std::min(200.0, std::ceil(12.0 * reach) + 8.0));
  struct Candidate {
    double squared;
    Cell cell;
  };
  // Ring by ring of so many cells: all that are nearer than the ring's inner edge are known before.
  std::vector<Candidate> waiting;
  constexpr int band = 4;
  int asked = 0;
  for (int out = 0; out <= farthest; out += band) {
    for (int r = -out - band + 1; r < out + band; ++r) {
      for (int c = -out - band + 1; c < out + band; ++c) {
        if (out > 0 && std::max(std::abs(r), std::abs(c)) < out) continue;
        const Cell cell{middle.column + c, middle.row + r};
        if (task.cells.is_blocked(cell)) continue;
        waiting.push_back({squared_norm(middle_of(cell) - near), cell});
      }
    }
    std::sort(waiting.begin(), waiting.end(), [](const Candidate& a, const Candidate& b) {
      if (a.squared != b.squared) return a.squared < b.squared;
      return a.cell.row != b.cell.row ? a.cell.row < b.cell.row : a.cell.column < b.cell.column;
    });
    const double known = out + band - 1.0;
    std::size_t i = 0;
    for (; i < waiting.size() && waiting[i].squared <= known * known; ++i) {
      if (task.is_over && task.is_over()) return std::nullopt;
      const Cell cell = waiting[i].cell;
      if (task.danger.at(cell) != 0.0) continue;
      if (++asked > most_asked) return std::nullopt;
      if (task.sees_goal(cell)) return cell;
    }
    waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Crossing> first_crossing(const CellMap& cells, Vec2 from, Vec2 to) {
  const double whole = distance(from, to);
  const int steps = std::max(1, static_cast<int>(std::ceil(4.0 * whole)));
  for (int i = 0; i <= steps; ++i) {
    const Vec2 p = from + (static_cast<double>(i) / steps) * (to - from);
    const Cell cell = cell_at(p);
    if (cells.contains(cell) && cells.is_blocked(cell)) return Crossing{p, cell};
  }
  return std::nullopt;
}

Vec2 shifted_away(Vec2 at, Vec2 outwards, const CellMap& cells, double reach) {
  constexpr int most_steps = 40;
  const double most = reach / 6.0;
  const int stride = std::max(1, static_cast<int>(reach / 40.0));  // of a wide reach not every cell is looked at
  if (const Cell cell = cell_at(at); cells.contains(cell) && cells.occupied[cells.index(cell)] != 0 && norm(outwards) > 0.0) at = at + (most / norm(outwards)) * outwards;
  const auto low = [&](double v) { return static_cast<int>(std::max(0.0, std::ceil(v - reach))); };
  const auto high = [&](double v, int count) { return static_cast<int>(std::min(count - 1.0, std::floor(v + reach))); };
  for (int i = 0; i < most_steps; ++i) {
    Vec2 shift{};
    for (int r = low(at.y); r <= high(at.y, cells.rows); r += stride) {
      for (int c = low(at.x); c <= high(at.x, cells.columns); c += stride) {
        if (cells.occupied[cells.index({c, r})] == 0) continue;
        const Vec2 away = at - middle_of({c, r});
        const double d = norm(away);
        if (d >= reach || d == 0.0) continue;
        shift = shift + ((reach - d) / d) * away;
      }
    }
    const double length = norm(shift);
    if (length <= 1e-9) break;
    at = at + (std::min(length, most) / length) * shift;
  }
  return at;
}

BoundaryAnswer boundary_points(const BoundaryTask& task) {
  const double reach = task.danger.reach_in_cells();
  BoundaryAnswer answer;
  const auto none = [&](std::string why) {
    answer.kind = BoundaryAnswer::Kind::none;
    answer.why = std::move(why);
    return answer;
  };
  Vec2 at = task.start;
  while (const auto crossing = first_crossing(task.cells, at, task.goal)) {
    if (task.is_over && task.is_over()) return none("it was ended");
    if (answer.corners.size() == most_corners) return none("a thousand corners were passed without seeing the goal");
    const std::uint32_t label = obstacle_at(task, crossing->cell);
    if (label == CellObstacles::none) return none("the line leaves the map");
    const CellObstacles::Obstacle& obstacle = task.obstacles.all()[label];
    const Vec2* best = nullptr;
    for (const Vec2& corner : obstacle.corners) {
      if (is_near_border(corner, task.cells, reach) || std::find(answer.corners.begin(), answer.corners.end(), corner) != answer.corners.end()) continue;
      if (best == nullptr || distance(corner, crossing->at) < distance(*best, crossing->at)) best = &corner;
    }
    // Where the line only grazes the corner that it begins beside, a cell near by sees the goal past it.
    if (best == nullptr && !answer.corners.empty() && distance(crossing->at, at) <= 2.0 * reach) break;
    if (best == nullptr) return none("no corner is left of an obstacle on the line to the goal");
    Vec2 middle{};
    for (const Vec2 corner : obstacle.corners) middle = middle + (1.0 / static_cast<double>(obstacle.corners.size())) * corner;
    const Vec2 outwards = squared_norm(*best - middle) > 1e-12 ? *best - middle : left_of(task.goal - at);
    at = shifted_away(*best, outwards, task.cells, reach);
    answer.corners.push_back(*best);
    answer.shifted.push_back(at);
  }
  if (answer.corners.empty() && !(task.start_has_to_see && !task.sees_goal(cell_at(task.start)))) {
    answer.kind = BoundaryAnswer::Kind::straight;
    return answer;
  }
  const auto joined = joining_cell(task, at);
  if (!joined) return none(std::string{answer.corners.empty() ? "no cell near the start" : "no cell near the last corner"} + " sees the goal with the distance that straight parts keep");
  answer.kind = BoundaryAnswer::Kind::joined;
  answer.last = *joined;
  return answer;
}

}  // namespace waywright
