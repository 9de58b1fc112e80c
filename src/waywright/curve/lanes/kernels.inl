// Body of the kernels; included once for each instruction set. Eight doubles are one value: the compiler makes of it as many registers as it
// takes. No function of the standard library is called here: an inline one, compiled for a wide instruction set, could be the copy that the
// linker keeps for everyone.
#include <cstdint>

#include "waywright/curve/gauss.hpp"
#include "waywright/curve/lanes/kernels.hpp"
#include "waywright/core/lanes/sin_cos.inl"

namespace waywright::clothoid_lanes {
namespace {

using eight_lanes::all;
using eight_lanes::Doubles;
using eight_lanes::sin_cos;
using eight_lanes::SinCosLanes;

/// In a fixed order.
inline double sum(Doubles x) { return ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7])); }

struct Sums {
  Doubles along = all(0.0), across = all(0.0), along_slope = all(0.0), across_slope = all(0.0);
  void add(Doubles t, Doubles weight, double a, double delta, double phi0) {
    const SinCosLanes p = sin_cos(phi0 + t * ((delta - a) + a * t));
    const Doubles bulge = t * t - t;
    const Doubles c = weight * p.cos, s = weight * p.sin;
    along += c;
    across += s;
    along_slope -= s * bulge;
    across_slope += c * bulge;
  }
};

Moments moments(double a, double delta, double phi0, int panels) {
  constexpr auto& n = gauss_16.node;
  constexpr auto& v = gauss_16.weight;
  Sums sums;
  if (panels == 0) {
    constexpr auto& m = gauss_8.node;
    constexpr auto& w = gauss_8.weight;
    sums.add(0.5 + 0.5 * Doubles{-m[3], -m[2], -m[1], -m[0], m[0], m[1], m[2], m[3]}, 0.5 * Doubles{w[3], w[2], w[1], w[0], w[0], w[1], w[2], w[3]}, a, delta, phi0);
  }
  const Doubles node{n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7]};
  const Doubles weight{v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]};
  for (int i = 0; i < panels; ++i) {
    const double half = 0.5 / panels;
    const double middle = (2.0 * i + 1.0) * half;
    sums.add(middle - half * node, half * weight, a, delta, phi0);
    sums.add(middle + half * node, half * weight, a, delta, phi0);
  }
  return {sum(sums.along), sum(sums.across), sum(sums.along_slope), sum(sums.across_slope)};
}

inline Doubles loaded(const double* from) {
  Doubles v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}

/// Of eight problems, lane by lane: moments and their first two derivatives after A.
struct Derivatives {
  Doubles along{}, across{}, along_1{}, across_1{}, along_2{}, across_2{};
};

template <std::size_t n>
inline Derivatives integrate(const GaussHalf<n>& rule, int panels, Doubles a, Doubles delta, Doubles phi0) {
  Derivatives m;
  const double half = 0.5 / panels;
  for (int panel = 0; panel < panels; ++panel) {
    const double middle = (2.0 * panel + 1.0) * half;
    for (std::size_t i = 0; i < 2 * n; ++i) {
      const double t = i < n ? middle - half * rule.node[i] : middle + half * rule.node[i - n];
      const double weight = half * rule.weight[i < n ? i : i - n];
      const SinCosLanes p = sin_cos(phi0 + t * ((delta - a) + a * t));
      const double bulge = t * t - t;
      m.along += weight * p.cos;
      m.across += weight * p.sin;
      m.along_1 -= weight * bulge * p.sin;
      m.across_1 += weight * bulge * p.cos;
      m.along_2 -= weight * bulge * bulge * p.cos;
      m.across_2 -= weight * bulge * bulge * p.sin;
    }
  }
  return m;
}

inline double magnitude(double x) { return x < 0.0 ? -x : x; }

/// Halley's method: the error is cubed. The first look may be coarse: 8 points on a panel of 8 rad are off by 1e-8.
void fit(Fits& fits, double widest, double least_share) {
  constexpr int most_steps = 12;
  constexpr double near_root = 1e-5;  // of ∫ sin P and of A, from where one more step is enough
  const Doubles delta = loaded(fits.delta), phi0 = loaded(fits.phi0);
  bool is_open[width];
  for (int k = 0; k < width; ++k) {
    is_open[k] = true;
    fits.solved[k] = false;
  }
  int open = width;
  for (int step = 0; step < most_steps && open > 0; ++step) {
    const Doubles a = loaded(fits.a);
    double turning = 0.0;  // greatest slope of a phase that is looked at
    for (int k = 0; k < width; ++k) {
      const double own = magnitude(fits.delta[k]) + magnitude(fits.a[k]);
      if (is_open[k] && own > turning) turning = own;
    }
    const int panels = 1 + static_cast<int>(turning / 8.0);
    const bool is_exact = step > 0 || turning <= 1.0;
    const Derivatives m = turning <= 1.0 || step == 0 ? integrate(gauss_8, panels, a, delta, phi0) : integrate(gauss_16, panels, a, delta, phi0);
    const Doubles by = -2.0 * m.across * m.across_1 / (2.0 * m.across_1 * m.across_1 - m.across * m.across_2);
    const Doubles next = a + by;
    const Doubles share = m.along + by * (m.along_1 + 0.5 * by * m.along_2);
    for (int k = 0; k < width; ++k) {
      if (!is_open[k]) continue;
      const bool is_lost = !(magnitude(next[k]) <= widest);  // or not a number
      const bool is_there = is_exact && magnitude(m.across[k]) <= near_root && magnitude(by[k]) <= near_root;
      fits.a[k] = is_lost ? 0.0 : next[k];
      if (!is_lost && !is_there) continue;
      is_open[k] = false;
      --open;
      fits.share[k] = share[k];
      fits.solved[k] = !is_lost && share[k] >= least_share;
    }
  }
}

/// From the middle of each step, where the course is θ: with B = κh/2 and c = κ′h²/8 the way is h R(θ) ½∫ (cos, sin)(Bx + cx²) dx over [−1, 1],
/// the integrals by their series in B and c.
inline void add_steps_by_series(double heading, double curvature, double rate, Doubles begin, double h, Steps& out) {
  const Doubles s = begin + 0.5 * h;
  const Doubles b = (0.5 * h) * (curvature + rate * s);
  const double c = 0.125 * rate * h * h, cc = c * c;
  const Doubles bb = b * b;
  const Doubles along = 1.0 - 0.1 * cc + cc * cc / 216.0 + bb * (-1.0 / 6.0 + cc / 28.0 + bb * (1.0 / 120.0 - cc / 432.0 - bb * (1.0 / 5040.0)));
  const Doubles across = c * ((1.0 / 3.0 - cc / 42.0) + bb * (-0.1 + cc / 108.0 + bb * (1.0 / 168.0 - bb * (1.0 / 6480.0))));
  const SinCosLanes p = sin_cos(heading + s * (curvature + 0.5 * rate * s));
  const Doubles dx = h * (p.cos * along - p.sin * across), dy = h * (p.sin * along + p.cos * across);
  __builtin_memcpy(out.dx, &dx, sizeof dx);
  __builtin_memcpy(out.dy, &dy, sizeof dy);
}

template <std::size_t n>
inline void add_steps(const GaussHalf<n>& rule, double heading, double curvature, double rate, Doubles begin, double h, Steps& out) {
  Doubles dx{}, dy{};
  const double half = 0.5 * h;
  const Doubles middle = begin + half;
  for (std::size_t i = 0; i < n; ++i) {
    for (const double side : {-1.0, 1.0}) {
      const Doubles s = middle + side * half * rule.node[i];
      const SinCosLanes p = sin_cos(heading + s * (curvature + 0.5 * rate * s));
      dx += rule.weight[i] * p.cos;
      dy += rule.weight[i] * p.sin;
    }
  }
  dx *= all(half);
  dy *= all(half);
  __builtin_memcpy(out.dx, &dx, sizeof dx);
  __builtin_memcpy(out.dy, &dy, sizeof dy);
}

void steps(double heading, double curvature, double rate, double s0, double h, int points, Steps& out) {
  const Doubles begin = s0 + h * Doubles{0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0};
  switch (points) {
    case 0: return add_steps_by_series(heading, curvature, rate, begin, h, out);
    case 6: return add_steps(gauss_6, heading, curvature, rate, begin, h, out);
    case 8: return add_steps(gauss_8, heading, curvature, rate, begin, h, out);
    default: return add_steps(gauss_16, heading, curvature, rate, begin, h, out);
  }
}

}  // namespace
}  // namespace waywright::clothoid_lanes
