#include "waywright/planner/roadmap/tangent_path.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr double least_arc = 0.05;  // m
constexpr double no_turn = 1e-9;    // rad
constexpr double no_way = 1e-9;     // m
constexpr double widest_corner = pi / 3.0;

Vec2 turned(Vec2 v, double angle) {
  const SinCos a = sin_cos(angle);
  return {a.cos * v.x - a.sin * v.y, a.sin * v.x + a.cos * v.y};
}

/// Lines and arcs, with turns on the spot where the course jumps.
class Pencil {
 public:
  explicit Pencil(const Pose& start) : at_{start} {}
  void face(double heading) {
    const double angle = wrap(heading - at_.heading);
    if (std::abs(angle) > no_turn) path_.pieces.push_back({Turn{at_.position(), at_.heading, angle}, 0});
    at_.heading = heading;
  }
  void line(Vec2 to, int direction) {
    if (distance(at_.position(), to) <= no_way) return;
    const double course = angle_of(to - at_.position());
    face(direction > 0 ? course : wrap(course + pi));
    path_.pieces.push_back({Line{at_.position(), to}, direction});
    at_ = make_pose(to, at_.heading);
  }
  void arc(const TangentWay::Bend& bend, double radius) {
    if (std::abs(bend.angle) * radius <= no_way) return;
    const Vec2 begin = bend.center + radius * bend.from;
    line(begin, 1);
    const double course = angle_of(bend.angle > 0.0 ? left_of(bend.from) : -left_of(bend.from));
    face(course);
    path_.pieces.push_back({Arc{make_pose(at_.position(), course), (bend.angle > 0.0 ? 1.0 : -1.0) / radius, std::abs(bend.angle) * radius}, 1});
    at_ = end_pose(path_.pieces.back());
  }
  Path take() { return std::move(path_); }

 private:
  Path path_;
  Pose at_;
};

}  // namespace

bool drives_arcs(const Vehicle& vehicle, double radius) { return radius >= least_arc && 1.0 / radius <= vehicle.max_curvature(); }

std::vector<Vec2> corners_around(const PlaneSpace& space, const TangentWay& way, const TangentGraph& graph) {
  const double radius = graph.radius(), margin = graph.margin();
  std::vector<Vec2> points{way.start};
  std::vector<Vec2> corners;
  const auto is_free = [&](Vec2 from, Vec2 to) {
    Vec2 before = from;
    for (const Vec2 c : corners) {
      if (!space.is_free(before, c, margin)) return false;
      before = c;
    }
    return space.is_free(before, to, margin);
  };
  for (const TangentWay::Bend& bend : way.bends) {
    const Vec2 from = bend.center + radius * bend.from, to = bend.center + radius * turned(bend.from, bend.angle);
    bool is_found = false;
    const int fewest = std::max(1, static_cast<int>(std::ceil(std::abs(bend.angle) / widest_corner)));
    for (int k = fewest; k <= 4 * fewest && !is_found; k *= 2) {
      const double each = bend.angle / k;
      const double out = radius / sin_cos(0.5 * each).cos;
      corners.clear();
      for (int i = 0; i < k; ++i) corners.push_back(bend.center + out * turned(bend.from, each * (i + 0.5)));
      is_found = is_free(from, to);
    }
    if (is_found) {
      points.insert(points.end(), corners.begin(), corners.end());
      continue;
    }
    // A chord over the angle s is r (1 − cos s/2) < r s²/8 nearer to the corner than the arc.
    const double step = std::min(1.0, std::sqrt(8.0 * 0.5 * (radius - margin) / radius));
    const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(bend.angle) / step)));
    for (int i = 0; i <= chords; ++i) points.push_back(bend.center + radius * turned(bend.from, bend.angle * i / chords));
  }
  points.push_back(way.goal);
  return points;
}

Path tangent_path(const PlaneSpace& space, const PlaneEnd& start, const TangentWay& way, const TangentGraph& graph, const PlaneEnd& goal) {
  const Problem& problem = space.problem();
  if (!drives_arcs(problem.vehicle(), graph.radius())) return plane_path(space, start, corners_around(space, way, graph), goal);
  Pencil pencil{problem.start()};
  if (start.run != 0) pencil.line(start.at, start.run);
  for (const TangentWay::Bend& bend : way.bends) pencil.arc(bend, graph.radius());
  pencil.line(way.goal, 1);
  if (goal.run != 0) pencil.line(problem.goal().position(), goal.run);
  if (problem.free_goal() == nullptr) pencil.face(problem.goal().heading);
  return pencil.take();
}

}  // namespace waywright
