// Which of many rings a point can be inside of: their boxes sorted into square bins.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

class RingBins {
 public:
  RingBins() = default;
  explicit RingBins(std::span<const Box> boxes);

  /// In rising order, those whose boxes can contain the point; with few rings all of them.
  std::span<const std::uint32_t> near(Vec2 point) const;

 private:
  bool sort_into(std::span<const Box> boxes, std::size_t most_entries);

  Box bounds_{};
  std::uint32_t columns_ = 0, rows_ = 0;
  double inverse_width_ = 0.0, inverse_height_ = 0.0;  // 1/m
  std::vector<std::uint32_t> begins_;                  // of each bin in `entries_`, and where the last one ends
  std::vector<std::uint32_t> entries_;
};

}  // namespace waywright
