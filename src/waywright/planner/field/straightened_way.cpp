#include "waywright/planner/field/straightened_way.hpp"

#include <algorithm>

#include "waywright/planner/field/star_world_of.hpp"
#include "waywright/planner/plane/plane_ends.hpp"

namespace waywright {
namespace {

constexpr int rounds = 4;
constexpr double hair = 1e-9;  // m, of what a line keeps

/// Once from the beginning.
std::vector<Vec2> once(const PlaneSpace& space, const std::vector<Vec2>& points) {
  std::vector<double> rooms;
  for (const Vec2 p : points) rooms.push_back(distance_to_polygons(space, p));
  std::vector<Vec2> kept{points.front()};
  for (std::size_t at = 0; at + 1 < points.size();) {
    std::vector<double> least{rooms[at]};  // of the run up to each
    for (std::size_t i = at + 1; i < points.size(); ++i) least.push_back(std::min(least.back(), rooms[i]));
    std::size_t next = points.size() - 1;
    while (next > at + 1 && !space.is_free(points[at], points[next], space.needed() + std::max(0.0, least[next - at] - hair))) --next;
    kept.push_back(points[next]);
    at = next;
  }
  return kept;
}

}  // namespace

std::vector<Vec2> straightened_way(const PlaneSpace& space, std::vector<Vec2> points) {
  for (int round = 0; round < rounds && points.size() > 2; ++round) {
    const std::size_t before = points.size();
    for (int end = 0; end < 2; ++end) {
      points = once(space, points);
      std::reverse(points.begin(), points.end());
    }
    if (points.size() == before) break;
  }
  return points;
}

}  // namespace waywright
