// Body of the kernels; included once for each instruction set. Eight doubles are one value: the compiler makes of it as many registers as it
// takes. No function of the standard library is called here: an inline one, compiled for a wide instruction set, could be the copy that the
// linker keeps for everyone.
#include <cstdint>

#include "waywright/curve/gauss.hpp"
#include "waywright/curve/lanes/kernels.hpp"

namespace waywright::clothoid_lanes {
namespace {

using Doubles = double __attribute__((vector_size(64)));
using Bits = std::int64_t __attribute__((vector_size(64)));

inline Doubles all(double x) { return Doubles{x, x, x, x, x, x, x, x}; }
inline Bits bits_of(Doubles x) {
  Bits b;
  __builtin_memcpy(&b, &x, sizeof b);
  return b;
}
inline Doubles doubles_of(Bits b) {
  Doubles x;
  __builtin_memcpy(&x, &b, sizeof x);
  return x;
}

struct SinCosLanes {
  Doubles sin, cos;
};

/// As core/elementary: Cody and Waite's reduction by multiples of π/2, Taylor on [−π/4, π/4].
inline SinCosLanes sin_cos(Doubles x) {
  constexpr double magic = 0x1.8p52;  // adding it leaves the nearest whole number in the last bits
  const Doubles shifted = x * (2.0 / 3.14159265358979323846) + magic;
  const Doubles k = shifted - magic;
  const Bits quadrant = bits_of(shifted);
  const Doubles r = ((x - k * 1.5707963267341256) - k * 6.077100506303966e-11) - k * 2.0222662487959506e-21;
  const Doubles z = r * r;
  Doubles p = all(1.0 / 355687428096000.0);  // 1/17!
  p = p * z - 1.0 / 1307674368000.0;
  p = p * z + 1.0 / 6227020800.0;
  p = p * z - 1.0 / 39916800.0;
  p = p * z + 1.0 / 362880.0;
  p = p * z - 1.0 / 5040.0;
  p = p * z + 1.0 / 120.0;
  p = p * z - 1.0 / 6.0;
  const Bits s = bits_of(r + r * (z * p));
  Doubles q = all(-1.0 / 6402373705728000.0);  // 1/18!
  q = q * z + 1.0 / 20922789888000.0;
  q = q * z - 1.0 / 87178291200.0;
  q = q * z + 1.0 / 479001600.0;
  q = q * z - 1.0 / 3628800.0;
  q = q * z + 1.0 / 40320.0;
  q = q * z - 1.0 / 720.0;
  q = q * z + 1.0 / 24.0;
  const Doubles h = 0.5 * z;
  const Doubles w = 1.0 - h;
  const Bits c = bits_of(w + ((1.0 - w - h) + z * z * q));
  const Bits is_odd = -(quadrant & 1);
  const Bits sin_sign = (quadrant & 2) << 62;
  const Bits cos_sign = ((quadrant + 1) & 2) << 62;
  return {doubles_of(((is_odd & c) | (~is_odd & s)) ^ sin_sign), doubles_of(((is_odd & s) | (~is_odd & c)) ^ cos_sign)};
}

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

}  // namespace
}  // namespace waywright::clothoid_lanes
