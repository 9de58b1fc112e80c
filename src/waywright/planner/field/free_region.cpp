#include "waywright/planner/field/free_region.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/geometry/convex_partition.hpp"

namespace waywright {
namespace {

constexpr double straight = 1e-9;      // rad, m: less of a turn or an edge is none
constexpr double pointed_up_to = 5.0;  // distances, that a corner is farther out than its circle, where corners are left pointed
constexpr int least_corners = 8, most_corners = 128;

/// A convex ring grown by a distance, at least.
Ring grown(const Ring& convex, double distance) {
  const std::size_t n = convex.size();
  // Pointed corners add none; where the distance is next to nothing they do.
  if (distance * pointed_up_to < free_region_tolerance) {
    Ring ring;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 in = convex[i] - convex[(i + n - 1) % n], out = convex[(i + 1) % n] - convex[i];
      const Vec2 u = (-1.0 / norm(in)) * left_of(in), v = (-1.0 / norm(out)) * left_of(out);
      const double shared = 1.0 + dot(u, v);
      const Vec2 off = (distance / shared) * (u + v);
      if (!(shared > 0.0) || norm(off) > pointed_up_to * distance) break;
      ring.push_back(convex[i] + off);
    }
    if (ring.size() == n) return ring;
  }
  // The circle's polygon touches it from outside: n corners are farther out by distance·(1/cos(π/n) − 1) ≈ distance·π²/2n².
  const int corners = std::clamp(2 * static_cast<int>(std::ceil(0.5 * pi * std::sqrt(0.5 * distance / free_region_tolerance))), least_corners, most_corners);
  const double radius = distance / sin_cos(pi / corners).cos;
  std::vector<Vec2> all;
  for (const Vec2 p : convex) {
    for (int k = 0; k < corners; ++k) all.push_back(p + radius * unit((k + 0.5) * (two_pi / corners)));
  }
  return convex_hull(std::move(all));
}

/// `hair`: m, of which parts are grown by more, each by another share, so that edges that were one, or in one line, lie apart.
bool add_grown(std::vector<Ring>& all, const Ring& ring, double distance, double hair, const std::function<bool()>& stops) {
  const auto more = [&] {
    const double share = 0.6180339887498949 * static_cast<double>(all.size());
    return hair * (1.0 + share - std::floor(share));
  };
  if (is_convex(ring)) {
    all.push_back(grown(ring, distance + more()));
    return true;
  }
  const auto partition = convex_partition(ring, stops);
  if (!partition) return false;
  for (const auto& corners : partition->parts) {
    Ring part;
    for (const std::size_t i : corners) part.push_back(ring[i]);
    all.push_back(grown(part, distance + more()));
  }
  return true;
}

/// A convex ring drawn in; empty where nothing is left.
Ring drawn_in(const Ring& convex, double distance) {
  Ring ring = convex;
  for (std::size_t i = 0; i < convex.size() && !ring.empty(); ++i) {
    const Vec2 along = convex[(i + 1) % convex.size()] - convex[i];
    const Vec2 normal = (1.0 / norm(along)) * left_of(along);
    const auto left = clip_half_plane(ring, normal, dot(normal, convex[i]) + distance);
    ring = left.empty() ? Ring{} : left.front();
  }
  return ring;
}

/// Without corners that hardly turn and edges of next to no length.
Ring without_straight_corners(Ring ring) {
  for (bool is_done = false; !is_done && ring.size() > 3;) {
    is_done = true;
    for (std::size_t i = 0; i < ring.size() && ring.size() > 3; ++i) {
      const std::size_t n = ring.size();
      const Vec2 in = ring[i] - ring[(i + n - 1) % n], out = ring[(i + 1) % n] - ring[i];
      if (norm(in) > straight && std::abs(cross(in, out)) > straight * norm(in) * norm(out)) continue;
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      is_done = false;
      --i;
    }
  }
  return ring;
}

}  // namespace

namespace {

constexpr const char* rounding = "rounding is in the way of the areas that the vehicle's middle must keep out of";

tl::expected<Region, std::string> region_grown(const Ring& boundary, const std::vector<Ring>& obstacles, double distance, double hair, Vec2 at, const std::function<bool()>& stops) {
  using tl::unexpected;
  std::vector<Ring> blocked;
  const Ring hull = convex_hull(boundary);
  if (!is_convex(boundary)) {
    const auto pockets = without(hull, boundary);
    if (!pockets) return unexpected<std::string>{rounding};
    for (const Ring& pocket : *pockets) {
      if (!add_grown(blocked, without_straight_corners(pocket), distance, hair, stops)) return unexpected<std::string>{rounding};
    }
  }
  for (const Ring& ring : obstacles) {
    if (!add_grown(blocked, without_straight_corners(ring), distance, hair, stops)) return unexpected<std::string>{rounding};
  }
  const Ring inside = drawn_in(hull, distance);
  if (inside.size() < 3) return unexpected<std::string>{"nothing is left within the boundary when it is drawn in by what the vehicle needs"};
  auto regions = without(inside, blocked, stops);
  if (stops && stops()) return unexpected<std::string>{"the areas that the vehicle's middle must keep out of were not looked at to the end"};
  if (!regions) return unexpected<std::string>{rounding};
  for (Region& region : *regions) {
    if (!contains(region.outer, at) || std::any_of(region.holes.begin(), region.holes.end(), [&](const Ring& hole) { return contains(hole, at); })) continue;
    Region found{without_straight_corners(std::move(region.outer)), {}};
    for (Ring& hole : region.holes) found.holes.push_back(without_straight_corners(std::move(hole)));
    return found;
  }
  return unexpected<std::string>{"the start is too near to an obstacle: arcs about corners are taken as edges up to half a millimetre farther out"};
}

}  // namespace

tl::expected<Region, std::string> free_region(const Ring& boundary, const std::vector<Ring>& obstacles, double distance, Vec2 at, const std::function<bool()>& stops) {
  // Edges of grown parts may lie on each other but for rounding.
  constexpr double hairs[] = {0.0, 1e-7, 3e-6, 5e-5, 2e-4};  // m
  tl::expected<Region, std::string> found = tl::unexpected<std::string>{rounding};
  for (const double hair : hairs) {
    found = region_grown(boundary, obstacles, distance, hair, at, stops);
    if (found || found.error() != rounding || (stops && stops())) break;
  }
  return found;
}

}  // namespace waywright
