#include "waywright/planner/spline/spline_fitness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/core/elementary.hpp"
#include "waywright/geometry/polygon.hpp"
#include "waywright/map/clearance_along.hpp"
#include "waywright/metrics/grid_metrics.hpp"

namespace waywright {
namespace {

constexpr double greatest_weight = 100.0;

double weight_of(double least_length, double extremum) {
  return extremum * greatest_weight > least_length ? least_length / extremum : greatest_weight;
}

}  // namespace

double fitness_of(const SplineMeasures& m, const SplineWeights& k) {
  return k.length * m.length + k.risk * m.risk + k.time * m.time + k.turning * m.turning - k.energy * m.energy + collision_penalty * m.collisions;
}

SplineWeights normalised_weights(double least_length, double least_risk, double least_time, double least_turning, double greatest_energy) {
  return {1.0, weight_of(least_length, least_risk), weight_of(least_length, least_time), weight_of(least_length, least_turning), weight_of(least_length, greatest_energy)};
}

SplineMeasurer::SplineMeasurer(const Problem& problem) : problem_{problem}, within_{1.5 * problem.footprint().radius()} {
  const Map& map = problem.world().map();
  // As danger_astar has it: at least a cell and a half, or what stands beside a cell would not count.
  for (const CellGrid& grid : map.grids) within_ = std::max(within_, 1.5 * grid.cell);
  const auto add = [&](const std::vector<Vec2>& points, bool is_closed) {
    if (!points.empty()) outlines_.push_back({points, is_closed, bounding_box(points)});
  };
  for (const Ring& ring : map.boundaries) add(ring, true);
  for (const Ring& ring : map.obstacles) add(ring, true);
  for (const Polyline& line : map.lines) add(line, false);
  for (const Vec2 point : map.points) add({point}, false);
}

double SplineMeasurer::risk_at(Vec2 p) const {
  double risk = 0.0;
  for (const Outline& outline : outlines_) {
    const double dx = std::max({0.0, outline.box.low.x - p.x, p.x - outline.box.high.x}), dy = std::max({0.0, outline.box.low.y - p.y, p.y - outline.box.high.y});
    if (dx * dx + dy * dy > within_ * within_) continue;
    const std::size_t n = outline.points.size(), edges = outline.is_closed ? n : n - 1;
    double least = n == 1 ? distance(p, outline.points[0]) : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < edges; ++i) least = std::min(least, point_segment_distance(p, outline.points[i], outline.points[(i + 1) % n]));
    risk += risk_of(least, {.reach = within_});
  }
  for (const CellGrid& grid : problem_.world().map().grids) {
    const Vec2 local = Frame{grid.origin}.to_local(p);
    const double column = local.x / grid.cell - 0.5, row = static_cast<double>(grid.rows) - local.y / grid.cell - 0.5;  // where cell centres are whole
    const double reach = within_ / grid.cell;
    const auto low = [](double v) { return static_cast<int>(std::max(0.0, std::ceil(std::min(v, 1e9)))); };
    const auto high = [](double v, int count) { return static_cast<int>(std::floor(std::clamp(v, -1.0, static_cast<double>(count - 1)))); };
    for (int r = low(row - reach); r <= high(row + reach, grid.rows); ++r) {
      for (int c = low(column - reach); c <= high(column + reach, grid.columns); ++c) {
        if (!grid.is_blocked(c, r)) continue;
        const double d2 = (c - column) * (c - column) + (r - row) * (r - row);
        risk += risk_of(grid.cell * std::sqrt(d2), {.reach = within_});
      }
    }
  }
  return risk;
}

SplineMeasures SplineMeasurer::measure(std::span<const Pose> poses) const {
  SplineMeasures m;
  ClearanceAlong clearance{problem_.world(), problem_.footprint(), std::max(0.5, problem_.footprint().radius())};
  Vec2 before{};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (clearance.at(poses[i]) <= 0.0) ++m.collisions;
    m.risk += risk_at(poses[i].position());
    if (i == 0) continue;
    const Vec2 step = poses[i].position() - poses[i - 1].position();
    if (step == Vec2{}) continue;
    m.length += norm(step);
    if (before != Vec2{}) m.turning += std::abs(arc_tangent(cross(before, step), dot(before, step)));
    before = step;
  }
  m.time = way_time(m.length, problem_.vehicle().limits.speed);
  m.energy = residual_power(m.length, m.turning);
  return m;
}

}  // namespace waywright
