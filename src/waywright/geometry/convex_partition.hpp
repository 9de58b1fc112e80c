// A simple polygon cut along diagonals into convex parts: few, and well shaped.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// Laws: the parts' corners are the ring's, their areas add up to the ring's, no two overlap; parts are joined by cuts as a tree.
struct ConvexPartition {
  struct Cut {
    std::size_t a = 0, b = 0;        ///< corners of the ring at its ends
    std::size_t left = 0, right = 0; ///< the parts beside it, as it is gone from a to b
  };
  std::vector<std::vector<std::size_t>> parts;  ///< corners of the ring, counter-clockwise
  std::vector<Cut> cuts;                        ///< one less than parts
};

/// Triangles by ears, made Delaunay by flips; then diagonals that are not needed are left out, the longest first (Hertel, Mehlhorn). No more than four times as many parts
/// as are needed. Empty where rounding leaves no ear, and where `stops`, asked for
/// each ear, ends it early.
/// @pre simple, counter-clockwise
std::optional<ConvexPartition> convex_partition(const Ring& ring, const std::function<bool()>& stops = {});

}  // namespace waywright
