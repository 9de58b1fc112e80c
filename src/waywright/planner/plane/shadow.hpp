// What certainly is not seen from a place, told without looking along a line.
#pragma once

#include <vector>

#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

/// Directions from the place are cut into bins; an edge that spans a whole bin hides everything in it that is farther than the edge. One pass over the map's edges.
///
/// Law: the straight line between the place and a point that is called dark crosses an edge of the map. (One that is not may do so, too.)
class Shadow {
 public:
  Shadow() = default;
  Shadow(const PlaneSpace& space, Vec2 light);

  bool is_ready() const { return !squares_.empty(); }
  Vec2 light() const { return light_; }
  bool is_dark(Vec2 point) const {
    if (squares_.empty()) return false;
    const Vec2 to = point - light_;
    return squared_norm(to) > squares_[bin(to)];
  }

 private:
  static constexpr int bins = 2048;
  /// A number in [0, 4) that grows with the angle as the point goes around a square: no trigonometry.
  static double around(Vec2 v) {
    const double sum = std::abs(v.x) + std::abs(v.y);
    if (!(sum > 0.0)) return 0.0;
    const double share = v.y / sum;
    const double value = v.x < 0.0 ? 2.0 - share : share < 0.0 ? 4.0 + share : share;
    return value < 4.0 ? value : 0.0;
  }
  static std::size_t bin(Vec2 v) { return static_cast<std::size_t>(around(v) * (bins / 4)); }
  static Vec2 direction(double around);

  Vec2 light_{};
  std::vector<double> squares_;  ///< m², by bin: of the distance from which on all is dark
};

}  // namespace waywright
