// Chains joined to longer ones.
#pragma once

#include <vector>

#include "waywright/dxf/outline.hpp"

namespace waywright::dxf {

struct Joined {
  std::vector<Chain> closed;  ///< the first corner is not repeated
  std::vector<Chain> open;
  double widest_gap = 0.0;  ///< m, that was closed
};

/// Joins lines end to end where exactly two ends meet within rounding, and then where exactly two of those left are within `gap` of each other.
Joined joined(std::vector<Chain> lines, double gap);

}  // namespace waywright::dxf
