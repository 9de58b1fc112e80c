#include "waywright/planner/plane/clearance_tiles.hpp"

#include <algorithm>

namespace waywright {

ClearanceTiles::ClearanceTiles(const ClearanceField& field)
    : origin_{field.origin()}, cells_per_metre_{1.0 / field.cell()}, columns_{static_cast<double>(field.columns())}, rows_{static_cast<double>(field.rows())} {
  const auto columns = static_cast<std::uint32_t>(field.columns()), rows = static_cast<std::uint32_t>(field.rows());
  tiles_ = ((columns + wide - 1) / wide) | 1U;
  values_.resize(std::size_t{(rows + high - 1) / high} * high * tiles_ * wide);
  const float greatest = field.values().empty() ? 0.0F : *std::max_element(field.values().begin(), field.values().end());
  if (greatest > 0.0F) step_ = 1.000001 * static_cast<double>(greatest) / 65534.0;
  const double per_step = 1.0 / step_;
  for (std::uint32_t row = 0; row < rows; ++row) {
    const float* const from = field.values().data() + (std::size_t{row} << field.row_shift());
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double known = from[column];
      if (!(known >= 0.0)) continue;
      auto number = static_cast<std::uint16_t>(1 + static_cast<std::int32_t>(known * per_step));
      if (value(number) > known) --number;
      values_[index(column, row)] = number;
    }
  }
}

}  // namespace waywright
