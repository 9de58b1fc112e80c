#include "plain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace yardstick {
namespace {

double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

double point_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (p - (a + t * d)).norm();
}

bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double d0 = cross(d - c, a - c);
  const double d1 = cross(d - c, b - c);
  const double e0 = cross(b - a, c - a);
  const double e1 = cross(b - a, d - a);
  return ((d0 > 0) != (d1 > 0)) && ((e0 > 0) != (e1 > 0));
}

double segment_to_segment(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (segments_cross(a, b, c, d)) return 0.0;
  return std::min(std::min(point_to_segment(a, c, d), point_to_segment(b, c, d)),
                  std::min(point_to_segment(c, a, b), point_to_segment(d, a, b)));
}

bool inside_convex(const Polygon& polygon, const Point& p) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    if (cross(b - a, p - a) < 0.0) return false;
  }
  return true;
}

double polygon_to_segment(const Polygon& polygon, const Point& a, const Point& b) {
  if (inside_convex(polygon, a)) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    least = std::min(least, segment_to_segment(polygon[i], polygon[(i + 1) % polygon.size()], a, b));
  }
  return least;
}

double polygon_to_polygon(const Polygon& a, const Polygon& b) {
  if (inside_convex(b, a[0])) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < b.size(); ++i) {
    least = std::min(least, polygon_to_segment(a, b[i], b[(i + 1) % b.size()]));
  }
  return least;
}

/// True where a line along an edge of `a` has all of `b` more than `by` beyond it.
template <class Points>
bool an_edge_separates(const Polygon& a, const Points& b, double by) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point edge = a[(i + 1) % a.size()] - a[i];
    const Point outwards = Point(edge.y(), -edge.x()) / edge.norm();
    double gap = std::numeric_limits<double>::infinity();
    for (const Point& p : b) gap = std::min(gap, outwards.dot(p - a[i]));
    if (gap > by) return true;
  }
  return false;
}

double polygon_to_point(const Polygon& polygon, const Point& p) {
  if (inside_convex(polygon, p)) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    least = std::min(least, point_to_segment(p, polygon[i], polygon[(i + 1) % polygon.size()]));
  }
  return least;
}

Polygon placed(const Polygon& footprint, const Point& position, const Point& heading) {
  Polygon out;
  out.reserve(footprint.size());
  for (const Point& p : footprint) {
    out.push_back(position + p.x() * heading + p.y() * Point(-heading.y(), heading.x()));
  }
  return out;
}

struct Box {
  Point low, high;
  template <class Points>
  static Box of(const Points& points) {
    Box box{points[0], points[0]};
    for (const Point& p : points) {
      box.low = box.low.cwiseMin(p);
      box.high = box.high.cwiseMax(p);
    }
    return box;
  }
  bool is_apart(const Box& other, double by) const {
    return low.x() > other.high.x() + by || other.low.x() > high.x() + by || low.y() > other.high.y() + by ||
           other.low.y() > high.y() + by;
  }
};

bool hits(const Polygon& body, const Polygon& obstacle, double clearance) {
  if (an_edge_separates(body, obstacle, clearance) || an_edge_separates(obstacle, body, clearance)) return false;
  return polygon_to_polygon(body, obstacle) <= clearance;
}
bool hits(const Polygon& body, const std::array<Point, 2>& wall, double clearance) {
  return !an_edge_separates(body, wall, clearance) && polygon_to_segment(body, wall[0], wall[1]) <= clearance;
}
bool hits(const Polygon& body, const Point& point, double clearance) {
  return !an_edge_separates(body, std::array<Point, 1>{point}, clearance) && polygon_to_point(body, point) <= clearance;
}

bool hit_plain(const Scene& scene, const Polygon& body) {
  for (const Polygon& obstacle : scene.obstacles) {
    if (hits(body, obstacle, scene.clearance)) return true;
  }
  for (const auto& wall : scene.walls) {
    if (hits(body, wall, scene.clearance)) return true;
  }
  for (const Point& p : scene.points) {
    if (hits(body, p, scene.clearance)) return true;
  }
  return false;
}

bool hit_boxes_first(const Scene& scene, const std::vector<Box>& boxes, const std::vector<Box>& walls, const Polygon& body) {
  const Box own = Box::of(body);
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    if (!own.is_apart(boxes[i], scene.clearance) && hits(body, scene.obstacles[i], scene.clearance)) return true;
  }
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    if (!own.is_apart(walls[i], scene.clearance) && hits(body, scene.walls[i], scene.clearance)) return true;
  }
  for (const Point& p : scene.points) {
    if (!own.is_apart({p, p}, scene.clearance) && hits(body, p, scene.clearance)) return true;
  }
  return false;
}

struct At {
  Point p, d1, d2, d3;
};

/// De Casteljau by way of the differences of the control points.
At quintic(const std::array<Point, 6>& c, double u) {
  const auto point = [u](auto points) {
    for (std::size_t n = points.size() - 1; n > 0; --n) {
      for (std::size_t i = 0; i < n; ++i) points[i] = (1.0 - u) * points[i] + u * points[i + 1];
    }
    return points[0];
  };
  std::array<Point, 5> first;
  std::array<Point, 4> second;
  std::array<Point, 3> third;
  for (std::size_t i = 0; i < 5; ++i) first[i] = 5.0 * (c[i + 1] - c[i]);
  for (std::size_t i = 0; i < 4; ++i) second[i] = 4.0 * (first[i + 1] - first[i]);
  for (std::size_t i = 0; i < 3; ++i) third[i] = 3.0 * (second[i + 1] - second[i]);
  return {point(c), point(first), point(second), point(third)};
}

template <class Hit>
Verdict evaluate(const Scene& scene, const Candidate& candidate, int samples, const Hit& hit) {
  Verdict verdict;
  for (int k = 0; k < 2; ++k) {
    const std::array<Point, 6>& control = k == 0 ? candidate.back : candidate.forth;
    double last_speed = 0.0;
    double last_curvature = 0.0;
    for (int i = 0; i < samples; ++i) {
      const double h = 1.0 / (samples - 1);
      const At at = quintic(control, i * h);
      const double speed = at.d1.norm();
      const double turn = cross(at.d1, at.d2);
      const double curvature = turn / (speed * speed * speed);
      const double rate =
          (cross(at.d1, at.d3) * speed * speed - 3.0 * turn * at.d1.dot(at.d2)) / std::pow(speed, 6);
      if (i > 0) {
        verdict.length += 0.5 * h * (last_speed + speed);
        verdict.curvature_change += std::abs(curvature - last_curvature);
      }
      verdict.max_curvature = std::max(verdict.max_curvature, std::abs(curvature));
      verdict.max_curvature_rate = std::max(verdict.max_curvature_rate, std::abs(rate));
      last_speed = speed;
      last_curvature = curvature;
      const Point heading = (k == 0 ? -1.0 : 1.0) / speed * at.d1;
      if (hit(placed(scene.footprint, at.p, heading))) {
        if (verdict.first_hit < 0) verdict.first_hit = verdict.poses;
        ++verdict.hits;
      }
      ++verdict.poses;
    }
  }
  return verdict;
}

}  // namespace

Verdict evaluate_plain(const Scene& scene, const Candidate& candidate, int samples) {
  return evaluate(scene, candidate, samples, [&](const Polygon& body) { return hit_plain(scene, body); });
}

Verdict evaluate_boxes_first(const Scene& scene, const Candidate& candidate, int samples) {
  std::vector<Box> boxes, walls;
  for (const Polygon& obstacle : scene.obstacles) boxes.push_back(Box::of(obstacle));
  for (const auto& wall : scene.walls) walls.push_back(Box::of(wall));
  return evaluate(scene, candidate, samples,
                  [&](const Polygon& body) { return hit_boxes_first(scene, boxes, walls, body); });
}

double distance_at(const Scene& scene, const Point& position, const Point& heading) {
  const Polygon body = placed(scene.footprint, position, heading);
  double least = std::numeric_limits<double>::infinity();
  for (const Polygon& obstacle : scene.obstacles) least = std::min(least, polygon_to_polygon(body, obstacle));
  for (const auto& wall : scene.walls) least = std::min(least, polygon_to_segment(body, wall[0], wall[1]));
  for (const Point& p : scene.points) least = std::min(least, polygon_to_point(body, p));
  return least;
}

}  // namespace yardstick
