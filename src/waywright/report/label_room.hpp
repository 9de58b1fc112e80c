// Where in a picture something is written or drawn already, so that names find a free place beside what they name.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// In pixels, y down.
class LabelRoom {
 public:
  void take(Vec2 point) {
    if (std::isfinite(point.x + point.y) && std::abs(point.x) < farthest && std::abs(point.y) < farthest) points_[cell_of(point)].push_back(point);
  }
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
  /// Does a text stand there?
  bool is_written_on(const Box& box) const {
    return std::any_of(boxes_.begin(), boxes_.end(), [&](const Box& b) { return b.low.x < box.high.x && box.low.x < b.high.x && b.low.y < box.high.y && box.low.y < b.high.y; });
  }
  /// 0: nothing is there. Another text weighs more than any line.
  double hidden_by(const Box& box) const {
    constexpr double text = 40.0;
    double sum = 0.0;
    for (const Box& b : boxes_) sum += b.low.x < box.high.x && box.low.x < b.high.x && b.low.y < box.high.y && box.low.y < b.high.y ? text : 0.0;
    const Cell first = cell_of(box.low), last = cell_of(box.high);
    for (int x = first.first; x <= last.first; ++x) {
      for (auto there = points_.lower_bound({x, first.second}); there != points_.end() && there->first <= Cell{x, last.second}; ++there) {
        for (const Vec2 p : there->second) sum += box.contains(p) ? 1.0 : 0.0;
      }
    }
    return sum;
  }

 private:
  using Cell = std::pair<int, int>;
  static constexpr double farthest = 1e6, cell_size = 48.0;  // px
  static Cell cell_of(Vec2 p) { return {static_cast<int>(std::floor(std::clamp(p.x, -farthest, farthest) / cell_size)), static_cast<int>(std::floor(std::clamp(p.y, -farthest, farthest) / cell_size))}; }

  std::vector<Box> boxes_;
  std::map<Cell, std::vector<Vec2>> points_;
};

}  // namespace waywright
