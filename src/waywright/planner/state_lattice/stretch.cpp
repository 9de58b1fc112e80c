#include "waywright/planner/state_lattice/stretch.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/curve/clothoid.hpp"
#include "waywright/curve/clothoid_g2.hpp"

namespace waywright {
namespace {

constexpr double within = 1.0 - 1e-9;  // of a limit: what rounding may add on the way into the path
constexpr double in_line = 1e-12;      // rad

double facing(double course, int direction) { return wrap(direction < 0 ? course + pi : course); }

bool is_straight(const Clothoid& c) { return c.curvature == 0.0 && c.curvature_rate == 0.0; }

/// ∫κ² between two places of a clothoid.
double bend_between(double from, double to, double length) { return length / 3.0 * (from * from + from * to + to * to); }

Pose end_of(const Clothoid& c) { return make_pose(evaluate(c, c.length).position, wrap(course_at(c, c.length))); }

}  // namespace

double length_of(const LatticeStretch& stretch) {
  double sum = 0.0;
  for (const Clothoid& c : stretch.curves) sum += c.length;
  return sum;
}

double bend_of(const LatticeStretch& stretch) {
  double sum = 0.0;
  for (const Clothoid& c : stretch.curves) sum += bend_between(c.curvature, end_curvature(c), c.length);
  return sum;
}

Pose start_of(const LatticeStretch& stretch) {
  if (stretch.direction == 0) return make_pose(stretch.turn.at, wrap(stretch.turn.from));
  const Pose& p = stretch.curves.front().start;
  return make_pose(p.position(), facing(p.heading, stretch.direction));
}

Pose end_of(const LatticeStretch& stretch) {
  if (stretch.direction == 0) return make_pose(stretch.turn.at, wrap(stretch.turn.from + stretch.turn.angle));
  const Pose p = end_of(stretch.curves.back());
  return make_pose(p.position(), facing(p.heading, stretch.direction));
}

LatticeStretch placed(const LatticeStretch& stretch, const Frame& frame) {
  LatticeStretch there = stretch;
  for (Clothoid& c : there.curves) c.start = frame.to_world(c.start);
  there.turn.at = frame.to_world(stretch.turn.at);
  there.turn.from = wrap(stretch.turn.from + frame.heading());
  return there;
}

Path path_of(const std::vector<LatticeStretch>& stretches) {
  Path path;
  const auto add_line = [&](Vec2 from, Vec2 to, int direction) {
    if (!path.pieces.empty() && path.pieces.back().direction == direction) {
      if (auto* before = std::get_if<Line>(&path.pieces.back().curve)) {
        const Vec2 way = before->to - before->from, more = to - before->to;
        if (std::abs(cross(way, more)) <= in_line * norm(way) * norm(more) && dot(way, more) > 0.0) {
          before->to = to;
          return;
        }
      }
    }
    path.pieces.push_back({Line{from, to}, direction});
  };
  for (const LatticeStretch& stretch : stretches) {
    if (stretch.direction == 0) {
      if (stretch.turn.angle != 0.0) path.pieces.push_back({stretch.turn, 0});
      continue;
    }
    for (const Clothoid& c : stretch.curves) {
      if (is_straight(c)) {
        add_line(c.start.position(), evaluate(c, c.length).position, stretch.direction);
      } else {
        path.pieces.push_back({c, stretch.direction});
      }
    }
  }
  return path;
}

bool are_within(const std::vector<Clothoid>& curves, const BendLimits& limits) {
  return std::all_of(curves.begin(), curves.end(), [&](const Clothoid& c) {
    return greatest_curvature(c) <= within * limits.curvature && std::abs(c.curvature_rate) <= within * limits.curvature_rate;
  });
}

std::vector<Clothoid> fitted_within(const Pose& from, double from_curvature, const Pose& to, double to_curvature, const BendLimits& limits) {
  const Vec2 chord = to.position() - from.position();
  const double far = norm(chord);
  if (!(far > 0.0)) return {};
  if (from_curvature == 0.0 && to_curvature == 0.0 && std::abs(wrap(angle_of(chord) - from.heading)) <= in_line && std::abs(wrap(to.heading - from.heading)) <= in_line) {
    return {Clothoid{from, 0.0, 0.0, far}};
  }
  const auto triple = fit_clothoids({from, from_curvature}, {to, to_curvature});
  if (!triple) return {};
  std::vector<Clothoid> curves(triple->begin(), triple->end());
  double sum = 0.0;
  for (const Clothoid& c : curves) sum += c.length;
  if (!(sum <= longest_fit * far) || !are_within(curves, limits)) return {};
  return curves;
}

void sample_stretch(const LatticeStretch& stretch, double step, double turn_step, std::vector<SteppedPose>& poses) {
  if (stretch.direction == 0) {
    const int n = std::max(1, static_cast<int>(std::ceil(std::abs(stretch.turn.angle) / turn_step)));
    for (int i = 0; i <= n; ++i) {
      poses.push_back({make_pose(stretch.turn.at, wrap(stretch.turn.from + stretch.turn.angle * i / n)), 0.0, i == 0 ? 0.0 : std::abs(stretch.turn.angle) / n, 0.0});
    }
    return;
  }
  poses.push_back({start_of(stretch), 0.0, 0.0, 0.0});
  std::vector<Pose> courses;
  for (const Clothoid& c : stretch.curves) {
    const double sharpest = greatest_curvature(c);
    const int n = std::max(1, static_cast<int>(std::ceil(std::max(c.length / step, sharpest * c.length / turn_step))));
    const double way = c.length / n;
    courses.clear();
    sample_clothoid(c, way, way, static_cast<std::size_t>(n - 1), courses);
    courses.push_back(end_of(c));
    for (int i = 0; i < n; ++i) {
      const Pose& p = courses[static_cast<std::size_t>(i)];
      const double from = c.curvature + c.curvature_rate * way * i;
      poses.push_back({make_pose(p.position(), facing(p.heading, stretch.direction)), way, sharpest * way, bend_between(from, from + c.curvature_rate * way, way)});
    }
  }
}

}  // namespace waywright
