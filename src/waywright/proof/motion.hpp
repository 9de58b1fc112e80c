// The vehicle's motion cut into intervals, each with rigorous bounds. Every kind of curve gives the same three facts about an
// interval: its two end poses, and how far the true motion can be from the straight interpolation between them.
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "waywright/curve/span_bounds.hpp"
#include "waywright/path/path.hpp"

namespace waywright {

/// A Bézier span with what bounds its turning.
struct BoundedSpan {
  BezierSpan span;
  CurvatureBounds bounds;
};

struct MotionHalves;

/// An interval of one smooth curve. That of a Bézier span refers to a span that is kept elsewhere: it is large, and imported poses make
/// very many straight intervals.
///
/// Law: for every pose of the true motion in it there is a λ in [0, 1] such that each body point at most r from the origin is
/// within deviation(r) of the point λ of the way between its places at `begin` and `end`.
class MotionInterval {
 public:
  /// Headings at the ends are continuous (not wrapped) within an interval.
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

  /// rad, of the curve followed, in its direction of travel: where the vehicle faces along, the heading or its opposite. Continuous within an
  /// interval. @pre it is no straight interpolation
  double course_at_begin() const;
  double course_at_end() const;
  double curvature_at_begin() const;
  double curvature_at_end() const;
  /// dκ/ds where it is the same everywhere, 1/m². @pre there is no span
  double curvature_rate() const;
  /// The Bézier span followed; nullptr where it is another curve, whose curvature changes evenly.
  const BoundedSpan* span() const;
  /// Pose at a parameter of the span. @pre there is one
  Pose pose_at(double u) const;

  /// m, by Gauss–Legendre or closed form
  double length() const;

 private:
  friend class Motion;
  friend struct MotionHalves;
  struct Straight {};  // straight interpolation of position and heading: exact

  MotionInterval() = default;
  static MotionInterval straight(const Pose& begin, const Pose& end, int direction);
  static MotionInterval of(const Clothoid& clothoid, int direction);
  static MotionInterval of(const BoundedSpan& span, int direction);
  void head_evenly(double from, double to);

  Pose begin_{};
  Pose end_{};
  int direction_ = 1;
  bool faces_along_ = true;  // else the heading goes evenly from the one end's to the other's
  int depth_ = 0;
  // Of the clothoid that this was halved from, m and rad: errors of its integrals and courses add up to shares of them.
  double whole_length_ = 0.0, whole_turning_ = 0.0;
  std::variant<Straight, Clothoid, const BoundedSpan*> curve_;  ///< an arc is a clothoid whose curvature stays
};

/// Halves of an interval, that join. They may refer to the spans beside them.
struct MotionHalves {
  explicit MotionHalves(const MotionInterval& whole);
  MotionHalves(const MotionHalves&) = delete;
  MotionHalves& operator=(const MotionHalves&) = delete;

  MotionInterval left, right;

 private:
  BoundedSpan left_span_, right_span_;
};

/// All intervals of a path, one per smooth curve, in its order. Memory is reused from path to path.
class Motion {
 public:
  Motion() = default;
  explicit Motion(const Path& path) { assign(path); }
  Motion(const Motion&) = delete;
  Motion& operator=(const Motion&) = delete;
  void assign(const Path& path);
  /// For paths of so many curves nothing is allocated.
  void reserve(std::size_t pieces, std::size_t curves);

  std::span<const MotionInterval> intervals() const { return intervals_; }
  /// Of the pieces from `first` to before `last`.
  std::span<const MotionInterval> intervals(std::size_t first, std::size_t last) const;
  std::span<const MotionInterval> of_piece(std::size_t piece) const { return intervals(piece, piece + 1); }

 private:
  void add(const Piece& piece);

  std::vector<MotionInterval> intervals_;
  std::vector<std::size_t> begins_;  // of each piece, and the end
  std::vector<BoundedSpan> spans_;
};

}  // namespace waywright
