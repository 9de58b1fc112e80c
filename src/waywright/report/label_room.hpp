// Where in a picture something is written or drawn already, so that names find a free place beside what they name.
#pragma once

#include <algorithm>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// In pixels, y down.
class LabelRoom {
 public:
  void take(Vec2 point) { points_.push_back(point); }
  void take(const Box& box) { boxes_.push_back(box); }
  /// A line, by points some pixels apart.
  void take_line(const std::vector<Vec2>& points) {
    constexpr double apart = 6.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double length = distance(points[i], points[i + 1]);
      const int pieces = static_cast<int>(std::min(length / apart, 1e4)) + 1;
      for (int k = 0; k < pieces; ++k) take(points[i] + (static_cast<double>(k) / pieces) * (points[i + 1] - points[i]));
    }
    if (!points.empty()) take(points.back());
  }
  /// 0: nothing is there. Another text weighs more than any line.
  double hidden_by(const Box& box) const {
    constexpr double text = 40.0;
    double sum = 0.0;
    for (const Box& b : boxes_) sum += b.low.x < box.high.x && box.low.x < b.high.x && b.low.y < box.high.y && box.low.y < b.high.y ? text : 0.0;
    for (const Vec2 p : points_) sum += box.contains(p) ? 1.0 : 0.0;
    return sum;
  }

 private:
  std::vector<Box> boxes_;
  std::vector<Vec2> points_;
};

}  // namespace waywright
