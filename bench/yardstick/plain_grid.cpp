#include "plain_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>

namespace yardstick {
namespace {

struct Step {
  int dx, dy;
  double length;
};

std::vector<Step> steps_of(int neighbours) {
  std::vector<Step> steps{{1, 0, 1}, {-1, 0, 1}, {0, 1, 1}, {0, -1, 1}};
  const double root2 = std::sqrt(2.0), root5 = std::sqrt(5.0);
  if (neighbours >= 8) {
    for (const int x : {1, -1}) {
      for (const int y : {1, -1}) steps.push_back({x, y, root2});
    }
  }
  if (neighbours >= 16) {
    for (const int x : {1, -1}) {
      for (const int y : {1, -1}) {
        steps.push_back({2 * x, y, root5});
        steps.push_back({x, 2 * y, root5});
      }
    }
  }
  return steps;
}

bool is_free(const Grid& grid, int x, int y) {
  return x >= 0 && y >= 0 && x < grid.columns && y < grid.rows && grid.blocked[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(x)] == 0;
}

bool allowed(const Grid& grid, int x, int y, const Step& s) {
  if (!is_free(grid, x + s.dx, y + s.dy)) return false;
  if (std::abs(s.dx) == 2) return is_free(grid, x + s.dx / 2, y) && is_free(grid, x + s.dx / 2, y + s.dy);
  if (std::abs(s.dy) == 2) return is_free(grid, x, y + s.dy / 2) && is_free(grid, x + s.dx, y + s.dy / 2);
  if (s.dx == 0 || s.dy == 0) return true;
  const bool a = is_free(grid, x + s.dx, y), b = is_free(grid, x, y + s.dy);
  return grid.loose ? a || b : a && b;
}

double cost_of(const Grid& grid, int from, int to, const Step& s) {
  if (grid.danger.empty()) return s.length;
  return s.length * (1.0 + 0.5 * (static_cast<double>(grid.danger[static_cast<std::size_t>(from)]) + static_cast<double>(grid.danger[static_cast<std::size_t>(to)])));
}

using Entry = std::pair<double, int>;

}  // namespace

Found textbook_astar(const Grid& grid, int start, int goal, bool no_heuristic) {
  Found result;
  const std::vector<Step> steps = steps_of(grid.neighbours);
  const int gx = goal % grid.columns, gy = goal / grid.columns;
  const auto rest = [&](int x, int y) { return no_heuristic ? 0.0 : std::hypot(x - gx, y - gy); };
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::unordered_map<int, double> cost;
  std::unordered_map<int, int> parent;
  std::unordered_map<int, bool> closed;
  cost[start] = 0.0;
  open.push({rest(start % grid.columns, start / grid.columns), start});
  while (!open.empty()) {
    const int at = open.top().second;
    open.pop();
    if (closed[at]) continue;
    closed[at] = true;
    ++result.expansions;
    if (at == goal) {
      result.found = true;
      result.cost = cost[at];
      for (int c = at; c != start; c = parent[c]) result.cells.push_back(c);
      result.cells.push_back(start);
      std::reverse(result.cells.begin(), result.cells.end());
      return result;
    }
    const int x = at % grid.columns, y = at / grid.columns;
    for (const Step& s : steps) {
      if (!allowed(grid, x, y, s)) continue;
      const int next = at + s.dy * grid.columns + s.dx;
      const double sum = cost[at] + cost_of(grid, at, next, s);
      const auto known = cost.find(next);
      if (known != cost.end() && known->second <= sum) continue;
      cost[next] = sum;
      parent[next] = at;
      closed[next] = false;
      open.push({sum + rest(x + s.dx, y + s.dy), next});
    }
  }
  return result;
}

Found heap_astar(const Grid& grid, int start, int goal, bool no_heuristic) {
  Found result;
  const std::vector<Step> steps = steps_of(grid.neighbours);
  const int gx = goal % grid.columns, gy = goal / grid.columns;
  const double root2 = std::sqrt(2.0);
  const auto rest = [&](int x, int y) -> double {
    if (no_heuristic) return 0.0;
    const int dx = std::abs(x - gx), dy = std::abs(y - gy);
    if (grid.neighbours == 4) return dx + dy;
    if (grid.neighbours == 8) return std::max(dx, dy) - std::min(dx, dy) + root2 * std::min(dx, dy);
    return std::sqrt(static_cast<double>(dx) * dx + static_cast<double>(dy) * dy);
  };
  const auto cells = static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
  std::vector<double> cost(cells, std::numeric_limits<double>::infinity());
  std::vector<int> parent(cells, -1);
  std::vector<std::uint8_t> closed(cells, 0);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost[static_cast<std::size_t>(start)] = 0.0;
  open.push({rest(start % grid.columns, start / grid.columns), start});
  while (!open.empty()) {
    const int at = open.top().second;
    open.pop();
    if (closed[static_cast<std::size_t>(at)] != 0) continue;
    closed[static_cast<std::size_t>(at)] = 1;
    ++result.expansions;
    if (at == goal) {
      result.found = true;
      result.cost = cost[static_cast<std::size_t>(at)];
      for (int c = at; c != -1; c = parent[static_cast<std::size_t>(c)]) result.cells.push_back(c);
      std::reverse(result.cells.begin(), result.cells.end());
      return result;
    }
    const int x = at % grid.columns, y = at / grid.columns;
    for (const Step& s : steps) {
      if (!allowed(grid, x, y, s)) continue;
      const int next = at + s.dy * grid.columns + s.dx;
      if (closed[static_cast<std::size_t>(next)] != 0) continue;
      const double sum = cost[static_cast<std::size_t>(at)] + cost_of(grid, at, next, s);
      if (cost[static_cast<std::size_t>(next)] <= sum) continue;
      cost[static_cast<std::size_t>(next)] = sum;
      parent[static_cast<std::size_t>(next)] = at;
      open.push({sum + rest(x + s.dx, y + s.dy), next});
    }
  }
  return result;
}

std::vector<std::int32_t> plain_distances(const Grid& grid) {
  const int w = grid.columns, h = grid.rows;
  const std::int64_t far = static_cast<std::int64_t>(w) + h;
  std::vector<std::int64_t> along(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y) * static_cast<std::size_t>(w) + static_cast<std::size_t>(x); };
  for (int x = 0; x < w; ++x) {
    for (int y = 0; y < h; ++y) along[at(x, y)] = grid.blocked[at(x, y)] != 0 ? 0 : y > 0 ? along[at(x, y - 1)] + 1 : far;
    for (int y = h - 2; y >= 0; --y) along[at(x, y)] = std::min(along[at(x, y)], along[at(x, y + 1)] + 1);
  }
  std::vector<std::int32_t> out(along.size());
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      std::int64_t best = std::numeric_limits<std::int32_t>::max();
      for (int i = 0; i < w; ++i) {
        if (along[at(i, y)] < far) best = std::min(best, (x - i) * static_cast<std::int64_t>(x - i) + along[at(i, y)] * along[at(i, y)]);
      }
      out[at(x, y)] = static_cast<std::int32_t>(best);
    }
  }
  return out;
}

}  // namespace yardstick
