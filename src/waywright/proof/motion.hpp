// The vehicle's motion cut into intervals, each with rigorous bounds. Every kind of curve gives the same three facts about an
// interval: its two end poses, and how far the true motion can be from the straight interpolation between them.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "waywright/curve/span_bounds.hpp"
#include "waywright/path/path.hpp"

namespace waywright {

/// An interval of one smooth curve.
///
/// Law: for every pose of the true motion in it there is a λ in [0, 1] such that each body point at most r from the origin is
/// within deviation(r) of the point λ of the way between its places at `begin` and `end`.
class MotionInterval {
 public:
  /// All intervals of a piece, one per smooth curve. Headings at the ends are continuous (not wrapped) within an interval.
  static std::vector<MotionInterval> of(const Piece& piece);

  const Pose& begin() const { return begin_; }
  const Pose& end() const { return end_; }
  /// m; +∞ where the course is not bounded on the interval (a cusp).
  double deviation(double radius) const;
  /// m, by how much rounding can put a body point at most r from the origin elsewhere than the exact curve has it, at the ends.
  double rounding(double radius) const;
  /// Every body point moves straight, without turning: the hull of the ends is all that is swept.
  bool is_translation() const;
  /// How often the curve was halved to get here.
  int depth() const { return depth_; }
  /// Halves that join.
  std::pair<MotionInterval, MotionInterval> halve() const;

  /// Greatest |κ| in 1/m (upper bound; +∞ at a cusp).
  double curvature_bound() const;
  /// Greatest |dκ/ds| in 1/m² (upper bound).
  double curvature_rate_bound() const;
  double curvature_at_begin() const;
  double curvature_at_end() const;
  double curvature_rate_at_begin() const;

  /// m, by Gauss–Legendre or closed form
  double length() const;

 private:
  struct Polynomial {  // Bézier span with what bounds it
    BezierSpan span;
    SpanBounds bounds;
  };
  struct Circular {
    Arc arc;
  };
  struct Straight {};  // straight interpolation of position and heading: exact

  double curvature_at(double u) const;
  std::pair<MotionInterval, MotionInterval> halves() const;
  static MotionInterval make(Polynomial polynomial, int direction);
  static MotionInterval make(const Arc& arc, int direction);

  Pose begin_{};
  Pose end_{};
  int direction_ = 1;
  int depth_ = 0;
  const Polynomial* polynomial() const;

  /// A polynomial is kept apart: it is large, and imported poses make very many straight intervals.
  std::variant<Straight, Circular, std::shared_ptr<const Polynomial>> curve_;
};

}  // namespace waywright
