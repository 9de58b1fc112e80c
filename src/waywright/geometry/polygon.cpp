#include "waywright/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/geometry/obstacle_index.hpp"

namespace waywright {

Box bounding_box(const std::vector<Vec2>& points) {
  Box box{points.front(), points.front()};
  for (const Vec2 p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

double signed_area(const Ring& ring) {
  if (ring.size() < 3) return 0.0;
  double twice = 0.0;  // relative to the first corner: coordinates may be large and the ring small
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return 0.5 * twice;
}

bool contains(std::span<const Vec2> ring, Vec2 point) {
  bool in = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2 a = ring[i];
    const Vec2 b = ring[j];
    if (cross(b - a, point - a) == 0.0 && dot(point - a, point - b) <= 0.0) return true;
    if ((a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x) in = !in;
  }
  return in;
}

double inner_radius(const Ring& ring, Vec2 center) {
  if (!contains(ring, center)) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    least = std::min(least, point_segment_distance(center, ring[i], ring[(i + 1) % ring.size()]));
  }
  return least;
}

void convex_hull(std::vector<Vec2>& points, Ring& hull) {
  std::sort(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) {
    hull.assign(points.begin(), points.end());
    return;
  }
  hull.resize(2 * points.size());  // monotone chain (Andrew 1979)
  std::size_t n = 0;
  const auto add = [&](Vec2 p, std::size_t least) {
    while (n >= least && cross(hull[n - 1] - hull[n - 2], p - hull[n - 2]) <= 0.0) --n;
    hull[n++] = p;
  };
  for (const Vec2 p : points) add(p, 2);
  const std::size_t lower = n + 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  hull.resize(n - 1);
}

Ring convex_hull(std::vector<Vec2> points) {
  Ring hull;
  convex_hull(points, hull);
  return hull;
}

bool is_convex(const Ring& ring) {
  const std::size_t n = ring.size();
  if (n < 3) return false;
  // All corners turn left, and the edge directions go round only once (a pentagram turns left everywhere too).
  int quadrant_changes = 0;
  const auto upper = [&](std::size_t i) {
    const Vec2 d = ring[(i + 1) % n] - ring[i % n];
    return d.y > 0.0 || (d.y == 0.0 && d.x > 0.0);
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (cross(ring[(i + 1) % n] - ring[i], ring[(i + 2) % n] - ring[(i + 1) % n]) < 0.0) return false;
    if (upper(i) != upper(i + 1)) ++quadrant_changes;
  }
  return quadrant_changes <= 2;
}

double least_width(const std::vector<Vec2>& points) {
  const Ring hull = convex_hull(points);
  const std::size_t n = hull.size();
  if (n < 3) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  std::size_t far = 1;
  for (std::size_t i = 0; i < n; ++i) {  // rotating calipers: the farthest corner only moves forward
    const Vec2 a = hull[i];
    const Vec2 edge = hull[(i + 1) % n] - a;
    while (cross(edge, hull[(far + 1) % n] - a) > cross(edge, hull[far] - a)) far = (far + 1) % n;
    least = std::min(least, cross(edge, hull[far] - a) / norm(edge));
  }
  return least;
}

Vec2 nearest_in(const Ring& ring, Vec2 point) {
  if (contains(ring, point)) return point;
  Vec2 nearest = ring.front();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Vec2 on{};
    const double d = point_segment_distance(point, ring[i], ring[(i + 1) % ring.size()], &on);
    if (d < least) {
      least = d;
      nearest = on;
    }
  }
  return nearest;
}

Ring transformed(const Ring& ring, const Frame& frame) {
  Ring moved;
  moved.reserve(ring.size());
  for (const Vec2 p : ring) moved.push_back(frame.to_world(p));
  return moved;
}

Ring rectangle(Vec2 low, Vec2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

}  // namespace waywright
