#include "waywright/curve/span_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit_roundoff = 0x1p-53;
constexpr double rounding = 1e-12;  // of quotients and roots
constexpr int deepest = 40;         // halvings: only a cusp gets there

/// By how much a peak's bound may be over it: a share of it, or so many 1/m or 1/m².
struct Sharpness {
  double share, least;
};
constexpr Sharpness fine{0.05, 0.01};
constexpr Sharpness coarse{20.0, 5.0};

Bernstein coordinate(const BezierSpan& span, double Vec2::*axis) {
  Bernstein b;
  b.degree = static_cast<std::size_t>(span.degree);
  for (std::size_t i = 0; i <= b.degree; ++i) b.c[i] = span.control[i].*axis;
  return b;
}

double greatest(const Bernstein& b) { return std::max(std::abs(b.low()), std::abs(b.high())); }

/// Greatest of a quantity by branch and bound.
template <class Bounds>
class Peak {
 public:
  explicit Peak(const Sharpness& sharpness) : sharpness_{sharpness} {}
  /// +∞ where there is none.
  double of(const Bounds& whole) { return covers(whole, 0) ? top_ : infinity; }

 private:
  bool covers(const Bounds& part, int depth) {
    const double bound = part.greatest();
    found_ = std::max(found_, part.at_begin());
    if (bound <= std::max(top_, found_ * (1.0 + sharpness_.share) + sharpness_.least)) {
      top_ = std::max(top_, bound);
      return true;
    }
    if (depth >= deepest) return false;
    Bounds left, right;
    part.halve(left, right);
    return covers(left, depth + 1) && covers(right, depth + 1);
  }

  Sharpness sharpness_;
  double found_ = 0.0;
  double top_ = 0.0;
};

CurvaturePeaks peaks_of(const BezierSpan& span, const Sharpness& sharpness) {
  if (span.degree < 2) return {};
  const CurvatureBounds whole{span};
  const double curvature = Peak<CurvatureBounds>{sharpness}.of(whole);
  if (!std::isfinite(curvature)) return {infinity, infinity};
  return {curvature, Peak<CurvatureRateBounds>{sharpness}.of(CurvatureRateBounds{whole})};
}

}  // namespace

double BoundedPolynomial::greatest() const { return std::max(std::abs(low()), std::abs(high())); }

void BoundedPolynomial::halve(double scale, BoundedPolynomial& left, BoundedPolynomial& right) const {
  waywright::halve(p, left.p, right.p);
  for (std::size_t i = 0; i <= p.degree; ++i) {
    left.p.c[i] *= scale;
    right.p.c[i] *= scale;
  }
  // Each of at most 16 levels of averaging rounds once.
  left.error = right.error = (error + 16.0 * unit_roundoff * waywright::greatest(p)) * scale;
}

CurvatureBounds::CurvatureBounds(const BezierSpan& span) {
  const Bernstein dx = derivative(coordinate(span, &Vec2::x));
  const Bernstein dy = derivative(coordinate(span, &Vec2::y));
  turn.p = combine(1.0, dx * derivative(dy), -1.0, dy * derivative(dx));
  speed2.p = combine(1.0, dx * dx, 1.0, dy * dy);
  // The differences dx, dy are right to 2 units in the last place. A product adds at most 32 units of the
  // greatest product of coefficients (its weights sum to 1); second derivatives are at most 8 times the
  // first, with 24 units of theirs as error.
  const double g = std::max(waywright::greatest(dx), waywright::greatest(dy));
  turn.error = 1024.0 * unit_roundoff * g * g;
  speed2.error = 128.0 * unit_roundoff * g * g;
}

// On half the parameter range: N scales with u′³ (1/8), D with 1/4, M with (1/8·1/2)(1/4) = 1/64.
void CurvatureBounds::halve(CurvatureBounds& left, CurvatureBounds& right) const {
  turn.halve(0.125, left.turn, right.turn);
  speed2.halve(0.25, left.speed2, right.speed2);
}

double CurvatureBounds::greatest() const {
  const double d = speed2.low();
  if (!(d > 0.0)) return infinity;
  return turn.greatest() / (d * std::sqrt(d)) * (1.0 + rounding);
}

double CurvatureBounds::at_begin() const {
  const double d = speed2.p.c[0];
  return d > 0.0 ? std::abs(turn.p.c[0]) / (d * std::sqrt(d)) : 0.0;
}

CurvatureRateBounds::CurvatureRateBounds(const CurvatureBounds& curvature) : speed2{curvature.speed2} {
  const BoundedPolynomial& turn = curvature.turn;
  rate.p = combine(1.0, derivative(turn.p) * speed2.p, -1.5, turn.p * derivative(speed2.p));
  const double n = waywright::greatest(turn.p);
  const double d = waywright::greatest(speed2.p);
  rate.error = 64.0 * (turn.error * d + n * speed2.error + 32.0 * unit_roundoff * n * d);
}

void CurvatureRateBounds::halve(CurvatureRateBounds& left, CurvatureRateBounds& right) const {
  rate.halve(1.0 / 64.0, left.rate, right.rate);
  speed2.halve(0.25, left.speed2, right.speed2);
}

double CurvatureRateBounds::greatest() const {
  const double d = speed2.low();
  if (!(d > 0.0)) return infinity;
  return rate.greatest() / (d * d * d) * (1.0 + rounding);
}

double CurvatureRateBounds::at_begin() const {
  const double d = speed2.p.c[0];
  return d > 0.0 ? std::abs(rate.p.c[0]) / (d * d * d) : 0.0;
}

CurvaturePeaks curvature_peaks(const BezierSpan& span) { return peaks_of(span, fine); }
CurvaturePeaks coarse_curvature_peaks(const BezierSpan& span) { return peaks_of(span, coarse); }

}  // namespace waywright
