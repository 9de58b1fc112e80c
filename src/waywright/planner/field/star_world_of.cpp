#include "waywright/planner/field/star_world_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "waywright/planner/field/free_region.hpp"

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

Ring around(const Map& map, Vec2 start, Vec2 goal, double spare) {
  std::vector<Vec2> all{start, goal};
  for (const Ring& ring : map.obstacles) all.insert(all.end(), ring.begin(), ring.end());
  const Box box = bounding_box(all);
  const Vec2 middle = 0.5 * (box.low + box.high);
  const double radius = distance(box.low, box.high) + spare;
  Ring ring;
  for (int i = 0; i < corners_of_no_boundary; ++i) ring.push_back(middle + radius * unit(i * (two_pi / corners_of_no_boundary)));
  return ring;
}

std::optional<Vec2> centre_of(const Ring& ring) {
  const Ring kernel = kernel_of(ring);
  if (kernel.empty()) return std::nullopt;
  return largest_circle_in(kernel).centre;
}

/// Stars that are apart, as they are; empty where there are others.
std::optional<StarWorld> separate_stars(const Ring& boundary, const std::vector<Ring>& obstacles, double grown) {
  const auto middle = centre_of(boundary);
  if (!middle) return std::nullopt;
  StarWorld world{{boundary, *middle, grown, true}, {}};
  if (!(world.outside.least_rim() > 0.0)) return std::nullopt;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const Ring& ring = obstacles[i];
    const double to_boundary = distance_of(ring, boundary, 2.0 * grown);
    const bool is_beyond = std::none_of(ring.begin(), ring.end(), [&](Vec2 p) { return contains(boundary, p); }) && to_boundary > 0.0;
    if (is_beyond) continue;
    if (to_boundary <= 2.0 * grown) return std::nullopt;
    for (std::size_t k = 0; k < i; ++k) {
      if (distance_of(ring, obstacles[k], 2.0 * grown) <= 2.0 * grown || contains(ring, obstacles[k].front()) || contains(obstacles[k], ring.front())) return std::nullopt;
    }
    const auto centre = centre_of(ring);
    if (!centre) return std::nullopt;
    world.obstacles.emplace_back(ring, *centre, grown, false);
  }
  return world;
}

}  // namespace

tl::expected<StarsOrTrees, std::string> stars_or_trees(const PlaneSpace& space, Vec2 start, Vec2 goal, const std::function<bool()>& stops) {
  using tl::unexpected;
  const Map& map = space.problem().world().map();
  if (!map.grids.empty() || !map.lines.empty() || !map.points.empty()) return unexpected<std::string>{"walls, scan points and cells are no stars"};
  if (map.boundaries.size() > 1) return unexpected<std::string>{"there is more than one boundary"};
  const double grown = space.needed();
  const Ring boundary = map.boundaries.empty() ? around(map, start, goal, 4.0 * grown + 1.0) : map.boundaries.front();
  if (auto world = separate_stars(boundary, map.obstacles, grown)) return *std::move(world);
  auto trees = trees_with(space, start, goal, 0.0, stops);
  if (!trees) return unexpected{trees.error()};
  return *std::move(trees);
}

tl::expected<TreeMap, std::string> trees_with(const PlaneSpace& space, Vec2 start, Vec2 goal, double spare, const std::function<bool()>& stops) {
  using tl::unexpected;
  const Map& map = space.problem().world().map();
  const double grown = space.needed() + spare;
  const Ring boundary = map.boundaries.empty() ? around(map, start, goal, 4.0 * grown + 1.0) : map.boundaries.front();
  const auto region = free_region(boundary, map.obstacles, grown, start, stops);
  if (!region) return unexpected{region.error()};
  const auto is_within = [&](const Ring& ring) { return contains(ring, goal); };
  if (!is_within(region->outer) || std::any_of(region->holes.begin(), region->holes.end(), is_within)) {
    return unexpected<std::string>{"start and goal are in areas that are apart: obstacles that are too near to each other or to the boundary, so that the vehicle does not pass, are between them"};
  }
  return TreeMap::of(region->outer, region->holes, stops);
}

std::optional<NearestPolygon> nearest_polygon(const PlaneSpace& space, Vec2 q) {
  const Map& map = space.problem().world().map();
  std::optional<NearestPolygon> best;
  const auto look = [&](const Ring& ring, std::optional<std::size_t> obstacle) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i) least = std::min(least, point_segment_distance(q, ring[i], ring[(i + 1) % ring.size()]));
    if (!best || least - space.needed() < best->distance) best = NearestPolygon{least - space.needed(), obstacle};
  };
  for (const Ring& ring : map.boundaries) look(ring, std::nullopt);
  for (std::size_t i = 0; i < map.obstacles.size(); ++i) look(map.obstacles[i], i);
  return best;
}

double distance_to_polygons(const PlaneSpace& space, Vec2 q) {
  const auto nearest = nearest_polygon(space, q);
  return nearest ? nearest->distance : std::numeric_limits<double>::infinity();
}

}  // namespace waywright
