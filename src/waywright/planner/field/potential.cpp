#include "waywright/planner/field/potential.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {

std::vector<PotentialField::Obstacle> PotentialField::in_reach(Vec2 q) const {
  const World& world = space_.problem().world();
  const double kept = space_.disc() + space_.problem().required_clearance();
  std::vector<Obstacle> all;
  if (world.index().empty()) return all;
  world.index().visit(q, options_.reach + kept, [&](const Segment& segment) {
    if (world.is_boundary(segment.source) && !options_.repels_walls) return;
    Vec2 point;
    const double away = point_segment_distance(q, segment.a, segment.b, &point) - kept;
    if (!(away <= options_.reach)) return;
    const bool is_ring = world.is_solid(segment.source) || world.is_boundary(segment.source);
    const std::size_t source = is_ring ? segment.source : World::nothing;
    const auto same = std::find_if(all.begin(), all.end(), [&](const Obstacle& o) { return o.source == source; });
    if (same == all.end()) all.push_back({source, away, point});
    else if (away < same->distance) *same = {source, away, point};
  });
  std::sort(all.begin(), all.end(), [](const Obstacle& a, const Obstacle& b) { return a.source < b.source; });
  return all;
}

std::optional<PotentialField::Value> PotentialField::at(Vec2 q) const {
  const PotentialOptions& o = options_;
  const Vec2 away = q - goal_;
  const double n = norm(away);
  Value value{0.0, {}, std::numeric_limits<double>::infinity()};
  if (n <= o.conic_from) {
    value.potential = 0.5 * o.attraction * n * n;
    value.gradient = o.attraction * away;
  } else {
    value.potential = o.conic_from * o.attraction * (n - 0.5 * o.conic_from);
    value.gradient = (o.conic_from * o.attraction / n) * away;
  }
  const double weight = o.reaches_goal ? n * n : 1.0;
  for (const Obstacle& obstacle : in_reach(q)) {
    const double rho = obstacle.distance;
    if (!(rho > 0.0)) return std::nullopt;
    value.distance = std::min(value.distance, rho);
    const double excess = 1.0 / rho - 1.0 / o.reach;
    const double potential = 0.5 * o.repulsion * excess * excess;
    const Vec2 from_obstacle = (1.0 / distance(q, obstacle.point)) * (q - obstacle.point);
    value.potential += weight * potential;
    value.gradient = value.gradient - (weight * o.repulsion * excess / (rho * rho)) * from_obstacle;
    if (o.reaches_goal) value.gradient = value.gradient + (2.0 * potential) * away;
  }
  if (space_.problem().world().is_blocked(q)) return std::nullopt;
  return value;
}

}  // namespace waywright
