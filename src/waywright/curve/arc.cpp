#include "waywright/curve/arc.hpp"
#include "waywright/core/elementary.hpp"

#include <cmath>

namespace waywright {

double sinc(double x) { return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : sin_cos(x).sin / x; }

CurvePoint evaluate(const Arc& arc, double s) {
  const double half = 0.5 * arc.curvature * s;
  return {arc.start.position() + (s * sinc(half)) * unit(arc.start.heading + half), wrap(arc.start.heading + 2.0 * half),
          arc.curvature, 0.0};
}

CurvePoint evaluate(const Line& line, double s) {
  const Vec2 d = line.to - line.from;
  const double length = norm(d);
  const double t = length > 0.0 ? s / length : 0.0;
  return {line.from + t * d, angle_of(d), 0.0, 0.0};
}

double arc_length(const Line& line) { return distance(line.from, line.to); }

}  // namespace waywright
