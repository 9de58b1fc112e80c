// Elementary functions from additions, multiplications, divisions and square roots alone: the same bits on every processor. The
// system's own differ between processors with and without fused multiply-add.
//
// Errors against the true value: sin_cos under 2 ulp of 1 (1e-15 absolute for |angle| < 1e5), arc_tangent under 2 ulp,
// exponential under 4 ulp. Tested against the system's.
#pragma once

namespace waywright {

struct SinCos {
  double sin, cos;
};
/// Any finite angle in rad; not a number for others.
SinCos sin_cos(double angle);

/// The angle of (x, y) in [−π, π], as atan2 has it, signed zeros and infinities included.
double arc_tangent(double y, double x);

/// e^x; 0 under −708 (no subnormals), +∞ over 709.
double exponential(double x);

}  // namespace waywright
