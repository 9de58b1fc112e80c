#include "waywright/planner/roadmap/path_pencil.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double no_turn = 5e-7;  // rad, half of what joints may be off by
constexpr double no_way = 1e-9;   // m
constexpr int most_chords = 4096;

}  // namespace

void PathPencil::face(double heading) {
  const double angle = wrap(heading - at_.heading);
  if (std::abs(angle) > no_turn) path_.pieces.push_back({Turn{at_.position(), at_.heading, angle}, 0});
  at_.heading = heading;
}

void PathPencil::line(Vec2 to, int direction) {
  if (distance(at_.position(), to) <= no_way) return;
  const double course = angle_of(to - at_.position());
  face(direction > 0 ? course : wrap(course + pi));
  path_.pieces.push_back({Line{at_.position(), to}, direction});
  at_ = make_pose(to, at_.heading);
}

void PathPencil::curve(Vec2 control, Vec2 to) {
  face(angle_of(control - at_.position()));
  BezierSpan span;
  span.degree = 2;
  span.control[0] = at_.position();
  span.control[1] = control;
  span.control[2] = to;
  path_.pieces.push_back({Spline{SplineKind::quintic, {span}}, 1});
  at_ = make_pose(to, angle_of(to - control));
}

double greatest_curvature(Vec2 from, Vec2 control, Vec2 to) {
  const Vec2 first = 2.0 * (control - from), second = 2.0 * (to - 2.0 * control + from);
  const double bend = std::abs(cross(first, second));  // the same all along
  if (!(bend > 0.0)) return 0.0;
  const double u = std::clamp(-dot(first, second) / squared_norm(second), 0.0, 1.0);
  const double slowest = norm(first + u * second);
  return slowest > 0.0 ? bend / (slowest * slowest * slowest) : std::numeric_limits<double>::infinity();
}

void add_chords(Vec2 from, Vec2 control, Vec2 to, double sagitta, std::vector<Vec2>& points) {
  // Over 1/n of u the curve leaves its chord by |second| / 8n² at most.
  const double second = norm(2.0 * (to - 2.0 * control + from));
  const int chords = std::clamp(static_cast<int>(std::ceil(std::sqrt(second / (8.0 * sagitta)))), 1, most_chords);
  for (int i = 1; i < chords; ++i) {
    const double u = static_cast<double>(i) / chords, v = 1.0 - u;
    points.push_back(v * v * from + 2.0 * u * v * control + u * u * to);
  }
  points.push_back(to);
}

}  // namespace waywright
