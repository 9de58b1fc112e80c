// Rigid transforms of maps, given or found from pairs of points.
#include <fmt/format.h>

#include <cmath>

#include "waywright/io/map_io.hpp"
#include "waywright/core/elementary.hpp"

namespace waywright {

void transform(Map& map, const Pose& pose) {
  const Frame frame{pose};
  for (Ring& ring : map.boundaries) ring = transformed(ring, frame);
  for (Ring& ring : map.obstacles) ring = transformed(ring, frame);
  for (Polyline& line : map.lines) line = transformed(line, frame);
  map.points = transformed(map.points, frame);
  for (CellGrid& grid : map.grids) grid.origin = frame.to_world(grid.origin);
}

Parsed<Alignment> align(const std::vector<Vec2>& from, const std::vector<Vec2>& to) {
  const auto refuse = [](std::string problem) {
    return tl::unexpected{InputError{"", "align", std::move(problem), "at least two pairs of different points"}};
  };
  if (from.size() != to.size() || from.size() < 2) return refuse(fmt::format("{} pairs of points", from.size()));
  Vec2 a{}, b{};
  const double n = static_cast<double>(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    a = a + (1.0 / n) * from[i];
    b = b + (1.0 / n) * to[i];
  }
  // In the plane Umeyama's rotation is the angle of the summed products of centred points.
  double cosine = 0.0;
  double sine = 0.0;
  double spread = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    cosine += dot(from[i] - a, to[i] - b);
    sine += cross(from[i] - a, to[i] - b);
    spread += squared_norm(from[i] - a);
  }
  if (!(spread > 1e-12) || !(norm({cosine, sine}) > 1e-12)) return refuse("the points coincide");
  const double angle = arc_tangent(sine, cosine);
  const Vec2 shift = b - Frame{make_pose({}, angle)}.rotate(a);
  Alignment alignment;
  alignment.transform = make_pose(shift, wrap(angle));
  const Frame frame{alignment.transform};
  for (std::size_t i = 0; i < from.size(); ++i) alignment.residuals.push_back(distance(frame.to_world(from[i]), to[i]));
  return alignment;
}

}  // namespace waywright
