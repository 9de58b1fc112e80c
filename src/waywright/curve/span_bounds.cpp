#include "waywright/curve/span_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace waywright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double unit_roundoff = 0x1p-53;
constexpr double rounding = 1e-12;  // of quotients and roots
constexpr int deepest = 40;         // halvings: only a cusp gets there
constexpr double share = 0.05;      // by which a peak's bound may be over it
constexpr double least = 0.01;      // 1/m and 1/m²: smaller differences do not matter to anyone

Bernstein coordinate(const BezierSpan& span, double Vec2::*axis) {
  Bernstein b;
  b.degree = static_cast<std::size_t>(span.degree);
  for (std::size_t i = 0; i <= b.degree; ++i) b.c[i] = span.control[i].*axis;
  return b;
}

double greatest(const Bernstein& b) { return std::max(std::abs(b.low()), std::abs(b.high())); }

/// Greatest of a quantity by branch and bound; `at` is its value at the beginning of a part.
template <class Bound, class At>
double peak(const SpanBounds& whole, Bound bound, At at) {
  struct Part {
    SpanBounds bounds;
    int depth;
  };
  std::vector<Part> stack{{whole, 0}};
  double found = 0.0;
  double top = 0.0;
  while (!stack.empty()) {
    const Part part = stack.back();
    stack.pop_back();
    const double b = bound(part.bounds);
    found = std::max(found, at(part.bounds));
    if (b <= std::max(top, found * (1.0 + share) + least)) {
      top = std::max(top, b);
      continue;
    }
    if (part.depth >= deepest) return infinity;
    auto [left, right] = part.bounds.halves();
    stack.push_back({std::move(right), part.depth + 1});
    stack.push_back({std::move(left), part.depth + 1});
  }
  return top;
}

}  // namespace

double BoundedPolynomial::greatest() const { return std::max(std::abs(low()), std::abs(high())); }

std::pair<BoundedPolynomial, BoundedPolynomial> BoundedPolynomial::halves(double scale) const {
  auto [left, right] = halve(p);
  for (double& c : left.c) c *= scale;
  for (double& c : right.c) c *= scale;
  // Each of at most 16 levels of averaging rounds once.
  const double grown = (error + 16.0 * unit_roundoff * waywright::greatest(p)) * scale;
  return {{left, grown}, {right, grown}};
}

SpanBounds::SpanBounds(const BezierSpan& span) {
  const Bernstein dx = derivative(coordinate(span, &Vec2::x));
  const Bernstein dy = derivative(coordinate(span, &Vec2::y));
  turn.p = combine(1.0, dx * derivative(dy), -1.0, dy * derivative(dx));
  speed2.p = combine(1.0, dx * dx, 1.0, dy * dy);
  rate.p = combine(1.0, derivative(turn.p) * speed2.p, -1.5, turn.p * derivative(speed2.p));
  // The differences dx, dy are right to 2 units in the last place. A product adds at most 32 units of the
  // greatest product of coefficients (its weights sum to 1); second derivatives are at most 8 times the
  // first, with 24 units of theirs as error.
  const double g = std::max(greatest(dx), greatest(dy));
  const double n = greatest(turn.p);
  const double d = greatest(speed2.p);
  turn.error = 1024.0 * unit_roundoff * g * g;
  speed2.error = 128.0 * unit_roundoff * g * g;
  rate.error = 64.0 * (turn.error * d + n * speed2.error + 32.0 * unit_roundoff * n * d);
}

std::pair<SpanBounds, SpanBounds> SpanBounds::halves() const {
  // On half the parameter range: N scales with u′³ (1/8), D with 1/4, M with (1/8·1/2)(1/4) = 1/64.
  SpanBounds left, right;
  std::tie(left.turn, right.turn) = turn.halves(0.125);
  std::tie(left.speed2, right.speed2) = speed2.halves(0.25);
  std::tie(left.rate, right.rate) = rate.halves(1.0 / 64.0);
  return {left, right};
}

double SpanBounds::curvature() const {
  const double d = speed2.low();
  if (!(d > 0.0)) return infinity;
  return turn.greatest() / (d * std::sqrt(d)) * (1.0 + rounding);
}

double SpanBounds::curvature_rate() const {
  const double d = speed2.low();
  if (!(d > 0.0)) return infinity;
  return rate.greatest() / (d * d * d) * (1.0 + rounding);
}

CurvaturePeaks curvature_peaks(const BezierSpan& span) {
  if (span.degree < 2) return {};
  const SpanBounds whole{span};
  CurvaturePeaks peaks;
  peaks.curvature = peak(
      whole, [](const SpanBounds& b) { return b.curvature(); },
      [](const SpanBounds& b) {
        const double d = b.speed2.p.c[0];
        return d > 0.0 ? std::abs(b.turn.p.c[0]) / (d * std::sqrt(d)) : 0.0;
      });
  if (!std::isfinite(peaks.curvature)) return {infinity, infinity};
  peaks.rate = peak(
      whole, [](const SpanBounds& b) { return b.curvature_rate(); },
      [](const SpanBounds& b) {
        const double d = b.speed2.p.c[0];
        return d > 0.0 ? std::abs(b.rate.p.c[0]) / (d * d * d) : 0.0;
      });
  return peaks;
}

}  // namespace waywright
