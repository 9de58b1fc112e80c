// Body of the kernels; included once for each instruction set. No function of the standard library is called here: an inline one, compiled for
// a wide instruction set, could be the copy that the linker keeps for everyone.
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "waywright/core/lanes/sin_cos.inl"
#include "waywright/planner/tree/lanes/kernels.hpp"

#define WAYWRIGHT_INLINE inline __attribute__((always_inline))

namespace waywright::whale_lanes {
namespace {

#include "waywright/core/lanes/doubles.inl"

static_assert(native <= static_cast<int>(spare) && sizeof(eight_lanes::Doubles) == 8 * spare);

using Words = std::uint64_t __attribute__((vector_size(8 * native)));

WAYWRIGHT_INLINE Doubles all(double x) { return Doubles{} + x; }
WAYWRIGHT_INLINE Words words_of(Doubles x) { return (Words)x; }
WAYWRIGHT_INLINE Doubles absolute(Doubles x) { return (Doubles)(words_of(x) & 0x7FFFFFFFFFFFFFFFULL); }

/// As core/random: number i of a stream, i counted from 0.
class Stream {
 public:
  WAYWRIGHT_INLINE Stream(std::uint64_t counter, std::uint64_t first) {
    for (int k = 0; k < native; ++k) counter_[k] = counter + (first + static_cast<std::uint64_t>(k) + 1) * increment;
  }
  /// The next ones, uniform in [0, 1).
  WAYWRIGHT_INLINE Doubles uniform() {
    Words z = counter_;
    counter_ += increment * static_cast<std::uint64_t>(native);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    z = (z ^ (z >> 31)) >> 11;
#if defined(__AVX512DQ__)
    return (Doubles)_mm512_cvtepu64_pd((__m512i)z) * 0x1.0p-53;
#else
    // The same, exactly: 2^52 + the lower half, and 2^84 + the upper one, as they stand in the bits of doubles.
    const Doubles low = (Doubles)((z & 0xFFFFFFFFULL) | 0x4330000000000000ULL), high = (Doubles)((z >> 32) | 0x4530000000000000ULL);
    return ((high - (0x1.0p84 + 0x1.0p52)) + low) * 0x1.0p-53;
#endif
  }

 private:
  static constexpr std::uint64_t increment = 0x9E3779B97F4A7C15ULL;
  Words counter_{};
};

constexpr double magic = 0x1.8p52;  // adding it leaves the nearest whole number in the last bits

/// e^x for |x| ≤ 700, by 2^k e^r, |r| ≤ ln2/2, Taylor up to r^12: the first term left out is under 2e-16 of the sum.
WAYWRIGHT_INLINE Doubles exponential(Doubles x) {
  const Doubles shifted = x * 1.4426950408889634 + magic, k = shifted - magic;
  const Doubles r = (x - k * 0.6931471803691238) - k * 1.9082149292705877e-10;
  Doubles p = all(1.0 / 479001600.0);  // 1/12!
  p = p * r + 1.0 / 39916800.0;
  p = p * r + 1.0 / 3628800.0;
  p = p * r + 1.0 / 362880.0;
  p = p * r + 1.0 / 40320.0;
  p = p * r + 1.0 / 5040.0;
  p = p * r + 1.0 / 720.0;
  p = p * r + 1.0 / 120.0;
  p = p * r + 1.0 / 24.0;
  p = p * r + 1.0 / 6.0;
  p = p * r + 0.5;
  p = p * r + 1.0;
  p = p * r + 1.0;
  return p * (Doubles)((words_of(shifted) + 1023ULL) << 52);
}

/// cos 2πl for |l| ≤ 1, by ± cos 2πq, |q| ≤ 1/4 exact, Taylor up to the power of 20: the first term left out is under 2e-17.
WAYWRIGHT_INLINE Doubles cosine_of_turns(Doubles l) {
  const Doubles shifted = 2.0 * l + magic;
  const Doubles q = 6.283185307179586 * (l - 0.5 * (shifted - magic));
  const Doubles z = q * q;
  Doubles p = all(1.0 / 2432902008176640000.0);  // 1/20!
  p = p * z - 1.0 / 6402373705728000.0;
  p = p * z + 1.0 / 20922789888000.0;
  p = p * z - 1.0 / 87178291200.0;
  p = p * z + 1.0 / 479001600.0;
  p = p * z - 1.0 / 3628800.0;
  p = p * z + 1.0 / 40320.0;
  p = p * z - 1.0 / 720.0;
  p = p * z + 1.0 / 24.0;
  p = p * z - 0.5;
  p = p * z + 1.0;
  return (Doubles)(words_of(p) ^ (words_of(shifted) << 63));
}

void draw_places(Drawing& d) {
  const double radius = d.radius;
  Stream us{d.counter, 0}, vs{d.counter, d.agents};
  for (std::size_t i = 0; i < d.agents; i += spare) {
    alignas(64) double away[spare], turn[spare];
    for (std::size_t k = 0; k < spare; k += native) {
      store(away + k, radius * root(us.uniform()));
      store(turn + k, 6.283185307179586 * vs.uniform());
    }
    eight_lanes::Doubles r, angle;
    __builtin_memcpy(&r, away, sizeof r);
    __builtin_memcpy(&angle, turn, sizeof angle);
    const eight_lanes::SinCosLanes at = eight_lanes::sin_cos(angle);
    const eight_lanes::Doubles x = r * at.cos, y = r * at.sin;
    __builtin_memcpy(d.x + i, &x, sizeof x);
    __builtin_memcpy(d.y + i, &y, sizeof y);
  }
}

void draw(Drawing& drawing) {
  draw_places(drawing);
  const Drawing d = drawing;
  const std::uint64_t first = 2 * d.agents;
  Stream rs{d.counter, first}, ss{d.counter, first + d.moves}, ps{d.counter, first + 2 * d.moves};
  const double share = d.choice < 1.0 ? d.choice : 1.0;
  const double agents_by_p = share > 0.0 ? static_cast<double>(d.agents) / share : 0.0;
  std::size_t count = 0;
  for (std::size_t m = 0; m < d.moves; m += native) {
    const Doubles r = rs.uniform(), s = ss.uniform(), p = ps.uniform();
    const Mask is_spiral = p >= d.choice;
    const Doubles l = 2.0 * r - 1.0, reach = load(d.reach + m), a = 2.0 * reach * r - reach;
    const Doubles spiral = exponential(lesser(greater(d.spiral * l, all(-700.0)), all(700.0))) * cosine_of_turns(l);
    store(d.factor + m, is_spiral ? spiral : -a);
    store(d.scale + m, is_spiral ? all(1.0) : 2.0 * s);
    if (m >= d.searching) continue;
    alignas(64) double others[native];
    store(others, (p < d.choice) & (absolute(a) >= d.threshold) ? agents_by_p * p : all(-1.0));
    for (int k = 0; k < native; ++k) {  // each is written, and stays where it is one: no branch to guess
      const auto move = static_cast<std::uint32_t>(m) + static_cast<std::uint32_t>(k), other = static_cast<std::uint32_t>(static_cast<std::int32_t>(others[k]));
      d.searches[count] = {move, other < d.agents ? other : static_cast<std::uint32_t>(d.agents - 1)};
      count += (others[k] >= 0.0) & (move < d.searching) ? 1 : 0;
    }
  }
  drawing.searches_count = count;
}

WAYWRIGHT_INLINE double absolute(double x) { return __builtin_fabs(x); }
WAYWRIGHT_INLINE double lesser(double a, double b) { return a < b ? a : b; }
WAYWRIGHT_INLINE double greater(double a, double b) { return a > b ? a : b; }

/// Towards the target and into the square about the disc.
template <class Number>
WAYWRIGHT_INLINE Number moved(Number factor, Number scale, Number target, Number low, Number high, Number x) {
  return lesser(greater(target + factor * absolute(scale * target - x), low), high);
}

void move(const Moving& given) {
  const Moving m = given;
  const double most = m.radius * m.radius;
  const Doubles low = all(-m.radius), high = all(m.radius), leader_x = all(m.leader_x), leader_y = all(m.leader_y);
  for (std::size_t i = 0; i < m.agents; i += native) {
    const Doubles factor = load(m.factor + i), scale = load(m.scale + i);
    Doubles x = moved(factor, scale, leader_x, low, high, load(m.x + i)), y = moved(factor, scale, leader_y, low, high, load(m.y + i));
    const Doubles squared = x * x + y * y;
    if (less_bits(all(most), squared) != 0) {
      const Doubles share = m.radius / root(greater(squared, all(most)));
      x = squared > most ? share * x : x;
      y = squared > most ? share * y : y;
    }
    store(m.new_x + i, x);
    store(m.new_y + i, y);
  }
  for (std::size_t k = 0; k < m.searches_count; ++k) {
    const std::size_t i = m.searches[k].move - m.first, other = m.searches[k].other;
    const bool has_moved = other < i;
    const double factor = m.factor[i], scale = m.scale[i];
    double x = moved(factor, scale, has_moved ? m.new_x[other] : m.x[other], -m.radius, m.radius, m.x[i]);
    double y = moved(factor, scale, has_moved ? m.new_y[other] : m.y[other], -m.radius, m.radius, m.y[i]);
    const double squared = x * x + y * y;
    if (squared > most) {
      const double share = m.radius / __builtin_sqrt(squared);
      x *= share;
      y *= share;
    }
    m.new_x[i] = x;
    m.new_y[i] = y;
  }
}

/// The least of all lanes, in each.
WAYWRIGHT_INLINE Doubles least_of(Doubles v) {
#if defined(__AVX512F__)
  v = lesser(v, __builtin_shuffle(v, Words{4, 5, 6, 7, 0, 1, 2, 3}));
  v = lesser(v, __builtin_shuffle(v, Words{2, 3, 0, 1, 6, 7, 4, 5}));
  return lesser(v, __builtin_shuffle(v, Words{1, 0, 3, 2, 5, 4, 7, 6}));
#elif defined(__AVX__)
  v = lesser(v, __builtin_shuffle(v, Words{2, 3, 0, 1}));
  return lesser(v, __builtin_shuffle(v, Words{1, 0, 3, 2}));
#else
  return lesser(v, __builtin_shuffle(v, Words{1, 0}));
#endif
}

void rank(Ranking& ranking) {
  const Ranking r = ranking;
  const Doubles nowhere = all(__builtin_inf());
  Doubles number{};
  for (int k = 0; k < native; ++k) number[k] = static_cast<double>(k);
  Doubles least = nowhere;
  for (std::size_t i = 0; i < r.agents; i += native, number += static_cast<double>(native)) {
    const Doubles x = load(r.x + i), y = load(r.y + i);
    const Doubles key = number < static_cast<double>(r.agents) ? r.per_radius * root(x * x + y * y) + (r.along_x * x + r.along_y * y) : nowhere;
    store(r.keys + i, key);
    least = lesser(least, key);
  }
  least = least_of(least);
  std::size_t first = 0;
  unsigned found = bits(load(r.keys) == least);
  while (found == 0) {
    first += native;
    found = bits(load(r.keys + first) == least);
  }
  ranking.least = first + static_cast<std::size_t>(__builtin_ctz(found));
}

}  // namespace
}  // namespace waywright::whale_lanes
