#include "waywright/geometry/convex_parts.hpp"

#include <cstddef>

namespace waywright {
namespace {

bool in_triangle(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
  return cross(b - a, p - a) >= 0.0 && cross(c - b, p - b) >= 0.0 && cross(a - c, p - c) >= 0.0;
}

bool is_ear(const Ring& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const Vec2 a = ring[(i + n - 1) % n];
  const Vec2 b = ring[i];
  const Vec2 c = ring[(i + 1) % n];
  if (cross(b - a, c - b) <= 0.0) return false;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 p = ring[k];
    if (p == a || p == b || p == c) continue;
    if (in_triangle(p, a, b, c)) return false;
  }
  return true;
}

}  // namespace

std::vector<Ring> convex_parts(const Ring& ring) {
  if (is_convex(ring)) return {ring};
  std::vector<Ring> parts;
  Ring rest = ring;
  while (rest.size() > 3) {
    const std::size_t n = rest.size();
    std::size_t ear = n;
    for (std::size_t i = 0; i < n && ear == n; ++i) {
      // A straight corner cuts off nothing.
      const Vec2 a = rest[(i + n - 1) % n];
      const Vec2 c = rest[(i + 1) % n];
      if (cross(rest[i] - a, c - rest[i]) == 0.0 && dot(rest[i] - a, c - rest[i]) > 0.0) ear = i;
      else if (is_ear(rest, i)) ear = i;
    }
    if (ear == n) break;
    const Vec2 a = rest[(ear + n - 1) % n];
    const Vec2 c = rest[(ear + 1) % n];
    if (cross(rest[ear] - a, c - rest[ear]) > 0.0) parts.push_back({a, rest[ear], c});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  parts.push_back(rest.size() == 3 ? rest : convex_hull(rest));
  return parts;
}

}  // namespace waywright
