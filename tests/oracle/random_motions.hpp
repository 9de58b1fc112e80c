// Vehicles, worlds and motions drawn at random, for the proof's tests.
#pragma once

#include "waywright/core/random.hpp"
#include "waywright/curve/bezier.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright::random_motions {

inline Vehicle forklift() {
  Vehicle v;
  v.footprint.polygon = rectangle({-2.30, -0.45}, {0.40, 0.45});
  v.drive = Tricycle{1.9, 1.0, std::nullopt, SteeredAxle::rear};
  v.limits.curvature = 0.8;
  return v;
}

inline Vehicle mecanum_base() {
  Vehicle v;
  v.drive = Mecanum{0.05, 0.24, 0.15};
  return v;
}

/// An L: not convex, so that the proof has to work on parts.
inline Ring l_shape() { return {{-1.5, -0.6}, {0.8, -0.6}, {0.8, 0.0}, {-0.5, 0.0}, {-0.5, 0.6}, {-1.5, 0.6}}; }

struct Clutter {
  int boxes = 0, points = 0, lines = 0, grids = 0;
};

inline Map random_map(Random& random, const Clutter& clutter) {
  Map map;
  for (int i = 0; i < clutter.boxes; ++i) {
    const Vec2 half{random.uniform(0.1, 0.8), random.uniform(0.1, 0.8)};
    const Pose at{random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-pi, pi)};
    map.obstacles.push_back(transformed(rectangle(-half, half), Frame{at}));
  }
  for (int i = 0; i < clutter.points; ++i) map.points.push_back({random.uniform(-6, 6), random.uniform(-6, 6)});
  for (int i = 0; i < clutter.lines; ++i) {
    const Vec2 from{random.uniform(-6, 6), random.uniform(-6, 6)};
    const Vec2 to = from + random.uniform(0.1, 3.0) * unit(random.uniform(-pi, pi));
    map.lines.push_back({from, to, to + random.uniform(0.1, 1.0) * unit(random.uniform(-pi, pi))});
  }
  for (int i = 0; i < clutter.grids; ++i) {
    CellGrid grid{"grid", 8, 6, random.uniform(0.05, 0.3), {random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-pi, pi)}, {}, false};
    for (int k = 0; k < grid.columns * grid.rows; ++k) grid.blocked.push_back(random.uniform() < 0.3 ? 1 : 0);
    map.grids.push_back(std::move(grid));
  }
  return map;
}

inline Curve random_curve(Random& random, const Pose& from) {
  const double kind = random.uniform();
  if (kind < 0.2) return Line{from.position(), from.position() + random.uniform(0.2, 4.0) * unit(from.heading)};
  if (kind < 0.35) return Clothoid{from, random.uniform(-0.8, 0.8), random.uniform(-0.6, 0.6), random.uniform(0.2, 4.0)};
  if (kind < 0.5) return Arc{from, random.uniform(-0.8, 0.8), random.uniform(0.2, 4.0)};
  const Pose to{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-pi, pi)};
  const double d = distance(from.position(), to.position()) * random.uniform(0.6, 1.6) + 0.1;
  if (kind < 0.8) return Spline{SplineKind::quintic, {straight_ended_quintic(from.position(), d * unit(from.heading), to.position(), d * unit(to.heading))}};
  return Spline{SplineKind::natural_cubic, {cubic_hermite(from.position(), d * unit(from.heading), to.position(), d * unit(to.heading))}};
}

inline Path random_path(Random& random) {
  Path path;
  Pose at{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-pi, pi)};
  const int direction = random.uniform() < 0.5 ? 1 : -1;
  for (int i = 0; i < 2; ++i) {
    path.pieces.push_back({random_curve(random, at), direction});
    const Pose end = end_pose(path.pieces.back());
    at = make_pose(end.position(), direction > 0 ? end.heading : wrap(end.heading + pi));
  }
  return path;
}

/// Lines and arcs in a row, the vehicle's heading going its own way along them; corners between some.
inline Path random_sliding_path(Random& random) {
  Path path;
  Pose at{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-pi, pi)};
  double heading = random.uniform(-pi, pi);
  for (int i = 0; i < 3; ++i) {
    if (random.uniform() < 0.3) at.heading = random.uniform(-pi, pi);
    const double length = random.uniform(0.2, 3.0), turn = random.uniform() < 0.3 ? 0.0 : random.uniform(-6.0 * pi, 6.0 * pi) * random.uniform();
    Piece piece{Line{at.position(), at.position() + length * unit(at.heading)}, 1, HeadingAlong{heading, turn}};
    if (random.uniform() < 0.6) piece.curve = Arc{at, random.uniform(-1.5, 1.5), length};
    path.pieces.push_back(piece);
    heading = wrap(heading + turn);
    const Pose end = end_pose(Piece{piece.curve, 1, {}});  // facing along, for the course
    at = make_pose(end.position(), end.heading);
  }
  return path;
}

inline Footprint random_footprint(Random& random) {
  Footprint footprint;
  const double kind = random.uniform();
  if (kind < 0.5) footprint = forklift().footprint;
  else if (kind < 0.8) footprint.polygon = l_shape();
  else footprint.disc = random.uniform(0.0, 0.8);
  return footprint;
}

inline Problem problem_for(const Map& map, const Path& path, const Footprint& footprint, Vehicle vehicle = forklift()) {
  Scenario s;
  s.map = map;
  s.vehicle = std::move(vehicle);
  s.vehicle.footprint = footprint;
  s.start = start_pose(path);
  s.mission = end_pose(path);
  return Problem::prepare(s).value();
}

}  // namespace waywright::random_motions
