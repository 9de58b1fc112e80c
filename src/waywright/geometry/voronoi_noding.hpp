// Segments in whole numbers, cut until they meet at their ends alone.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace waywright {

struct GridPoint {
  std::int32_t x = 0, y = 0;
  friend constexpr auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

struct GridSegment {
  GridPoint a, b;  ///< a < b; a == b is a point
  friend constexpr auto operator<=>(const GridSegment&, const GridSegment&) = default;
};

struct Noded {
  std::vector<GridSegment> segments;  ///< sorted, none twice, no point that is on a segment
  int rounds = 0;                     ///< in which something was cut; each moved what it cut by half a diagonal of a unit at most
};

/// Segments that cross are cut at the nearest whole place, those that another one's end lies on there. Ends when nothing has to be cut any more: the union is the same up
/// to √½ a round. Empty where that is not so after 64 rounds. @pre |coordinates| ≤ 2²⁸
std::optional<Noded> noded(std::vector<GridSegment> segments);

}  // namespace waywright
