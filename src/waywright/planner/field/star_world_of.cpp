#include "waywright/planner/field/star_world_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace waywright {
namespace {

constexpr int corners_of_no_boundary = 64;

double distance_of(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double side_a = cross(b - a, c - a), side_b = cross(b - a, d - a), side_c = cross(d - c, a - c), side_d = cross(d - c, b - c);
  if (((side_a > 0.0) != (side_b > 0.0)) && ((side_c > 0.0) != (side_d > 0.0))) return 0.0;
  return std::min({point_segment_distance(a, c, d), point_segment_distance(b, c, d), point_segment_distance(c, a, b), point_segment_distance(d, a, b)});
}

/// m, between the edges of two rings; at least `enough` is as good as any.
double distance_of(const Ring& a, const Ring& b, double enough) {
  const Box ba = bounding_box(a), bb = bounding_box(b);
  const double dx = std::max({0.0, ba.low.x - bb.high.x, bb.low.x - ba.high.x}), dy = std::max({0.0, ba.low.y - bb.high.y, bb.low.y - ba.high.y});
  if (norm({dx, dy}) > enough) return norm({dx, dy});
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) least = std::min(least, distance_of(a[i], a[(i + 1) % a.size()], b[k], b[(k + 1) % b.size()]));
  }
  return least;
}

Ring around(const Map& map, const Problem& problem, double spare) {
  std::vector<Vec2> all{problem.start().position(), problem.goal().position()};
  for (const Ring& ring : map.obstacles) all.insert(all.end(), ring.begin(), ring.end());
  const Box box = bounding_box(all);
  const Vec2 middle = 0.5 * (box.low + box.high);
  const double radius = distance(box.low, box.high) + spare;
  Ring ring;
  for (int i = 0; i < corners_of_no_boundary; ++i) ring.push_back(middle + radius * unit(i * (two_pi / corners_of_no_boundary)));
  return ring;
}

}  // namespace

tl::expected<StarWorld, std::string> star_world(const PlaneSpace& space) {
  using tl::unexpected;
  const Map& map = space.problem().world().map();
  if (!map.grids.empty() || !map.lines.empty() || !map.points.empty()) return unexpected<std::string>{"walls, scan points and cells are no stars"};
  if (map.boundaries.size() > 1) return unexpected<std::string>{"there is more than one boundary"};
  const double grown = space.needed();
  const Ring boundary = map.boundaries.empty() ? around(map, space.problem(), 4.0 * grown + 1.0) : map.boundaries.front();
  const auto centre_of = [](const Ring& ring) -> std::optional<Vec2> {
    const Ring kernel = kernel_of(ring);
    if (kernel.empty()) return std::nullopt;
    return largest_circle_in(kernel).centre;
  };
  const auto middle = centre_of(boundary);
  if (!middle) return unexpected<std::string>{"the boundary is not star-shaped: from no place of it all of it is seen"};
  StarWorld world{{boundary, *middle, grown, true}, {}};
  if (!(world.outside.least_rim() > 0.0)) return unexpected<std::string>{"nothing is left within the boundary"};
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) {
    const Ring& ring = map.obstacles[i];
    const bool is_beyond = std::none_of(ring.begin(), ring.end(), [&](Vec2 p) { return contains(boundary, p); }) && distance_of(ring, boundary, 2.0 * grown) > 0.0;
    if (is_beyond) continue;
    if (distance_of(ring, boundary, 2.0 * grown) <= 2.0 * grown) return unexpected{fmt::format("obstacle {} is within {:.3f} m of the boundary, where the vehicle does not pass: they are no separate stars", i, 2.0 * grown)};
    for (std::size_t k = 0; k < i; ++k) {
      if (distance_of(ring, map.obstacles[k], 2.0 * grown) <= 2.0 * grown)
        return unexpected{fmt::format("obstacles {} and {} are within {:.3f} m of each other, where the vehicle does not pass: they are no separate stars", k, i, 2.0 * grown)};
    }
    const auto centre = centre_of(ring);
    if (!centre) return unexpected{fmt::format("obstacle {} is not star-shaped: from no place of it all of it is seen", i)};
    world.obstacles.emplace_back(ring, *centre, grown, false);
  }
  return world;
}

double RimDistance::at(Vec2 q) const {
  const Map& map = space_.problem().world().map();
  double least = std::numeric_limits<double>::infinity();
  for (const auto* rings : {&map.boundaries, &map.obstacles}) {
    for (const Ring& ring : *rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) least = std::min(least, point_segment_distance(q, ring[i], ring[(i + 1) % ring.size()]));
    }
  }
  return least - space_.needed();
}

}  // namespace waywright
