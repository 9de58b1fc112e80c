// Rigorous bounds of curvature and its rate on a Bézier span, from polynomials in Bernstein form with bounds
// of their rounding.
#pragma once

#include <utility>

#include "waywright/curve/bernstein.hpp"
#include "waywright/curve/curve.hpp"

namespace waywright {

/// A polynomial whose exact coefficients are within `error` of those held.
struct BoundedPolynomial {
  Bernstein p;
  double error = 0.0;

  double low() const { return p.low() - error; }
  double high() const { return p.high() + error; }
  double greatest() const;  ///< of |p|
  /// On the halves of the range, times `scale` (a power of two).
  void halve(double scale, BoundedPolynomial& left, BoundedPolynomial& right) const;
};

/// Of a span and of the halves it is cut into. Where the speed may vanish, no bound on curvature exists: at a
/// double root of the squared speed rounding alone could make a positive bound of it, which is why errors are
/// carried along.
struct CurvatureBounds {
  BoundedPolynomial turn;    // N = x′y″ − y′x″
  BoundedPolynomial speed2;  // D = x′² + y′²

  CurvatureBounds() = default;
  explicit CurvatureBounds(const BezierSpan& span);
  void halve(CurvatureBounds& left, CurvatureBounds& right) const;

  double greatest() const;  ///< of |κ|, 1/m; +∞ where the speed may vanish
  double at_begin() const;  ///< |κ| up to rounding; 0 where the speed vanishes
};

/// The same for dκ/ds.
struct CurvatureRateBounds {
  BoundedPolynomial rate;    // M = N′D − 3/2·N·D′, so that dκ/ds = M/D³
  BoundedPolynomial speed2;  // D

  CurvatureRateBounds() = default;
  explicit CurvatureRateBounds(const CurvatureBounds& curvature);
  void halve(CurvatureRateBounds& left, CurvatureRateBounds& right) const;

  double greatest() const;  ///< of |dκ/ds|, 1/m²; +∞ where the speed may vanish
  double at_begin() const;  ///< |dκ/ds| up to rounding; 0 where the speed vanishes
};

/// Upper bounds of |κ| and |dκ/ds| over a span, +∞ at a cusp.
struct CurvaturePeaks {
  double curvature = 0.0;  ///< 1/m
  double rate = 0.0;       ///< 1/m²
};
/// At most a twentieth (or 0.01) over the truth.
CurvaturePeaks curvature_peaks(const BezierSpan& span);
/// Up to twenty times over the truth and 5 more, but cheap.
CurvaturePeaks coarse_curvature_peaks(const BezierSpan& span);

}  // namespace waywright
