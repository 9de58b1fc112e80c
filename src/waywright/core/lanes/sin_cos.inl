// Sine and cosine of eight angles side by side, for kernels that are compiled once for each instruction set: eight doubles are one value, of which
// the compiler makes as many registers as it takes. Internal to each file that includes it.
#pragma once

#include <cstdint>

namespace waywright::eight_lanes {
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

}  // namespace
}  // namespace waywright::eight_lanes
