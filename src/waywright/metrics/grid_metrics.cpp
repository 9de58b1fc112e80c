#include "waywright/metrics/grid_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/core/elementary.hpp"

namespace waywright {

double way_length(std::span<const Vec2> points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
  return sum;
}

double way_turning(std::span<const Vec2> points) {
  double sum = 0.0;
  Vec2 before{};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 leg = points[i] - points[i - 1];
    const double length = std::sqrt(squared_norm(leg));
    if (length == 0.0) continue;
    const double known = std::sqrt(squared_norm(before));
    // The arc cosine of nearly 1 would make much of rounding.
    if (known > 0.0) sum += std::abs(arc_tangent(cross(before, leg), dot(before, leg)));
    before = leg;
  }
  return sum;
}

double risk_of(double d, const CellRisk& rule) {
  if (d > rule.reach) return 0.0;
  double power = 1.0;
  for (int i = 0; i < rule.exponent; ++i) power *= d / rule.scale;
  return exponential(-0.5 * power);
}

double way_risk(std::span<const Vec2> points, std::span<const unsigned char> blocked, int columns, int rows, double cell, const CellRisk& rule) {
  double sum = 0.0;
  const auto first = [&](double at) { return static_cast<int>(std::max(0.0, std::ceil((at - rule.reach) / cell))); };
  const auto last = [&](double at, int count) { return static_cast<int>(std::min(count - 1.0, std::floor((at + rule.reach) / cell))); };
  for (const Vec2 p : points) {
    for (int row = first(p.y); row <= last(p.y, rows); ++row) {
      for (int column = first(p.x); column <= last(p.x, columns); ++column) {
        if (blocked[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)] == 0) continue;
        sum += risk_of(distance(p, {column * cell, row * cell}), rule);
      }
    }
  }
  return sum;
}

double way_time(double length, double speed) { return length / speed; }

double residual_power(double length, double turning, double speed_changes) { return 100.0 - 100.0 * (length / 1000.0 + speed_changes / 500.0 + turning / (200.0 * pi)); }

double reduction(double reference, double proposed) {
  if (reference == 0.0) return proposed == 0.0 ? 0.0 : -std::numeric_limits<double>::infinity();
  return 100.0 * (reference - proposed) / reference;
}

double power_reduction(double reference_left, double proposed_left) { return reduction(100.0 - reference_left, 100.0 - proposed_left); }

std::vector<Vec2> with_points_between(std::span<const Vec2> points, double step) {
  std::vector<Vec2> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) {
      const int parts = static_cast<int>(std::ceil(distance(points[i - 1], points[i]) / step - 1e-9));
      for (int k = 1; k < parts; ++k) all.push_back(points[i - 1] + (static_cast<double>(k) / parts) * (points[i] - points[i - 1]));
    }
    all.push_back(points[i]);
  }
  return all;
}

}  // namespace waywright
