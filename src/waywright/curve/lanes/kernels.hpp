// The inner loop of clothoid fits, eight places at a time, compiled for each instruction set: the same bits from all.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace waywright::clothoid_lanes {

/// Of the phase P(t) = A t² + (δ − A) t + φ0 over t in [0, 1].
struct Moments {
  double along = 0.0;         ///< ∫ cos P
  double across = 0.0;        ///< ∫ sin P
  double along_slope = 0.0;   ///< d/dA of both
  double across_slope = 0.0;
};

struct Kernels {
  const char* name;
  /// By 16-point Gauss–Legendre on so many equal panels, ≥ 1; 0: by 8 points on the whole. @pre the phase is under 10⁵ rad
  Moments (*moments)(double a, double delta, double phi0, int panels);
};

/// All that this machine can run, slowest first; the last is the best.
std::span<const Kernels> available();
const Kernels& best();

}  // namespace waywright::clothoid_lanes
