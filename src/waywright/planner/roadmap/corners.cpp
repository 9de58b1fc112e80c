#include "waywright/planner/roadmap/corners.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr double aligned = 1e-9;      // rad, about: sines under it count as 0
constexpr double beside = 1e-6;       // m: so far from a corner what is solid shows
constexpr double widest_off = 0.002;  // of the radius, that a chord may leave its arc by
constexpr int most_pieces = 16;       // of a half circle, looked at for what is free

/// A direction of something that begins in a point.
struct Ray {
  Vec2 at;
  Vec2 direction;
  double angle;
};

bool is_before(const Ray& a, const Ray& b) {
  if (a.at.x != b.at.x) return a.at.x < b.at.x;
  if (a.at.y != b.at.y) return a.at.y < b.at.y;
  return a.angle < b.angle;
}

Vec2 right_of(Vec2 v) { return -left_of(v); }

/// Points that are nothing else come with no direction.
std::vector<Ray> rays_of(const World& world) {
  std::vector<Ray> rays;
  for (const Segment& s : world.index().segments()) {
    if (s.a == s.b) {
      rays.push_back({s.a, {0.0, 0.0}, -10.0});
      continue;
    }
    const Vec2 along = (1.0 / distance(s.a, s.b)) * (s.b - s.a);
    rays.push_back({s.a, along, angle_of(along)});
    rays.push_back({s.b, -along, angle_of(-along)});
  }
  std::sort(rays.begin(), rays.end(), is_before);
  return rays;
}

/// Is no part of the arc between two directions farther than margin from everything? @pre the angle between is small
bool is_shut(const PlaneSpace& space, Vec2 middle_of_arc, double half_chord, double margin) { return !space.is_free(middle_of_arc, std::max(0.0, margin - half_chord)); }

}  // namespace

bool Corner::holds(Vec2 direction) const {
  if (is_point) return true;
  if (cross(first, direction) < -aligned || cross(direction, last) < -aligned) return false;
  const Vec2 middle = first + last;
  return squared_norm(middle) < aligned || dot(direction, middle) > 0.0;
}

bool is_arc_free(const PlaneSpace& space, Vec2 center, double radius, Vec2 from, double angle, double margin, Rounding rounding) {
  // A chord over the angle s leaves the arc by r (1 − cos s/2) < r s²/8, inwards, where the corner is.
  const double allowed = rounding == Rounding::safe ? 0.25 * (radius - margin) : widest_off * radius;
  const double step = radius > 0.0 ? std::min(1.0, std::sqrt(8.0 * allowed / radius)) : 1.0;
  const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / step)));
  const double each = angle / chords;
  const double off = radius * each * each / 8.0;
  const double kept = rounding == Rounding::safe ? margin + off : std::max(0.0, margin - off);
  Vec2 before = center + radius * from;
  for (int i = 1; i <= chords; ++i) {
    const SinCos a = sin_cos(each * i);
    const Vec2 next = center + radius * Vec2{a.cos * from.x - a.sin * from.y, a.sin * from.x + a.cos * from.y};
    if (!space.is_free(before, next, kept)) return false;
    before = next;
  }
  return true;
}

std::vector<Corner> corners_of(const PlaneSpace& space, double radius, double margin, Rounding rounding) {
  const World& world = space.problem().world();
  const std::vector<Ray> rays = rays_of(world);
  std::vector<Corner> corners;
  const auto add = [&](Corner corner, double width, Vec2 middle) {
    if (!corner.is_point && world.is_blocked(corner.at + beside * middle)) return;
    const int pieces = std::max(1, static_cast<int>(std::ceil(width / pi * most_pieces)));
    const double each = width / pieces;
    bool is_any_free = false;
    for (int i = 0; i < pieces && !is_any_free; ++i) {
      const SinCos a = sin_cos(each * (i + 0.5));
      const Vec2 m{a.cos * corner.first.x - a.sin * corner.first.y, a.sin * corner.first.x + a.cos * corner.first.y};
      is_any_free = !is_shut(space, corner.at + radius * m, 0.5 * each * radius, margin);
    }
    if (!is_any_free) return;
    corner.is_open = is_arc_free(space, corner.at, radius, corner.first, width, margin, rounding);
    corners.push_back(corner);
  };
  for (std::size_t i = 0; i < rays.size();) {
    std::size_t end = i;
    while (end < rays.size() && rays[end].at == rays[i].at) ++end;
    std::size_t begin = i;
    while (begin < end && rays[begin].direction == Vec2{0.0, 0.0}) ++begin;
    const Vec2 at = rays[i].at;
    i = end;
    if (begin == end) {
      add({at, {1.0, 0.0}, {1.0, 0.0}, true, false}, two_pi, {1.0, 0.0});
      continue;
    }
    // The one sector between neighbours that is wider than a half turn, if there is one.
    for (std::size_t k = begin; k < end; ++k) {
      const Ray& a = rays[k];
      const Ray& b = rays[k + 1 < end ? k + 1 : begin];
      double gap = b.angle - a.angle;
      if (k + 1 == end) gap += two_pi;
      if (!(gap > pi + aligned)) continue;
      Corner corner{at, left_of(a.direction), right_of(b.direction), false, false};
      const Vec2 middle = unit(wrap(a.angle + 0.5 * gap));
      add(corner, gap - pi, middle);
    }
  }
  return corners;
}

}  // namespace waywright
