// Angles in radians, counter-clockwise from +x (REP 103).
#pragma once

#include <cmath>

namespace waywright {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double two_pi = 2.0 * pi;

/// The same angle in (−π, π].
/// Laws: wrap(wrap(a)) == wrap(a); wrap(a + 2π k) == wrap(a) up to rounding; exact for |a| ≤ π.
inline double wrap(double angle) {
  if (angle > -pi && angle <= pi) return angle;
  const double r = std::remainder(angle, two_pi);
  return r <= -pi ? pi : r;
}

/// Signed turn from `from` to `to` along the shorter arc, in (−π, π].
inline double shorter_turn(double from, double to) { return wrap(to - from); }

}  // namespace waywright
