#include "waywright/planner/plane/blocked_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

namespace waywright {
namespace {

constexpr std::uint8_t deepest = 200;
constexpr double grown = 1e-6;  // cells, for rounding

/// Are eight cells from here on 0? Most are, and are passed over together.
bool are_eight_0(const std::uint8_t* cells) {
  std::uint64_t eight = 0;
  std::memcpy(&eight, cells, sizeof eight);
  return eight == 0;
}

/// Marks with 0 what a segment touches, row after row.
void touch(const Segment& segment, const ClearanceField& field, std::vector<std::uint8_t>& cells) {
  const double per_metre = 1.0 / field.cell();
  Vec2 a = per_metre * (segment.a - field.origin()), b = per_metre * (segment.b - field.origin());
  if (a.y > b.y) std::swap(a, b);
  const double columns = field.columns(), rows = field.rows();
  if (!(b.y >= -grown && a.y <= rows + grown)) return;
  const auto first = static_cast<int>(std::clamp(std::floor(a.y - grown), 0.0, rows - 1.0)), last = static_cast<int>(std::clamp(std::floor(b.y + grown), 0.0, rows - 1.0));
  const double across = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0.0;
  for (int row = first; row <= last; ++row) {
    // Where it enters and leaves the row; nearly level ones are taken whole.
    double low = std::min(a.x, b.x), high = std::max(a.x, b.x);
    if (b.y - a.y > 1e-3) {
      const double in = a.x + across * (std::clamp(row - grown, a.y, b.y) - a.y), out = a.x + across * (std::clamp(row + 1.0 + grown, a.y, b.y) - a.y);
      low = std::max(low, std::min(in, out));
      high = std::min(high, std::max(in, out));
    }
    const double slack = grown * (1.0 + std::abs(across));
    if (!(high + slack >= 0.0 && low - slack < columns)) continue;
    const auto from = static_cast<std::ptrdiff_t>(std::clamp(std::floor(low - slack), 0.0, columns - 1.0)), to = static_cast<std::ptrdiff_t>(std::clamp(std::floor(high + slack), 0.0, columns - 1.0));
    const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(row) * field.columns();
    std::fill(begin + from, begin + to + 1, std::uint8_t{0});
  }
}

}  // namespace

std::vector<std::uint8_t> blocked_cells(const World& world, const ClearanceField& field) {
  const auto columns = static_cast<std::size_t>(field.columns()), rows = static_cast<std::size_t>(field.rows());
  std::vector<std::uint8_t> cells(columns * rows, 0);
  if (rows < 3 || columns < 3) return cells;
  for (std::size_t row = 0; row < rows; ++row) {
    const float* const values = field.values().data() + (row << static_cast<unsigned>(field.row_shift()));
    for (std::size_t column = 0; column < columns; ++column) cells[row * columns + column] = values[column] == 0.0F ? 1 : 0;
  }
  for (const Segment& segment : world.index().segments()) touch(segment, field, cells);
  // Cells beside each other that no edge touches are alike: one of each stretch of a row is asked for, unless one above it was.
  for (std::size_t row = 0; row < rows; ++row) {
    std::uint8_t* const here = &cells[row * columns];
    const std::uint8_t* const below = row > 0 ? here - columns : nullptr;
    for (std::size_t first = 0; first < columns;) {
      if (here[first] == 0) {
        first += first + 8 <= columns && are_eight_0(here + first) ? 8 : 1;
        continue;
      }
      std::size_t end = first;
      bool is_blocked = false;
      for (; end < columns && here[end] != 0; ++end) is_blocked = is_blocked || (below != nullptr && below[end] != 0);
      is_blocked = is_blocked || world.is_blocked(field.origin() + field.cell() * Vec2{static_cast<double>(first) + 0.5, static_cast<double>(row) + 0.5});
      if (!is_blocked) std::fill(here + first, here + end, std::uint8_t{0});
      first = end;
    }
  }
  // Depths: one more than the least of the neighbours, there and back. Beyond the field nothing is known.
  const auto deepen = [&](std::uint8_t* cell, std::ptrdiff_t side) {
    const std::uint8_t* const next = cell + side * static_cast<std::ptrdiff_t>(columns);
    const int least = std::min(std::min<int>(cell[side], next[0]), std::min<int>(next[-1], next[1]));
    *cell = static_cast<std::uint8_t>(std::min<int>(*cell, std::min<int>(least + 1, deepest)));
  };
  for (std::size_t row = 0; row < rows; ++row) {
    const bool is_rim = row == 0 || row + 1 == rows;
    for (std::size_t column = 0; column < columns; ++column) {
      std::uint8_t& cell = cells[row * columns + column];
      if (cell == 0) {
        column += column + 8 <= columns && are_eight_0(&cell) ? 7 : 0;
        continue;
      }
      const bool has_neighbours = !is_rim && column > 0 && column + 1 < columns;
      cell = has_neighbours ? deepest : 1;
      if (has_neighbours) deepen(&cell, -1);
    }
  }
  for (std::size_t row = rows - 1; row-- > 1;) {
    std::uint8_t* const here = &cells[row * columns];
    for (std::size_t column = columns - 1; column-- > 1;) {
      if (here[column] != 0) deepen(here + column, 1);
      else if (column >= 8 && are_eight_0(here + column - 7)) column -= 7;
    }
  }
  return cells;
}

}  // namespace waywright
