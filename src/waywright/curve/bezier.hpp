// Bézier spans: evaluation, halving, arc length. Laws: halves join and together are the curve; a reversed span is the
// same point set; hull and tangent cone as in curve.hpp.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "waywright/curve/curve.hpp"

namespace waywright {

/// Position and derivatives with respect to u.
struct Derivatives {
  Vec2 p{}, d1{}, d2{}, d3{};
};
Derivatives derivatives(const BezierSpan& span, double u);

/// The same for many places of one span.
class SpanDerivatives {
 public:
  explicit SpanDerivatives(const BezierSpan& span);
  Derivatives at(double u) const;

 private:
  int degree_;
  std::array<Vec2, 6> points_, velocities_;
};

/// Course, curvature and curvature rate from derivatives; where the speed vanishes, all three are 0.
CurvePoint curve_point(const Derivatives& d);
CurvePoint evaluate(const BezierSpan& span, double u);

/// The two halves at u = ½ (de Casteljau).
std::pair<BezierSpan, BezierSpan> halve(const BezierSpan& span);
/// What follows u in [0, 1) (de Casteljau).
BezierSpan rest_from(const BezierSpan& span, double u);

/// Arc length over [u0, u1] by 16-point Gauss–Legendre on `parts` equal parts.
double arc_length(const BezierSpan& span, double u0 = 0.0, double u1 = 1.0, int parts = 4);

/// Length of the control polygon: at least the arc length.
double control_length(const BezierSpan& span);

/// Arc length to parameter for one span: built once, asked many times.
class ArcLengthTable {
 public:
  explicit ArcLengthTable(const BezierSpan& span);
  double length() const { return cumulative_.back(); }
  /// u with arc length s from the beginning; s is clamped to [0, length]. Error under 1e-12 of the length for regular spans.
  double parameter(double s) const;

 private:
  static constexpr std::size_t parts = 32;
  std::array<Vec2, 5> derivative_;              ///< coefficients of 1, u, u², …
  bool is_straight_;
  std::array<double, parts + 1> cumulative_{};  ///< at u = i / parts; of a straight span only the last counts
  struct Slope {
    double first, second;  ///< du/ds, d²u/ds²
  };
  std::array<Slope, parts + 1> slopes_{};       ///< at the same places, of curved spans; infinite where the speed is 0
};

/// Cubic Hermite data to a Bézier span of degree 3: end points and derivatives with respect to u.
BezierSpan cubic_hermite(Vec2 p0, Vec2 d0, Vec2 p1, Vec2 d1);

/// Quintic with given end points and end tangents whose second derivatives vanish at both ends, so that curvature is 0 there.
/// Tangents are derivatives with respect to u.
BezierSpan straight_ended_quintic(Vec2 p0, Vec2 d0, Vec2 p1, Vec2 d1);

/// The same with the given curvature (1/m, in the direction of travel) where it begins.
BezierSpan straight_ending_quintic(Vec2 p0, Vec2 d0, double start_curvature, Vec2 p1, Vec2 d1);

/// A straight span of degree 1.
BezierSpan straight_span(Vec2 from, Vec2 to);

/// C² interpolating cubic through the points with chord-length parameter and natural ends (second derivative 0), as Bézier
/// spans. @pre at least 2 points, neighbours distinct. Source: docking publication, Algorithm 2, corrected.
Spans natural_cubic(std::span<const Vec2> points);

/// The same with clamped ends: unit tangents of the given courses at both ends.
Spans clamped_cubic(std::span<const Vec2> points, double start_course, double end_course);

}  // namespace waywright
