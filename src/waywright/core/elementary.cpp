#include "waywright/core/elementary.hpp"
#include "waywright/core/exponentials.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace waywright {
namespace {

// π/2 and ln 2 in parts: multiples of the first parts by whole numbers under 2^20 are exact.
constexpr double half_pi_1 = 1.5707963267341256;
constexpr double half_pi_2 = 6.077100506303966e-11;
constexpr double half_pi_3 = 2.0222662487959506e-21;
constexpr double ln2_1 = 0.6931471803691238;
constexpr double ln2_2 = 1.9082149292705877e-10;

/// Taylor on [−π/4, π/4]; the first term left out is under 1e-19.
double sin_near_zero(double x) {
  const double z = x * x;
  double p = 1.0 / 355687428096000.0;  // 1/17!
  p = p * z - 1.0 / 1307674368000.0;
  p = p * z + 1.0 / 6227020800.0;
  p = p * z - 1.0 / 39916800.0;
  p = p * z + 1.0 / 362880.0;
  p = p * z - 1.0 / 5040.0;
  p = p * z + 1.0 / 120.0;
  p = p * z - 1.0 / 6.0;
  return x + x * (z * p);
}

double cos_near_zero(double x) {
  const double z = x * x;
  double p = -1.0 / 6402373705728000.0;  // 1/18!
  p = p * z + 1.0 / 20922789888000.0;
  p = p * z - 1.0 / 87178291200.0;
  p = p * z + 1.0 / 479001600.0;
  p = p * z - 1.0 / 3628800.0;
  p = p * z + 1.0 / 40320.0;
  p = p * z - 1.0 / 720.0;
  p = p * z + 1.0 / 24.0;
  const double h = 0.5 * z;
  const double w = 1.0 - h;
  return w + ((1.0 - w - h) + z * z * p);  // what 1 − z/2 lost to rounding is given back
}

struct Parts {
  double high, low;
};
/// atan(i/16) for i = 0…16.
constexpr std::array<Parts, 17> atan_table{{
    {0.0, 0.0},
    {0.06241880999595735, -1.5490756308295046e-18},
    {0.12435499454676144, -3.1253241424539383e-18},
    {0.18534794999569476, 4.180692268843079e-18},
    {0.24497866312686414, 1.0698755618734451e-17},
    {0.3028848683749714, -1.1010827903001369e-17},
    {0.35877067027057225, -2.4623815582638635e-17},
    {0.4124104415973873, -1.587652227770689e-17},
    {0.4636476090008061, 2.2698777452961687e-17},
    {0.5123894603107377, -2.5462781472855804e-17},
    {0.5585993153435624, -5.4556305485916264e-18},
    {0.6022873461349642, 2.950430737228402e-17},
    {0.6435011087932844, 1.5834785051444286e-17},
    {0.6823165548747481, 6.943223671560008e-18},
    {0.7188299996216245, -2.1478388444456983e-17},
    {0.7531512809621944, -2.4256934659182068e-17},
    {0.7853981633974483, 3.061616997868383e-17},
}};

/// atan on [0, 1]: the nearest sixteenth from the table and a short series for the rest.
double atan_unit(double t) {
  const auto index = static_cast<unsigned>(16.0 * t + 0.5);
  const auto i = static_cast<double>(index);
  const double c = i / 16.0;
  const double r = (t - c) / (1.0 + t * c);
  const double z = r * r;
  double p = 1.0 / 11.0;
  p = 1.0 / 9.0 - z * p;
  p = 1.0 / 7.0 - z * p;
  p = 1.0 / 5.0 - z * p;
  p = 1.0 / 3.0 - z * p;
  const Parts& base = atan_table[index];
  return base.high + (r - r * (z * p) + base.low);
}

}  // namespace

SinCos sin_cos(double angle) {
  if (!(std::abs(angle) < 1e5)) {
    if (!std::isfinite(angle)) return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    angle = std::remainder(angle, 6.283185307179586);
  }
  constexpr double magic = 0x1.8p52;  // adding it leaves the nearest whole number in the last bits
  const double shifted = angle * (2.0 / 3.14159265358979323846) + magic;
  const double k = shifted - magic;
  const double r = ((angle - k * half_pi_1) - k * half_pi_2) - k * half_pi_3;
  // No branch: where an angle lies cannot be predicted.
  const auto quadrant = std::bit_cast<std::uint64_t>(shifted);
  const auto s = std::bit_cast<std::uint64_t>(sin_near_zero(r)), c = std::bit_cast<std::uint64_t>(cos_near_zero(r));
  const std::uint64_t swapped = (s ^ c) & (0 - (quadrant & 1));
  return {std::bit_cast<double>((s ^ swapped) ^ ((quadrant & 2) << 62)), std::bit_cast<double>((c ^ swapped) ^ (((quadrant + 1) & 2) << 62))};
}

double arc_tangent(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  constexpr double pi = 3.14159265358979323846;
  constexpr double pi_low = 1.2246467991473532e-16;
  double a = 0.0;
  if (std::isinf(ax) || std::isinf(ay)) {
    a = ax == ay ? 0.25 * pi : ax > ay ? 0.0 : 0.5 * pi;
  } else if (ay > ax) {
    a = 0.5 * pi - (atan_unit(ax / ay) - 0.5 * pi_low);
  } else if (ax > 0.0) {
    a = atan_unit(ay / ax);
  }
  if (std::signbit(x)) a = pi - (a - pi_low);
  return std::signbit(y) ? -a : a;
}

namespace {

// e^x = 2^k e^r, |r| ≤ ln2/2: Taylor, Horner from 1/14!. What is divided by a power of two is multiplied by its inverse: the same bits.
constexpr std::array<double, 14> divisors{14.0, 13.0, 12.0, 11.0, 10.0, 9.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0};
constexpr bool is_power_of_two(double n) { return n == 1.0 || n == 2.0 || n == 4.0 || n == 8.0; }

template <std::size_t width>
void taylor(const std::array<double, width>& r, std::array<double, width>& p) {
  p.fill(1.0);
  const auto step = [&]<std::size_t n>() {
    constexpr double by = divisors[n];
    for (std::size_t i = 0; i < width; ++i) {
      if constexpr (is_power_of_two(by)) p[i] = 1.0 + p[i] * r[i] * (1.0 / by);
      else p[i] = 1.0 + p[i] * r[i] / by;
    }
  };
  [&]<std::size_t... n>(std::index_sequence<n...>) { (step.template operator()<n>(), ...); }(std::make_index_sequence<divisors.size()>{});
}

}  // namespace

double exponential(double x) {
  if (std::isnan(x)) return x;
  if (x > 709.0) return std::numeric_limits<double>::infinity();
  if (x < -708.0) return 0.0;
  const double k = std::floor(x * 1.4426950408889634 + 0.5);
  const double r = (x - k * ln2_1) - k * ln2_2;
  std::array<double, 1> p;
  taylor<1>({r}, p);
  return std::ldexp(p[0], static_cast<int>(k));
}

void exponential_each(std::span<double> values) {
  constexpr std::size_t width = 8;
  std::size_t i = 0;
  for (; i + width <= values.size(); i += width) {
    bool is_plain = true;
    for (std::size_t j = 0; j < width; ++j) is_plain = is_plain && std::abs(values[i + j]) <= 700.0;
    if (!is_plain) {
      for (std::size_t j = 0; j < width; ++j) values[i + j] = exponential(values[i + j]);
      continue;
    }
    std::array<double, width> k, r, p;
    for (std::size_t j = 0; j < width; ++j) {
      k[j] = std::floor(values[i + j] * 1.4426950408889634 + 0.5);
      r[j] = (values[i + j] - k[j] * ln2_1) - k[j] * ln2_2;
    }
    taylor<width>(r, p);
    // Times 2^k: exact, as the product is neither too great nor too small for a plain number.
    for (std::size_t j = 0; j < width; ++j) values[i + j] = p[j] * std::bit_cast<double>(static_cast<std::uint64_t>(static_cast<std::int64_t>(k[j]) + 1023) << 52U);
  }
  for (; i < values.size(); ++i) values[i] = exponential(values[i]);
}

}  // namespace waywright
