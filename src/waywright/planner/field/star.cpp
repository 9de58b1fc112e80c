#include "waywright/planner/field/star.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/geometry/obstacle_index.hpp"

namespace waywright {
namespace {

constexpr double hair = 1e-9;  // m
constexpr int searches = 80;

/// Convex ring ∩ {p : cross(along, p − at) ≥ 0}.
Ring left_part(const Ring& ring, Vec2 at, Vec2 along) {
  Ring kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const double da = cross(along, a - at), db = cross(along, b - at);
    if (da >= 0.0) kept.push_back(a);
    if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) kept.push_back(a + (da / (da - db)) * (b - a));
  }
  return kept;
}

/// m, to the nearest edge's line; negative outside.
double depth(const Ring& convex, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Vec2 along = convex[(i + 1) % convex.size()] - convex[i];
    if (const double length = norm(along); length > 0.0) least = std::min(least, cross(along, p - convex[i]) / length);
  }
  return least;
}

/// The greatest of a concave function on an interval.
template <class F>
double best_of(double low, double high, F&& f) {
  for (int k = 0; k < searches; ++k) {
    const double a = low + (high - low) * 0.382, b = high - (high - low) * 0.382;
    if (f(a) < f(b)) low = a;
    else high = b;
  }
  return 0.5 * (low + high);
}

}  // namespace

Ring places_that_see_all(const Ring& ring) {
  const Box box = bounding_box(ring);
  Ring kernel = rectangle(box.low, box.high);
  for (std::size_t i = 0; i < ring.size() && kernel.size() >= 3; ++i) kernel = left_part(kernel, ring[i], ring[(i + 1) % ring.size()] - ring[i]);
  return kernel;
}

Ring kernel_of(const Ring& ring) {
  Ring kernel = places_that_see_all(ring);
  if (kernel.size() < 3 || !(signed_area(kernel) > 0.0) || largest_circle_in(kernel).radius < hair) return {};
  return kernel;
}

InnerCircle largest_circle_in(const Ring& convex) {
  const Box box = bounding_box(convex);
  const auto best_y = [&](double x) { return best_of(box.low.y, box.high.y, [&](double y) { return depth(convex, {x, y}); }); };
  const double x = best_of(box.low.x, box.high.x, [&](double at) { return depth(convex, {at, best_y(at)}); });
  const Vec2 centre{x, best_y(x)};
  return {centre, depth(convex, centre)};
}

Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.dx + b.dx, a.dy + b.dy}; }
Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.dx - b.dx, a.dy - b.dy}; }
Dual operator*(const Dual& a, const Dual& b) { return {a.value * b.value, a.dx * b.value + a.value * b.dx, a.dy * b.value + a.value * b.dy}; }
Dual operator/(const Dual& a, const Dual& b) {
  const double q = a.value / b.value;
  return {q, (a.dx - q * b.dx) / b.value, (a.dy - q * b.dy) / b.value};
}
Dual square_root(const Dual& a) {
  const double root = std::sqrt(a.value);
  return {root, 0.5 * a.dx / root, 0.5 * a.dy / root};
}

Star::Star(Ring ring, Vec2 centre, double distance, bool is_boundary) : ring_{std::move(ring)}, centre_{centre}, distance_{distance}, is_boundary_{is_boundary} {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    nearest = std::min(nearest, point_segment_distance(centre_, ring_[i], ring_[(i + 1) % ring_.size()]));
    greatest_ = std::max(greatest_, norm(ring_[i] - centre_));
  }
  least_ = is_boundary_ ? nearest - distance_ : nearest + distance_;
  if (!is_boundary_) greatest_ += distance_;
}

// A ray from the centre meets the strip beside an edge at (±distance + n·(a − c))/(n·u), n its normal, and the circle about a corner at b ± √(b² − |d|² + distance²), d the
// corner from the centre, b = u·d. Grown, the last of all that it leaves is the rim; shrunk, the first that it comes to.
Dual Star::rim(Vec2 q) const {
  const Vec2 way = q - centre_;
  const double apart = norm(way);
  const Vec2 u = (1.0 / apart) * way;
  enum class By { edge, corner };
  double best = is_boundary_ ? std::numeric_limits<double>::infinity() : 0.0;
  By by = By::edge;
  std::size_t which = 0;
  const auto take = [&](double t, By how, std::size_t i) {
    if (!(t > 0.0) || (is_boundary_ ? t >= best : t <= best)) return;
    best = t;
    by = how;
    which = i;
  };
  const double side = is_boundary_ ? -distance_ : distance_;
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const Vec2 a = ring_[i] - centre_, b = ring_[(i + 1) % ring_.size()] - centre_, along = b - a;
    const double length = norm(along);
    const Vec2 out = (-1.0 / length) * left_of(along);  // counter-clockwise: outwards is to the right
    if (const double rate = dot(out, u); rate > 0.0) {
      const double t = (dot(out, a) + side) / rate;
      const double foot = dot(t * u - a, along);
      if (foot >= 0.0 && foot <= length * length) take(t, By::edge, i);
    }
    if (distance_ > 0.0) {
      const double towards = dot(u, a), under = towards * towards - squared_norm(a) + distance_ * distance_;
      if (under >= 0.0) take(is_boundary_ ? towards - std::sqrt(under) : towards + std::sqrt(under), By::corner, i);
    }
  }
  // The way's direction with its derivatives.
  const Dual x{way.x, 1.0, 0.0}, y{way.y, 0.0, 1.0}, r = square_root(x * x + y * y), ux = x / r, uy = y / r;
  const Vec2 a = ring_[which] - centre_;
  if (by == By::edge) {
    const Vec2 along = ring_[(which + 1) % ring_.size()] - centre_ - a;
    const Vec2 out = (-1.0 / norm(along)) * left_of(along);
    return constant(dot(out, a) + side) / (constant(out.x) * ux + constant(out.y) * uy);
  }
  const Dual towards = constant(a.x) * ux + constant(a.y) * uy;
  Dual under = towards * towards - constant(squared_norm(a) - distance_ * distance_);
  under.value = std::max(under.value, 1e-30);
  return is_boundary_ ? towards - square_root(under) : towards + square_root(under);
}

}  // namespace waywright
