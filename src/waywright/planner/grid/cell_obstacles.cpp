#include "waywright/planner/grid/cell_obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/map/published_maps.hpp"

namespace waywright {
namespace {

double distance_to_line(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 way = b - a;
  const double length = std::sqrt(squared_norm(way));
  return length == 0.0 ? distance(p, a) : std::abs(way.x * (p.y - a.y) - way.y * (p.x - a.x)) / length;
}

/// A slanted side of cells has corners at its steps: what stands out from its neighbours' chord by less than a cell goes, the least first.
std::vector<Vec2> corners_of(std::vector<Vec2> ring) {
  constexpr double stands_out = 1.0;
  while (ring.size() > 3) {
    std::size_t least = 0;
    double by = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double d = distance_to_line(ring[i], ring[(i + ring.size() - 1) % ring.size()], ring[(i + 1) % ring.size()]);
      if (d >= by) continue;
      by = d;
      least = i;
    }
    if (by >= stands_out) break;
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(least));
  }
  return ring;
}

/// Calls with row, first and last column of every row whose middles the convex ring holds, border and a hair included. The ring has three corners at least.
template <class Take>
void rows_within(const Ring& ring, int columns, int rows, Take&& take) {
  constexpr double hair = 1e-8;
  const Box box = bounding_box(ring);
  for (int row = static_cast<int>(std::max(0.0, std::ceil(box.low.y - hair))); row <= std::min(rows - 1.0, std::floor(box.high.y + hair)); ++row) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      const double least = std::min(a.y, b.y), most = std::max(a.y, b.y);
      if (row < least - hair || row > most + hair) continue;
      if (most - least <= hair) {
        low = std::min({low, a.x, b.x});
        high = std::max({high, a.x, b.x});
        continue;
      }
      const double x = a.x + (b.x - a.x) * std::clamp((row - a.y) / (b.y - a.y), 0.0, 1.0);
      low = std::min(low, x);
      high = std::max(high, x);
    }
    if (!(low <= high)) continue;
    take(row, static_cast<int>(std::max(0.0, std::ceil(low - hair))), static_cast<int>(std::min(columns - 1.0, std::floor(high + hair))));
  }
}

}  // namespace

Cell cell_at(Vec2 p) { return {static_cast<int>(std::floor(p.x + 0.5)), static_cast<int>(std::floor(p.y + 0.5))}; }

CellObstacles::CellObstacles(int columns, int rows, const std::vector<std::uint8_t>& occupied) : columns_{columns}, label_(occupied.size(), none) {
  const auto width = static_cast<std::size_t>(columns);
  std::vector<std::uint32_t> cells;
  for (std::uint32_t first = 0; first < occupied.size(); ++first) {
    if (occupied[first] == 0 || label_[first] != none) continue;
    const auto label = static_cast<std::uint32_t>(all_.size());
    cells.assign(1, first);
    label_[first] = label;
    int low_row = rows, high_row = -1;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const int column = static_cast<int>(cells[i] % width), row = static_cast<int>(cells[i] / width);
      low_row = std::min(low_row, row);
      high_row = std::max(high_row, row);
      for (int r = std::max(0, row - 1); r <= std::min(rows - 1, row + 1); ++r) {
        for (int c = std::max(0, column - 1); c <= std::min(columns - 1, column + 1); ++c) {
          const std::size_t at = static_cast<std::size_t>(r) * width + static_cast<std::size_t>(c);
          if (occupied[at] == 0 || label_[at] != none) continue;
          label_[at] = label;
          cells.push_back(static_cast<std::uint32_t>(at));
        }
      }
    }
    // The hull is that of the first and last cell of each row.
    const auto height = static_cast<std::size_t>(high_row - low_row + 1);
    std::vector<int> left(height, columns), right(height, -1);
    for (const std::uint32_t cell : cells) {
      const auto r = static_cast<std::size_t>(static_cast<int>(cell / width) - low_row);
      left[r] = std::min(left[r], static_cast<int>(cell % width));
      right[r] = std::max(right[r], static_cast<int>(cell % width));
    }
    std::vector<Vec2> ends;
    for (std::size_t r = 0; r < height; ++r) {
      const double y = static_cast<double>(low_row) + static_cast<double>(r);
      ends.push_back({static_cast<double>(left[r]), y});
      if (right[r] != left[r]) ends.push_back({static_cast<double>(right[r]), y});
    }
    Obstacle obstacle;
    obstacle.cells = static_cast<std::int64_t>(cells.size());
    obstacle.hull = ends.size() < 3 ? Ring(ends) : convex_hull(ends);
    obstacle.corners = corners_of(obstacle.hull);
    if (obstacle.hull.size() < 3) {
      obstacle.is_convex = true;
    } else {
      std::int64_t within = 0;
      rows_within(obstacle.hull, columns, rows, [&](int, int low, int high) { within += high - low + 1; });
      obstacle.is_convex = within == obstacle.cells;
    }
    all_.push_back(std::move(obstacle));
  }
}

std::vector<std::uint8_t> with_regular_obstacles(int columns, int rows, const std::vector<std::uint8_t>& occupied, const std::vector<Cell>& kept_free) {
  std::vector<std::uint8_t> cells = occupied;
  const CellObstacles obstacles{columns, rows, occupied};
  for (const CellObstacles::Obstacle& obstacle : obstacles.all()) {
    if (obstacle.is_convex) continue;
    const Ring rectangle = regularised(obstacle.hull);
    bool is_in_the_way = false;
    rows_within(rectangle, columns, rows, [&](int row, int low, int high) {
      for (const Cell c : kept_free) is_in_the_way = is_in_the_way || (c.row == row && c.column >= low && c.column <= high);
    });
    if (is_in_the_way) continue;
    rows_within(rectangle, columns, rows, [&](int row, int low, int high) {
      for (int c = low; c <= high; ++c) cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(c)] = 1;
    });
  }
  return cells;
}

}  // namespace waywright
