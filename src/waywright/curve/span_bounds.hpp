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
  std::pair<BoundedPolynomial, BoundedPolynomial> halves(double scale) const;
};

/// Of a span and of the halves it is cut into. Where the speed may vanish, no bound on curvature exists: at a
/// double root of the squared speed rounding alone could make a positive bound of it, which is why errors are
/// carried along.
struct SpanBounds {
  BoundedPolynomial turn;    // N = x′y″ − y′x″
  BoundedPolynomial speed2;  // D = x′² + y′²
  BoundedPolynomial rate;    // M = N′D − 3/2·N·D′, so that dκ/ds = M/D³

  explicit SpanBounds(const BezierSpan& span);
  std::pair<SpanBounds, SpanBounds> halves() const;

  double curvature() const;       ///< greatest |κ|, 1/m; +∞ where the speed may vanish
  double curvature_rate() const;  ///< greatest |dκ/ds|, 1/m²; +∞ where the speed may vanish

 private:
  SpanBounds() = default;
};

/// Upper bounds of |κ| and |dκ/ds| over a span, at most a twentieth (or 0.01) over the truth; +∞ at a cusp.
struct CurvaturePeaks {
  double curvature = 0.0;  ///< 1/m
  double rate = 0.0;       ///< 1/m²
};
CurvaturePeaks curvature_peaks(const BezierSpan& span);

}  // namespace waywright
