#include "waywright/dxf/spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace waywright::dxf {
namespace {

constexpr int highest_degree = 15;
constexpr int deepest = 24;                       // halvings of one Bézier part
constexpr std::size_t most_knots = 4'000'000;     // of one spline

/// x·w, y·w, w: halving is linear in these.
struct Weighted {
  double x, y, w;
};
Weighted mix(const Weighted& a, const Weighted& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.w + t * (b.w - a.w)};
}
Vec2 point(const Weighted& c) { return {c.x / c.w, c.y / c.w}; }
using Part = std::vector<Weighted>;

/// The spline's polar form on the knot interval `span` at the arguments given: a Bézier point where these are its two ends.
Weighted polar(const SplineCurve& curve, const std::vector<Weighted>& controls, std::size_t span, const std::vector<double>& at) {
  const auto p = static_cast<std::size_t>(curve.degree);
  std::array<Weighted, highest_degree + 1> d;
  for (std::size_t j = 0; j <= p; ++j) d[j] = controls[span - p + j];
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t j = p; j >= r; --j) {
      const double low = curve.knots[span - p + j], high = curve.knots[span + 1 + j - r];
      d[j] = mix(d[j - 1], d[j], (at[r - 1] - low) / (high - low));
      if (j == r) break;
    }
  }
  return d[p];
}

double distance_to_chord(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double length = squared_norm(d);
  const double t = length > 0.0 ? std::clamp(dot(p - a, d) / length, 0.0, 1.0) : 0.0;
  return distance(p, a + t * d);
}

bool is_flat(const Part& part, double tolerance) {
  const Vec2 a = point(part.front()), b = point(part.back());
  double along = 0.0;
  for (const Weighted& c : part) {
    if (!(distance_to_chord(point(c), a, b) <= tolerance)) return false;
    const double at = dot(point(c) - a, b - a);
    if (at < along) return false;
    along = at;
  }
  return true;
}

void add_chords(Part part, double tolerance, int depth, Chain& knots) {
  if (knots.size() > most_knots) return;
  if (depth >= deepest || is_flat(part, tolerance)) {
    for (std::size_t i = 1; i + 1 < part.size(); ++i) knots.push_back({point(part[i]), within_hull});
    knots.push_back({point(part.back())});
    return;
  }
  Part left{part.front()};
  for (std::size_t n = part.size() - 1; n > 0; --n) {
    for (std::size_t i = 0; i < n; ++i) part[i] = mix(part[i], part[i + 1], 0.5);
    left.push_back(part.front());
  }
  add_chords(std::move(left), tolerance, depth + 1, knots);
  add_chords(std::move(part), tolerance, depth + 1, knots);
}

}  // namespace

std::variant<Chain, std::string> pieces(const SplineCurve& curve, double tolerance) {
  if (curve.degree < 1 || curve.degree > highest_degree) return fmt::format("the spline has degree {}", curve.degree);
  const auto p = static_cast<std::size_t>(curve.degree);
  const std::size_t n = curve.controls.size();
  if (n < p + 1) return fmt::format("the spline of degree {} has {} control points", curve.degree, n);
  if (curve.knots.size() != n + p + 1) return fmt::format("the spline has {} knots for {} control points", curve.knots.size(), n);
  if (!std::is_sorted(curve.knots.begin(), curve.knots.end())) return std::string{"the spline's knots do not rise"};
  if (!curve.weights.empty() && curve.weights.size() != n) return fmt::format("the spline has {} weights for {} control points", curve.weights.size(), n);
  if (std::any_of(curve.weights.begin(), curve.weights.end(), [](double w) { return !(w > 1e-9 && w < 1e9); })) {
    return std::string{"a weight of the spline is not positive"};
  }
  std::vector<Weighted> controls;
  for (std::size_t i = 0; i < n; ++i) {
    const double w = curve.weights.empty() ? 1.0 : curve.weights[i];
    controls.push_back({w * curve.controls[i].x, w * curve.controls[i].y, w});
  }
  Chain knots;
  for (std::size_t span = p; span < n; ++span) {
    const double from = curve.knots[span], to = curve.knots[span + 1];
    if (!(to > from)) continue;
    Part part;
    std::vector<double> at(p, from);
    for (std::size_t j = 0; j <= p; ++j) {
      part.push_back(polar(curve, controls, span, at));
      if (j < p) at[p - 1 - j] = to;
    }
    // At the start, and where knots that coincide let the curve jump.
    if (knots.empty() || distance(knots.back().at, point(part.front())) > 1e-3 * tolerance) knots.push_back({point(part.front())});
    add_chords(std::move(part), tolerance, 0, knots);
  }
  if (knots.size() < 2) return std::string{"the spline's knots span nothing"};
  if (knots.size() > most_knots) return std::string{"the spline needs more than four million points"};
  return knots;
}

std::variant<std::vector<Vec2>, std::string> chords(const SplineCurve& curve, double tolerance) {
  auto found = pieces(curve, tolerance);
  if (auto* problem = std::get_if<std::string>(&found)) return std::move(*problem);
  std::vector<Vec2> corners;
  for (const Knot& knot : std::get<Chain>(found)) {
    if (knot.weight == 0.0) corners.push_back(knot.at);
  }
  return corners;
}

}  // namespace waywright::dxf
