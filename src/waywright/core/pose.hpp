// Points, vectors and poses of the plane. Metres, radians.
#pragma once

#include <cmath>

#include "waywright/core/angle.hpp"
#include "waywright/core/elementary.hpp"

namespace waywright {

struct Vec2 {
  double x = 0.0;
  double y = 0.0;

  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(double k, Vec2 a) { return {k * a.x, k * a.y}; }
  friend constexpr Vec2 operator*(Vec2 a, double k) { return {k * a.x, k * a.y}; }
  friend constexpr bool operator==(Vec2, Vec2) = default;
};

constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// z component of the cross product: positive where b lies to the left of a.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
constexpr double squared_norm(Vec2 a) { return a.x * a.x + a.y * a.y; }
inline double norm(Vec2 a) { return std::sqrt(squared_norm(a)); }
inline double distance(Vec2 a, Vec2 b) { return norm(a - b); }
/// a turned by +90°.
constexpr Vec2 left_of(Vec2 a) { return {-a.y, a.x}; }
inline Vec2 unit(double angle) {
  const SinCos a = sin_cos(angle);
  return {a.cos, a.sin};
}
inline double angle_of(Vec2 a) { return arc_tangent(a.y, a.x); }
inline bool is_finite(Vec2 a) { return std::isfinite(a.x) && std::isfinite(a.y); }

/// Position and heading of the body frame (x forward, y left) in the world frame.
struct Pose {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;

  constexpr Vec2 position() const { return {x, y}; }
  friend constexpr bool operator==(const Pose&, const Pose&) = default;
};

inline Pose make_pose(Vec2 p, double heading) { return {p.x, p.y, heading}; }
inline bool is_finite(const Pose& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.heading);
}

/// A rigid motion with its sine and cosine at hand: body frame → world frame.
/// Laws: to_local(to_world(p)) == p up to rounding; distances are kept.
class Frame {
 public:
  Frame() = default;
  explicit Frame(const Pose& pose) : origin_{pose.x, pose.y}, heading_{pose.heading} {
    const SinCos a = sin_cos(pose.heading);
    cos_ = a.cos;
    sin_ = a.sin;
  }

  Vec2 origin() const { return origin_; }
  double heading() const { return heading_; }
  Vec2 rotate(Vec2 v) const { return {cos_ * v.x - sin_ * v.y, sin_ * v.x + cos_ * v.y}; }
  Vec2 unrotate(Vec2 v) const { return {cos_ * v.x + sin_ * v.y, -sin_ * v.x + cos_ * v.y}; }
  Vec2 to_world(Vec2 p) const { return origin_ + rotate(p); }
  Vec2 to_local(Vec2 p) const { return unrotate(p - origin_); }
  Pose to_world(const Pose& p) const {
    return make_pose(to_world(p.position()), wrap(p.heading + heading_));
  }
  Pose to_local(const Pose& p) const {
    return make_pose(to_local(p.position()), wrap(p.heading - heading_));
  }

 private:
  Vec2 origin_{};
  double cos_ = 1.0;
  double sin_ = 0.0;
  double heading_ = 0.0;
};

}  // namespace waywright
