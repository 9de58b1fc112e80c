// What is seen from a place, mostly told by a table of directions, without looking along the line.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

/// Directions from the place are cut into bins. Up to some distance all of a bin is seen, from some distance on nothing of it: behind an edge that spans it, or behind
/// where its middle comes too near to something whatever the ray. The space's table tells, once the bin is asked for. What lies between is asked of the edges that the bin meets. One object, one thread; the space outlives it.
///
/// Law: sees(point) is space.is_free(point, from()), up to rounding where the line just touches.
class PlaneView {
 public:
  PlaneView() = default;
  PlaneView(const PlaneSpace& space, Vec2 from);

  bool is_ready() const { return space_ != nullptr; }
  Vec2 from() const { return from_; }

  enum class Seen { no, yes, not_told };
  /// What the table tells. @pre is_ready()
  Seen seen(Vec2 point) {
    const Vec2 to = point - from_;
    const double squared = squared_norm(to);
    const std::size_t i = index(to);
    Bin& bin = bins_[i];
    if (bin.seen < 0.0) {
      if (squared > bin.hidden) return Seen::no;
      if (const double all = bundle_seen(i / bundle); squared < all * all) return Seen::yes;
      fill(i);
    }
    return squared < bin.seen ? Seen::yes : squared > bin.hidden ? Seen::no : Seen::not_told;
  }
  bool sees(Vec2 point) {
    const Seen told = seen(point);
    return told == Seen::not_told ? sees_beyond(point) : told == Seen::yes;
  }
  /// What the table leaves open: the few edges that are seen in the place's direction are looked at. @pre seen(point) is not_told
  bool sees_beyond(Vec2 point);
  /// What the table tells of all within `radius` (m) of the middle: the place is seen from nowhere there, or from everywhere. @pre is_ready(), radius ≥ 0
  Seen seen_from_all(Vec2 middle, double radius);

  static constexpr std::size_t count = 2048;  ///< bins
  /// A number in [0, 4) that grows with the angle as the point goes around a square: no trigonometry.
  static double around(Vec2 v) {
    const double sum = std::abs(v.x) + std::abs(v.y);
    if (!(sum > 0.0)) return 0.0;
    const double share = v.y / sum;
    const double value = v.x < 0.0 ? 2.0 - share : share < 0.0 ? 4.0 + share : share;
    return value < 4.0 ? value : 0.0;
  }
  /// The bin of what is off the place by that.
  static std::size_t index(Vec2 v) { return static_cast<std::size_t>(around(v) * (static_cast<double>(count) / 4.0)); }
  /// What is known by now, for look-ups in single precision: of a direction's bin the squared distance (m²) up to which all is seen, and the one from which on nothing is.
  /// A bin off by one and a share of 1e-6 off do not matter. Both have `count`, and change as bins are asked for. @pre is_ready()
  const float* seen_squares() const { return seen_squares_.data(); }
  const float* hidden_squares() const { return hidden_squares_.data(); }

 private:
  static constexpr std::size_t together = 4, bundle = 32;
  struct Bin {
    double seen = -1.0;  // m², squared distance up to which all is seen; negative: not looked at yet
    double hidden = std::numeric_limits<double>::infinity();  // m², squared distance from which on nothing is
  };
  void hide_behind_edges();
  void gather_edges();
  double bundle_seen(std::size_t b);
  void fill(std::size_t i);
  void tell(std::size_t first, std::size_t bins);

  const PlaneSpace* space_ = nullptr;
  Vec2 from_{};
  double farthest_ = 0.0;  // m, of the region
  std::vector<Bin> bins_;
  // Edges of each bin, grown by what is needed: the i-th bin's are of_bin_[first_[i]] up to of_bin_[first_[i + 1]]. Made when the first is asked for.
  struct Edge {
    Vec2 a, b;     // from the place
    double near;   // m, no point of it is nearer
  };
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> first_, of_bin_;
  bool is_free_ = false, is_gathered_ = false;  // the place is
  std::vector<float> seen_squares_, hidden_squares_;
  std::vector<double> bundles_;  // m up to which all of so many bins is seen; negative: not looked at yet
};

}  // namespace waywright
