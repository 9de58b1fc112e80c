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

inline constexpr int width = 8;

/// Eight Hermite problems side by side.
struct alignas(64) Fits {
  double delta[width], phi0[width];
  double a[width];      ///< first guesses; roots
  double share[width];  ///< chord over length there
  bool solved[width];
};

/// Of a clothoid, the way from s0 + j h to s0 + (j + 1) h for j = 0…7.
struct alignas(64) Steps {
  double dx[width], dy[width];
};

struct Kernels {
  const char* name;
  /// By 16-point Gauss–Legendre on so many equal panels, ≥ 1; 0: by 8 points on the whole. @pre the phase is under 10⁵ rad
  Moments (*moments)(double a, double delta, double phi0, int panels);
  /// Newton's method on each; those that it does not lead to a root within |a| ≤ widest are not solved.
  void (*fit)(Fits&, double widest, double least_share);
  /// By 6, 8 or 16 points; 0: by a series, for h that turn by no more than 0.18 and change their turning by no more than 0.008 rad.
  /// @pre phases under 10⁵ rad
  void (*steps)(double heading, double curvature, double rate, double s0, double h, int points, Steps&);
};

/// All that this machine can run, slowest first; the last is the best.
std::span<const Kernels> available();
const Kernels& best();

}  // namespace waywright::clothoid_lanes
