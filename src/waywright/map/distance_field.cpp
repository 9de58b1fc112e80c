#include "waywright/map/distance_field.hpp"

#include <algorithm>
#include <cstring>

#include "waywright/map/distance_rows.hpp"

namespace waywright {

/// Down and up again, a whole row at a time.
void DistanceField::measure_columns(std::span<const std::uint8_t> blocked) {
  const auto width = static_cast<std::size_t>(columns_);
  std::vector<std::int16_t> row(width, is_bounded_ ? std::int16_t{0} : distance_rows::far);
  for (int r = 0; r < rows_; ++r) {
    const std::size_t at = index(0, r);
    distance_rows::step_down(row.data(), blocked.data() + at, vertical_.data() + at, columns_);
  }
  std::fill(row.begin(), row.end(), is_bounded_ ? std::int16_t{0} : distance_rows::far);
  for (int r = rows_ - 1; r >= 0; --r) distance_rows::step_up(row.data(), vertical_.data() + index(0, r), columns_);
}

void DistanceField::assign(int columns, int rows, std::span<const std::uint8_t> blocked, bool is_bounded) {
  columns_ = columns;
  rows_ = rows;
  is_bounded_ = is_bounded;
  const std::size_t cells = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  vertical_.resize(cells);
  squared_.resize(cells);
  measure_columns(blocked);
  distance_rows::Workspace workspace{columns, is_bounded};
  for (int r = 0; r < rows; ++r) workspace.row(vertical_.data() + index(0, r), squared_.data() + index(0, r));
}

std::optional<Cell> DistanceField::nearest(int column, int row) const {
  const std::int32_t wanted = squared(column, row);
  if (wanted == nowhere) return std::nullopt;
  for (int k = 0; k * k <= wanted; ++k) {
    for (const int c : {column - k, column + k}) {
      if (c < -1 || c > columns_ || (!is_bounded_ && (c < 0 || c >= columns_))) continue;
      if (c < 0 || c >= columns_) {
        if (k * k == wanted) return Cell{c, row};
        continue;
      }
      const std::int32_t g = vertical_[index(c, row)];
      if (k * k + g * g != wanted) continue;
      // Above or below: the column's distance falls by one a cell on the way there, or the edge comes.
      const auto is_there = [&](int r) { return r < 0 || r >= rows_ ? is_bounded_ && (r == -1 || r == rows_) : vertical_[index(c, r)] == 0; };
      return Cell{c, is_there(row - g) ? row - g : row + g};
    }
  }
  return std::nullopt;
}

}  // namespace waywright
