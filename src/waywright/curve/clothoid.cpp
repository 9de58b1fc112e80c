#include "waywright/curve/clothoid.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/core/elementary.hpp"
#include "waywright/curve/arc.hpp"
#include "waywright/curve/gauss.hpp"
#include "waywright/curve/lanes/kernels.hpp"

namespace waywright {
namespace {

// rad that a panel may turn at its greatest curvature, for 6, 8 and 16 points. n points integrate a function over [−1, 1] with an error of
// 2^(2n+1) n!⁴ / ((2n+1) (2n)!³) times its derivative 2n; that of cos(Bx) is at most B^(2n), that of cos(cx²) at 0, where all of a panel's bend is in
// one change of curvature, about cⁿ (2n)!/n!. With B half of what is given here and c half of B both are under 2e-14.
constexpr double tiny_panel = 0.1;
constexpr double short_panel = 1.0;
constexpr double long_panel = 8.0;

/// ∫ of the unit tangent over [a, b], in panels.
template <std::size_t n>
Vec2 tangent_sum(const Clothoid& c, double a, double b, const GaussHalf<n>& rule) {
  const double half = 0.5 * (b - a);
  const double middle = 0.5 * (a + b);
  Vec2 sum{};
  for (std::size_t i = 0; i < n; ++i) {
    const double by = half * rule.node[i];
    sum = sum + rule.weight[i] * (unit(course_at(c, middle - by)) + unit(course_at(c, middle + by)));
  }
  return half * sum;
}

/// @pre the curve turns by no more than a long panel over [a, b]
Vec2 displacement(const Clothoid& c, double a, double b) {
  const double bend = std::max(std::abs(c.curvature + c.curvature_rate * a), std::abs(c.curvature + c.curvature_rate * b));
  if (bend * std::abs(b - a) <= tiny_panel) return tangent_sum(c, a, b, gauss_6);
  return bend * std::abs(b - a) <= short_panel ? tangent_sum(c, a, b, gauss_8) : tangent_sum(c, a, b, gauss_16);
}

/// Panels over `length` metres from the start; more than can be wanted where numbers are wild.
std::size_t panels_of(const Clothoid& c, double length) {
  const double bend = std::max(std::abs(c.curvature), std::abs(c.curvature + c.curvature_rate * length));
  const double panels = std::ceil(bend * std::abs(length) / long_panel);
  return panels >= 1.0 ? static_cast<std::size_t>(std::min(panels, 1e6)) : 1;
}

CurvePoint point_with(const Clothoid& c, double s, Vec2 position) {
  return {position, wrap(course_at(c, s)), c.curvature + c.curvature_rate * s, c.curvature_rate};
}

constexpr int by_series = 0;

/// Points that a quadrature needs over each step between two places, or that a series will do; nullopt: more than there are.
std::optional<int> points_over(const Clothoid& c, double begin, double end, double step) {
  // Of the series with B = 0.09 and c = 0.002 what is left out is under 2e-14, B⁸/9! most of it.
  constexpr double least_panel = 0.18, least_change = 8e-3;
  const double turning = std::max(std::abs(c.curvature + c.curvature_rate * begin), std::abs(c.curvature + c.curvature_rate * end)) * step;
  const double change = 0.5 * std::abs(c.curvature_rate) * step * step;
  if (turning <= least_panel && change <= least_change) return by_series;
  if (turning <= tiny_panel) return 6;
  if (turning <= short_panel) return 8;
  return turning <= long_panel ? std::optional{16} : std::nullopt;
}

}  // namespace

double end_curvature(const Clothoid& c) { return c.curvature + c.curvature_rate * c.length; }
double greatest_curvature(const Clothoid& c) { return std::max(std::abs(c.curvature), std::abs(end_curvature(c))); }
double course_at(const Clothoid& c, double s) { return c.start.heading + s * (c.curvature + 0.5 * c.curvature_rate * s); }

CurvePoint evaluate(const Clothoid& c, double s) {
  if (c.curvature_rate == 0.0) return evaluate(Arc{c.start, c.curvature, c.length}, s);
  const std::size_t panels = panels_of(c, s);
  const double width = s / static_cast<double>(panels);
  Vec2 position = c.start.position();
  for (std::size_t i = 0; i < panels; ++i) position = position + displacement(c, static_cast<double>(i) * width, static_cast<double>(i + 1) * width);
  return point_with(c, s, position);
}

ClothoidPanels::ClothoidPanels(const Clothoid& clothoid) : clothoid_{clothoid} {
  const std::size_t panels = panels_of(clothoid, clothoid.length);
  width_ = clothoid.length / static_cast<double>(panels);
  begins_.reserve(panels);
  Vec2 position = clothoid.start.position();
  for (std::size_t i = 0; i < panels; ++i) {
    begins_.push_back(position);
    position = position + displacement(clothoid, static_cast<double>(i) * width_, static_cast<double>(i + 1) * width_);
  }
}

CurvePoint ClothoidPanels::at(double s) const {
  const double panel = std::floor(s / width_);
  const std::size_t i = panel > 0.0 ? std::min(begins_.size() - 1, static_cast<std::size_t>(panel)) : 0;
  return point_with(clothoid_, s, begins_[i] + displacement(clothoid_, static_cast<double>(i) * width_, s));
}

void sample_clothoid(const Clothoid& c, double begin, double step, std::size_t n, std::vector<Pose>& poses) {
  static const clothoid_lanes::Kernels& kernels = clothoid_lanes::best();
  if (n == 0) return;
  clothoid_lanes::Steps steps;
  Vec2 position = c.start.position();
  if (const auto to_begin = points_over(c, 0.0, begin, begin); !to_begin) {
    position = evaluate(c, begin).position;
  } else if (begin != 0.0) {
    kernels.steps(c.start.heading, c.curvature, c.curvature_rate, 0.0, begin, *to_begin, steps);  // the first lane is what is wanted
    position = position + Vec2{steps.dx[0], steps.dy[0]};
  }
  poses.push_back(make_pose(position, wrap(course_at(c, begin))));
  const std::optional<int> points = points_over(c, begin, begin + static_cast<double>(n - 1) * step, step);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const std::size_t lane = i % clothoid_lanes::width;
    const double next = begin + static_cast<double>(i + 1) * step;
    if (!points) {
      position = evaluate(c, next).position;
    } else {
      if (lane == 0) kernels.steps(c.start.heading, c.curvature, c.curvature_rate, begin + static_cast<double>(i) * step, step, *points, steps);
      position = position + Vec2{steps.dx[lane], steps.dy[lane]};
    }
    poses.push_back(make_pose(position, wrap(course_at(c, next))));
  }
}

Clothoid reversed(const Clothoid& c) {
  const CurvePoint end = evaluate(c, c.length);
  return {make_pose(end.position, wrap(end.course + pi)), -end.curvature, c.curvature_rate, c.length};
}

Clothoid rest_from(const Clothoid& c, double s) {
  const CurvePoint from = evaluate(c, s);
  return {make_pose(from.position, from.course), from.curvature, c.curvature_rate, c.length - s};
}

}  // namespace waywright
