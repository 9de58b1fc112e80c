#include "waywright/planner/grid/cell_danger.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr double most_blocks_out = 5.0;

double danger_of(double d, const DangerRule& rule) {
  double power = 1.0;
  for (int i = 0; i < rule.exponent; ++i) power *= rule.scale / d;
  return power;
}

}  // namespace

CellDanger::CellDanger(int columns, int rows, double cell, const std::vector<std::uint8_t>& occupied, const DangerRule& rule)
    : columns_{columns}, rows_{rows}, reach_{rule.reach / cell}, occupied_{occupied} {
  field_.assign(columns, rows, occupied_, false);
  // Powers of three: the middle of a block is a cell, and the block in the middle falls into nine of the next smaller size.
  int block = 1;
  while (reach_ > most_blocks_out * block) block *= 3;
  const auto add = [&](int c, int r, int side) {
    const double d = std::sqrt(static_cast<double>(r * r + c * c)) * side;
    if ((c != 0 || r != 0) && d <= reach_ * (1.0 + 1e-12)) parts_.push_back({c * side - side / 2, r * side - side / 2, side, danger_of(d * cell, rule) * cell * cell});
  };
  const int out = static_cast<int>(std::floor(reach_ / block)) + 1;
  for (int r = -out; r <= out; ++r) {
    for (int c = -out; c <= out; ++c) add(c, r, block);
  }
  for (int side = block / 3; side >= 1; side /= 3) {
    for (int r = -1; r <= 1; ++r) {
      for (int c = -1; c <= 1; ++c) add(c, r, side);
    }
  }
  if (block == 1) return;
  const std::size_t width = static_cast<std::size_t>(columns) + 1;
  sums_.assign(width * (static_cast<std::size_t>(rows) + 1), 0);
  for (std::size_t r = 0; r < static_cast<std::size_t>(rows); ++r) {
    std::uint32_t row = 0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(columns); ++c) {
      row += occupied_[r * static_cast<std::size_t>(columns) + c] != 0 ? 1U : 0U;
      sums_[(r + 1) * width + c + 1] = sums_[r * width + c + 1] + row;
    }
  }
}

std::int64_t CellDanger::count(int column, int row, int side) const {
  const int left = std::clamp(column, 0, columns_), right = std::clamp(column + side, 0, columns_);
  const int top = std::clamp(row, 0, rows_), bottom = std::clamp(row + side, 0, rows_);
  if (side == 1) return left < right && top < bottom && occupied_[static_cast<std::size_t>(top) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(left)] != 0 ? 1 : 0;
  const auto at = [&](int r, int c) { return static_cast<std::int64_t>(sums_[static_cast<std::size_t>(r) * (static_cast<std::size_t>(columns_) + 1) + static_cast<std::size_t>(c)]); };
  return at(bottom, right) - at(top, right) - at(bottom, left) + at(top, left);
}

double CellDanger::at(Cell c) const {
  const double squared = field_.squared(c.column, c.row);
  if (squared > reach_ * reach_ * (1.0 + 1e-12)) return 0.0;
  double sum = 0.0;
  for (const Part& p : parts_) sum += p.weight * static_cast<double>(count(c.column + p.column, c.row + p.row, p.side));
  return sum;
}

}  // namespace waywright
