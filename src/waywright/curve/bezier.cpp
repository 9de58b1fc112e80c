#include "waywright/curve/bezier.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/curve/gauss.hpp"

namespace waywright {
namespace {

/// De Casteljau's algorithm level by level, without loops.
template <std::size_t... i>
Vec2 de_casteljau(const Vec2* points, double u, std::index_sequence<i...>) {
  if constexpr (sizeof...(i) == 0) {
    return points[0];
  } else {
    const std::array<Vec2, sizeof...(i)> next{(points[i] + u * (points[i + 1] - points[i]))...};
    return de_casteljau(next.data(), u, std::make_index_sequence<sizeof...(i) - 1>{});
  }
}

/// A velocity of degree m and its first two derivatives: de Casteljau's last levels hold their differences.
template <std::size_t m, std::size_t... i>
void velocity(const Vec2* points, double u, Derivatives& d, std::index_sequence<i...>) {
  constexpr std::size_t degree = sizeof...(i);
  if constexpr (degree == 2) d.d3 = static_cast<double>(m * (m - 1)) * ((points[2] - points[1]) - (points[1] - points[0]));
  if constexpr (degree == 1) d.d2 = static_cast<double>(m) * (points[1] - points[0]);
  if constexpr (degree == 0) {
    d.d1 = points[0];
  } else {
    const std::array<Vec2, degree> next{(points[i] + u * (points[i + 1] - points[i]))...};
    velocity<m>(next.data(), u, d, std::make_index_sequence<degree - 1>{});
  }
}
template <std::size_t m>
void velocity(const std::array<Vec2, 6>& points, double u, Derivatives& d) {
  velocity<m>(points.data(), u, d, std::make_index_sequence<m>{});
}

Vec2 de_casteljau(const std::array<Vec2, 6>& points, int degree, double u) {
  switch (degree) {
    case 1: return de_casteljau(points.data(), u, std::make_index_sequence<1>{});
    case 2: return de_casteljau(points.data(), u, std::make_index_sequence<2>{});
    case 3: return de_casteljau(points.data(), u, std::make_index_sequence<3>{});
    case 4: return de_casteljau(points.data(), u, std::make_index_sequence<4>{});
    case 5: return de_casteljau(points.data(), u, std::make_index_sequence<5>{});
    default: return points[0];
  }
}

/// Control points of the derivative, degree one less.
std::array<Vec2, 6> hodograph(const std::array<Vec2, 6>& points, int degree) {
  std::array<Vec2, 6> d{};
  for (int i = 0; i < degree; ++i) {
    const auto k = static_cast<std::size_t>(i);
    d[k] = static_cast<double>(degree) * (points[k + 1] - points[k]);
  }
  return d;
}

/// A derivative's coefficients of 1, u, u², …
using Derivative = std::array<Vec2, 5>;
Derivative derivative_of(const BezierSpan& span) {
  constexpr std::array<std::array<double, 5>, 5> binomial{{{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}}};
  std::array<Vec2, 6> d = hodograph(span.control, span.degree);
  const auto degree = static_cast<std::size_t>(span.degree - 1);
  Derivative power{};
  for (std::size_t k = 0; k <= degree; ++k) {
    power[k] = binomial[degree][k] * d[0];
    for (std::size_t i = 0; i + k < degree; ++i) d[i] = d[i + 1] - d[i];  // the next differences
  }
  return power;
}

[[gnu::always_inline]] inline Vec2 velocity_at(const Derivative& d, double u) {
  return d[0] + u * (d[1] + u * (d[2] + u * (d[3] + u * d[4])));
}
[[gnu::always_inline]] inline double speed_at(const Derivative& d, double u) { return norm(velocity_at(d, u)); }

template <std::size_t n>
double gauss(const GaussHalf<n>& rule, const Derivative& derivative, double a, double b) {
  const double half = 0.5 * (b - a);
  const double middle = 0.5 * (a + b);
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    sum += rule.weight[i] * (speed_at(derivative, middle - half * rule.node[i]) + speed_at(derivative, middle + half * rule.node[i]));
  }
  return half * sum;
}
/// Length of the span with this derivative over [a, b].
double gauss(const Derivative& derivative, double a, double b) { return gauss(gauss_16, derivative, a, b); }
/// The same for a stretch of a 32nd of a regular span or less.
double short_gauss(const Derivative& derivative, double a, double b) { return gauss(gauss_8, derivative, a, b); }

/// Solves the tridiagonal system with diagonal 2(h[i−1]+h[i]) for the second derivatives inside (Thomas).
std::vector<Vec2> natural_second_derivatives(std::span<const Vec2> points, const std::vector<double>& h) {
  const std::size_t n = points.size();
  std::vector<Vec2> m(n);
  if (n < 3) return m;
  std::vector<double> diagonal(n);
  std::vector<Vec2> right(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    diagonal[i] = 2.0 * (h[i - 1] + h[i]);
    right[i] = 6.0 * ((1.0 / h[i]) * (points[i + 1] - points[i]) - (1.0 / h[i - 1]) * (points[i] - points[i - 1]));
    if (i > 1) {
      const double factor = h[i - 1] / diagonal[i - 1];
      diagonal[i] -= factor * h[i - 1];
      right[i] = right[i] - factor * right[i - 1];
    }
  }
  for (std::size_t i = n - 2; i >= 1; --i) m[i] = (1.0 / diagonal[i]) * (right[i] - h[i] * m[i + 1]);
  return m;
}

std::vector<double> chords(std::span<const Vec2> points) {
  std::vector<double> h;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) h.push_back(distance(points[i], points[i + 1]));
  return h;
}

}  // namespace

SpanDerivatives::SpanDerivatives(const BezierSpan& span) : degree_{span.degree}, points_{span.control}, velocities_{hodograph(points_, degree_)} {}

Derivatives SpanDerivatives::at(double u) const {
  Derivatives d;
  d.p = de_casteljau(points_, degree_, u);
  switch (degree_) {
    case 1: velocity<0>(velocities_, u, d); break;
    case 2: velocity<1>(velocities_, u, d); break;
    case 3: velocity<2>(velocities_, u, d); break;
    case 4: velocity<3>(velocities_, u, d); break;
    case 5: velocity<4>(velocities_, u, d); break;
    default: break;
  }
  return d;
}

Derivatives derivatives(const BezierSpan& span, double u) { return SpanDerivatives{span}.at(u); }

CurvePoint curve_point(const Derivatives& d) {
  CurvePoint point;
  point.position = d.p;
  const double speed2 = squared_norm(d.d1);
  if (!(speed2 > 0.0)) return point;
  const double speed = std::sqrt(speed2);
  point.course = angle_of(d.d1);
  const double n = cross(d.d1, d.d2);
  point.curvature = n / (speed2 * speed);
  // dκ/ds = (n′ s − 3 n (d1·d2)) / s³ with s = |d1|², n = d1 × d2, n′ = d1 × d3.
  point.curvature_rate = (cross(d.d1, d.d3) * speed2 - 3.0 * n * dot(d.d1, d.d2)) / (speed2 * speed2 * speed2);
  return point;
}

CurvePoint evaluate(const BezierSpan& span, double u) { return curve_point(derivatives(span, u)); }

BezierSpan rest_from(const BezierSpan& span, double u) {
  BezierSpan rest = span;
  const auto n = static_cast<std::size_t>(span.degree);
  for (std::size_t level = n; level > 0; --level) {
    for (std::size_t i = 0; i < level; ++i) rest.control[i] = (1.0 - u) * rest.control[i] + u * rest.control[i + 1];
  }
  return rest;
}

std::pair<BezierSpan, BezierSpan> halve(const BezierSpan& span) {
  BezierSpan left{span.degree, {}};
  BezierSpan right{span.degree, {}};
  auto points = span.control;
  const auto n = static_cast<std::size_t>(span.degree);
  left.control[0] = points[0];
  right.control[n] = points[n];
  for (std::size_t level = 1; level <= n; ++level) {
    for (std::size_t i = 0; i + level <= n; ++i) points[i] = 0.5 * (points[i] + points[i + 1]);
    left.control[level] = points[0];
    right.control[n - level] = points[n - level];
  }
  return {left, right};
}

double arc_length(const BezierSpan& span, double u0, double u1, int parts) {
  if (span.degree == 1) return (u1 - u0) * distance(span.control[0], span.control[1]);
  const Derivative derivative = derivative_of(span);
  double sum = 0.0;
  for (int i = 0; i < parts; ++i) {
    const double a = u0 + (u1 - u0) * i / parts;
    const double b = u0 + (u1 - u0) * (i + 1) / parts;
    sum += gauss(derivative, a, b);
  }
  return sum;
}

double control_length(const BezierSpan& span) {
  double sum = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(span.degree); ++i) sum += distance(span.control[i], span.control[i + 1]);
  return sum;
}

ArcLengthTable::ArcLengthTable(const BezierSpan& span) : derivative_{derivative_of(span)}, is_straight_{span.degree == 1} {
  if (is_straight_) {
    cumulative_.back() = distance(span.control[0], span.control[1]);
    return;
  }
  for (std::size_t i = 0; i <= parts; ++i) {
    const double u = static_cast<double>(i) / parts;
    if (i > 0) cumulative_[i] = cumulative_[i - 1] + gauss(derivative_, static_cast<double>(i - 1) / parts, u);
    const Vec2 velocity = velocity_at(derivative_, u);
    const Vec2 acceleration = derivative_[1] + u * (2.0 * derivative_[2] + u * (3.0 * derivative_[3] + (4.0 * u) * derivative_[4]));
    const double speed = norm(velocity);
    slopes_[i] = {1.0 / speed, -dot(velocity, acceleration) / (speed * speed * speed * speed)};
  }
}

double ArcLengthTable::parameter(double s) const {
  const double total = length();
  if (!(s > 0.0) || !(total > 0.0)) return 0.0;
  if (s >= total) return 1.0;
  if (is_straight_) return s / total;
  const auto upper = std::upper_bound(cumulative_.begin(), cumulative_.end(), s);
  const auto part = static_cast<std::size_t>(upper - cumulative_.begin()) - 1;
  const double low = static_cast<double>(part) / parts;
  const double high = static_cast<double>(part + 1) / parts;
  const double rest = s - cumulative_[part];
  const double whole = cumulative_[part + 1] - cumulative_[part];
  double a = low;
  double b = high;
  // u over s as a quintic with the slopes and second derivatives of both ends of the part.
  const double t = rest / whole;
  const auto [slope0, bend0] = slopes_[part];
  const auto [slope1, bend1] = slopes_[part + 1];
  const double p1 = whole * slope0, p2 = 0.5 * whole * whole * bend0;
  const double q0 = (high - low) - p1 - p2, q1 = whole * slope1 - p1 - 2.0 * p2, q2 = 0.5 * whole * whole * bend1 - p2;
  double u = low + t * (p1 + t * (p2 + t * (10.0 * q0 - 4.0 * q1 + q2 + t * (-15.0 * q0 + 7.0 * q1 - 2.0 * q2 + t * (6.0 * q0 - 3.0 * q1 + q2)))));
  if (!(u > low && u < high)) u = low + (high - low) * t;
  for (int i = 0; i < 30; ++i) {  // Newton, kept inside a shrinking bracket
    const double error = short_gauss(derivative_, low, u) - rest;
    if (std::abs(error) <= 1e-14 * total) break;
    (error > 0.0 ? b : a) = u;
    const double v = speed_at(derivative_, u);
    double next = v > 0.0 ? u - error / v : 0.5 * (a + b);
    if (!(next > a && next < b)) next = 0.5 * (a + b);
    const bool is_enough = std::abs(error) <= 1e-7 * whole && next == u - error / v;  // its error is squared by this step
    if (next == u) break;
    u = next;
    if (is_enough) break;
  }
  return u;
}

BezierSpan cubic_hermite(Vec2 p0, Vec2 d0, Vec2 p1, Vec2 d1) {
  return {3, {p0, p0 + (1.0 / 3.0) * d0, p1 - (1.0 / 3.0) * d1, p1}};
}

BezierSpan straight_ended_quintic(Vec2 p0, Vec2 d0, Vec2 p1, Vec2 d1) {
  return {5, {p0, p0 + 0.2 * d0, p0 + 0.4 * d0, p1 - 0.4 * d1, p1 - 0.2 * d1, p1}};
}

BezierSpan straight_ending_quintic(Vec2 p0, Vec2 d0, double start_curvature, Vec2 p1, Vec2 d1) {
  BezierSpan span = straight_ended_quintic(p0, d0, p1, d1);
  // p″ = κ |p′|² n at the start, and the second differences there are p″ / 20.
  span.control[2] = span.control[2] + (0.05 * start_curvature * norm(d0)) * left_of(d0);
  return span;
}

BezierSpan straight_span(Vec2 from, Vec2 to) { return {1, {from, to}}; }

Spans natural_cubic(std::span<const Vec2> points) {
  const std::vector<double> h = chords(points);
  const std::vector<Vec2> m = natural_second_derivatives(points, h);
  Spans spans;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 slope = (1.0 / h[i]) * (points[i + 1] - points[i]);
    const Vec2 d0 = slope - (h[i] / 6.0) * (2.0 * m[i] + m[i + 1]);
    const Vec2 d1 = slope + (h[i] / 6.0) * (m[i] + 2.0 * m[i + 1]);
    spans.push_back(cubic_hermite(points[i], h[i] * d0, points[i + 1], h[i] * d1));
  }
  return spans;
}

Spans clamped_cubic(std::span<const Vec2> points, double start_course, double end_course) {
  const std::vector<double> h = chords(points);
  const std::size_t n = points.size();
  // First derivatives v: h[i] v[i−1] + 2(h[i−1]+h[i]) v[i] + h[i−1] v[i+1] = 3 (h[i] s[i−1] + h[i−1] s[i]).
  std::vector<Vec2> v(n), right(n);
  std::vector<double> diagonal(n, 1.0), upper(n, 0.0);
  v.front() = unit(start_course);
  v.back() = unit(end_course);
  right.front() = v.front();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const Vec2 before = (1.0 / h[i - 1]) * (points[i] - points[i - 1]);
    const Vec2 after = (1.0 / h[i]) * (points[i + 1] - points[i]);
    const double lower = h[i];
    const double factor = lower / diagonal[i - 1];
    diagonal[i] = 2.0 * (h[i - 1] + h[i]) - factor * upper[i - 1];
    upper[i] = h[i - 1];
    right[i] = 3.0 * (h[i] * before + h[i - 1] * after) - factor * right[i - 1];
  }
  for (std::size_t i = n - 1; i-- > 1;) v[i] = (1.0 / diagonal[i]) * (right[i] - upper[i] * v[i + 1]);
  Spans spans;
  for (std::size_t i = 0; i + 1 < n; ++i) spans.push_back(cubic_hermite(points[i], h[i] * v[i], points[i + 1], h[i] * v[i + 1]));
  return spans;
}

}  // namespace waywright
