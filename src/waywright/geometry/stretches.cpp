#include "waywright/geometry/stretches.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

/// Shares of the way that are within `reach` of the segment from a to b, which are one interval; false where there are none.
bool near_edge(Vec2 from, Vec2 way, Vec2 a, Vec2 b, double reach, WayPart& near) {
  near = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const double squared = squared_norm(way);
  const auto take = [&](double low, double high) {
    if (low > high) return;
    near = {std::min(near.begin, low), std::max(near.end, high)};
  };
  for (const Vec2 corner : {a, b}) {
    const double middle = dot(corner - from, way) / squared;
    const double off = cross(corner - from, way);
    const double half = reach * reach - off * off / squared;
    if (half < 0.0) continue;
    const double by = std::sqrt(half / squared);
    take(middle - by, middle + by);
  }
  const Vec2 edge = b - a;
  const double length = norm(edge);
  if (length > 0.0) {
    // Beside the edge: two conditions that are linear in the share.
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    const auto keep = [&](double at_zero, double slope, double least, double most) {
      if (slope == 0.0) {
        if (at_zero < least || at_zero > most) high = -std::numeric_limits<double>::infinity();
        return;
      }
      const double one = (least - at_zero) / slope, other = (most - at_zero) / slope;
      low = std::max(low, std::min(one, other));
      high = std::min(high, std::max(one, other));
    };
    keep(cross(edge, from - a) / length, cross(edge, way) / length, -reach, reach);
    keep(dot(edge, from - a) / length, dot(edge, way) / length, 0.0, length);
    take(low, high);
  }
  near = {std::max(0.0, near.begin), std::min(1.0, near.end)};
  return near.begin <= near.end;
}

}  // namespace

std::vector<WayPart> stretches_deeper_than(const Ring& ring, double depth, Vec2 from, Vec2 to) {
  const Vec2 way = to - from;
  if (squared_norm(way) == 0.0) return depth_in(ring, from) > depth ? std::vector<WayPart>{{0.0, 1.0}} : std::vector<WayPart>{};
  std::vector<WayPart> near;
  WayPart one;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (near_edge(from, way, ring[i], ring[(i + 1) % ring.size()], depth, one)) near.push_back(one);
  }
  std::sort(near.begin(), near.end(), [](const WayPart& a, const WayPart& b) { return a.begin < b.begin; });
  near.push_back({1.0, 1.0});
  // What is left between them is wholly inside or wholly outside.
  std::vector<WayPart> deep;
  double reached = 0.0;
  for (const WayPart& n : near) {
    if (n.begin > reached && contains(ring, from + 0.5 * (reached + n.begin) * way)) deep.push_back({reached, n.begin});
    reached = std::max(reached, n.end);
  }
  return deep;
}

void add_crossings(const Ring& ring, Vec2 from, Vec2 to, std::vector<double>& shares) {
  constexpr double beyond = 1e-9;  // shares of an edge, beyond its ends
  const Vec2 way = to - from;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], edge = ring[(i + 1) % ring.size()] - a;
    const double across = cross(way, edge);
    if (across == 0.0) continue;  // beside each other: the edges at its ends are crossed
    const double along = cross(a - from, way);
    // Mostly it is far from the edge, which needs no division to be known.
    constexpr double clearly = 2.0 * beyond;
    if (across > 0.0 ? along < -clearly * across || along > (1.0 + clearly) * across : along > -clearly * across || along < (1.0 + clearly) * across) continue;
    const double on_edge = along / across;
    if (!(on_edge >= -beyond && on_edge <= 1.0 + beyond)) continue;
    const double share = cross(a - from, edge) / across;
    if (share > 0.0 && share < 1.0) shares.push_back(share);
  }
}

}  // namespace waywright
