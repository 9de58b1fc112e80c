#include "waywright/planner/roadmap/region_ends.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr double slack = 1e-9;     // m
constexpr double parallel = 1e-12;  // sine: such an edge comes no nearer to a line along it

/// A straight edge by its length.
struct Edge {
  Vec2 from{}, along{};
  double length = 0.0;
};

/// Calls `take` with metres along the edge's line at which it is `radius` from the segment.
template <class Take>
void touchings(const Edge& edge, const Segment& s, double radius, const Take& take) {
  for (const Vec2 center : {s.a, s.b}) {
    const double across = cross(edge.along, center - edge.from);
    if (std::abs(across) > radius) continue;
    const double middle = dot(edge.along, center - edge.from), half = std::sqrt(radius * radius - across * across);
    take(middle - half);
    take(middle + half);
    if (s.a == s.b) return;
  }
  const double length = distance(s.a, s.b);
  const Vec2 along = (1.0 / length) * (s.b - s.a);
  const double slope = cross(along, edge.along), off = cross(along, edge.from - s.a);
  if (std::abs(slope) < parallel) return;
  for (const double side : {-radius, radius}) {
    const double t = (side - off) / slope;
    const double at = dot(along, edge.from + t * edge.along - s.a);
    if (at >= -slack && at <= length + slack) take(t);
  }
}

}  // namespace

std::vector<Vec2> region_ends(const PlaneSpace& space, const PlaneTarget& target, double radius, double margin) {
  std::vector<Vec2> ends{target.area};
  if (target.is_point()) return ends;
  std::vector<double> on_edge;
  for (std::size_t i = 0; i < target.area.size(); ++i) {
    const Vec2 from = target.area[i], to = target.area[(i + 1) % target.area.size()];
    const double length = distance(from, to);
    if (!(length > 0.0)) continue;
    const Edge edge{from, (1.0 / length) * (to - from), length};
    const Vec2 around{radius + slack, radius + slack};
    const Box box{Vec2{std::min(from.x, to.x), std::min(from.y, to.y)} - around, Vec2{std::max(from.x, to.x), std::max(from.y, to.y)} + around};
    on_edge.clear();
    space.problem().world().index().all_of(box, [&](const Segment& s) {
      touchings(edge, s, radius, [&](double t) {
        if (t >= -slack && t <= length + slack) on_edge.push_back(std::clamp(t, 0.0, length));
      });
      return true;
    });
    std::sort(on_edge.begin(), on_edge.end());
    double last = -1.0;
    for (const double t : on_edge) {
      if (t - last <= slack) continue;
      last = t;
      const Vec2 end = from + t * edge.along;
      if (space.is_free(end, margin)) ends.push_back(end);
    }
  }
  return ends;
}

}  // namespace waywright
