// The vehicle's motion cut into intervals, each with rigorous bounds. Every kind of curve gives the same three facts about an
// interval: its two end poses, and how far the true motion can be from the straight interpolation between them.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "waywright/path/path.hpp"
#include "waywright/proof/bernstein.hpp"

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
    Bernstein turn;     // N = x′y″ − y′x″
    Bernstein speed2;   // D = x′² + y′²
    Bernstein rate;     // M = N′D − 3/2·N·D′, so that dκ/ds = M/D³
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
  std::variant<Straight, Circular, Polynomial> curve_;
};

}  // namespace waywright
