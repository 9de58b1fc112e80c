#include "waywright/planner/plane/clearance_tiles.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/planner/plane/blocked_cells.hpp"

namespace waywright {
namespace {

// Numbers of cells: 0 is not told, then distances up to `sharp` in equal steps, then such that each is more by the same share than the one before, then depths in cells.
constexpr std::size_t first_distance = 1, first_coarse = 81, first_depth = 206;

/// 0 at least; some side by side, which do not wait for each other.
float greatest_of(const std::vector<float>& values) {
  constexpr std::size_t wide = 8;
  std::array<float, wide> most{};
  std::size_t i = 0;
  for (; i + wide <= values.size(); i += wide) {
    for (std::size_t k = 0; k < wide; ++k) most[k] = most[k] < values[i + k] ? values[i + k] : most[k];
  }
  for (; i < values.size(); ++i) most[0] = std::max(most[0], values[i]);
  return *std::max_element(most.begin(), most.end());
}

}  // namespace

void ClearanceTiles::choose_meanings(double sharp, double greatest, double cell) {
  meanings_.fill(not_told);
  step_ = sharp / static_cast<double>(first_coarse - first_distance - 1);
  for (std::size_t n = first_distance; n < first_coarse; ++n) meanings_[n] = step_ * static_cast<double>(n - first_distance);
  const double share = std::pow(std::max(1.0, greatest / sharp), 1.0 / static_cast<double>(first_depth - first_coarse));
  for (std::size_t n = first_coarse; n < first_depth; ++n) meanings_[n] = share * meanings_[n - 1];
  for (std::size_t n = first_depth; n < meanings_.size(); ++n) meanings_[n] = 2.0 * not_told - 0.999999 * cell * static_cast<double>(n - first_depth);
}

ClearanceTiles::ClearanceTiles(const World& world, const ClearanceField& field, double sharp)
    : origin_{field.origin()}, cells_per_metre_{1.0 / field.cell()}, columns_{static_cast<double>(field.columns())}, rows_{static_cast<double>(field.rows())} {
  const auto columns = static_cast<std::uint32_t>(field.columns()), rows = static_cast<std::uint32_t>(field.rows());
  tiles_ = ((columns + side - 1) / side) | 1U;
  values_.resize(std::size_t{(rows + side - 1) / side} * side * tiles_ * side);
  const float greatest = greatest_of(field.values());
  choose_meanings(sharp, greatest, field.cell());
  const auto distances = meanings_.begin() + first_distance, end = meanings_.begin() + first_depth;
  const std::vector<std::uint8_t> blocked = blocked_cells(world, field);
  // The number of a distance, from the one of a little less: of equal shares of the greatest one.
  constexpr std::size_t shares = 4096;
  const double per_share = greatest > 0.0F ? shares / static_cast<double>(greatest) : 0.0;
  std::array<std::uint8_t, shares + 1> numbers;
  for (std::size_t i = 0; i <= shares; ++i) {
    const double least = per_share > 0.0 ? static_cast<double>(i) / per_share : 0.0;
    numbers[i] = static_cast<std::uint8_t>(std::max<std::ptrdiff_t>(std::upper_bound(distances, end, 0.999999 * least) - meanings_.begin() - 1, first_distance));
  }
  for (std::uint32_t row = 0; row < rows; ++row) {
    const float* const from = field.values().data() + (std::size_t{row} << field.row_shift());
    const std::uint8_t* const deep = blocked.data() + std::size_t{row} * columns;
    std::uint8_t* const to = &values_[index(0, row)];
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double known = from[column];
      if (!(known >= 0.0)) continue;
      std::uint8_t& value = to[column / side * side * side + column % side];
      if (deep[column] > 0) {
        value = static_cast<std::uint8_t>(std::min(first_depth + deep[column] - 1, meanings_.size() - 1));
        continue;
      }
      // A share is less than a step: the next number may be the one, no later one.
      const std::size_t number = numbers[static_cast<std::size_t>(static_cast<std::int32_t>(known * per_share))], next = std::min(number + 1, first_depth - 1);
      value = static_cast<std::uint8_t>(meanings_[next] <= known ? next : number);
    }
  }
}

}  // namespace waywright
