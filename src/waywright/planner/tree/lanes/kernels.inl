// Body of the kernels; included once for each instruction set. No function of the standard library is called here: an inline one, compiled for
// a wide instruction set, could be the copy that the linker keeps for everyone.
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "waywright/planner/tree/lanes/kernels.hpp"

#define WAYWRIGHT_INLINE inline __attribute__((always_inline))

namespace waywright::whale_lanes {
namespace {

#if defined(__AVX512F__)
constexpr int native = 16;
#elif defined(__AVX__)
constexpr int native = 8;
#else
constexpr int native = 4;
#endif
static_assert(native <= static_cast<int>(spare));

using Floats = float __attribute__((vector_size(4 * native)));
using Ints = std::int32_t __attribute__((vector_size(4 * native)));
using Words = std::uint64_t __attribute__((vector_size(4 * native)));

WAYWRIGHT_INLINE Floats all(float x) { return Floats{} + x; }
WAYWRIGHT_INLINE Floats absolute(Floats x) { return (Floats)((Ints)x & 0x7FFFFFFF); }
WAYWRIGHT_INLINE Floats load(const float* from) {
  Floats v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
WAYWRIGHT_INLINE Ints load(const std::int32_t* from) {
  Ints v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
WAYWRIGHT_INLINE void store(float* to, Floats v) { __builtin_memcpy(to, &v, sizeof v); }
WAYWRIGHT_INLINE void store(std::int32_t* to, Ints v) { __builtin_memcpy(to, &v, sizeof v); }
// What `a < b ? a : b` and `a > b ? a : b` give, in one instruction where the processor's is just that.
WAYWRIGHT_INLINE Floats lesser(Floats a, Floats b) {
#if defined(__AVX512F__)
  return (Floats)_mm512_min_ps((__m512)a, (__m512)b);
#elif defined(__AVX__)
  return (Floats)_mm256_min_ps((__m256)a, (__m256)b);
#elif defined(__SSE2__)
  return (Floats)_mm_min_ps((__m128)a, (__m128)b);
#else
  return a < b ? a : b;
#endif
}
WAYWRIGHT_INLINE Floats greater(Floats a, Floats b) {
#if defined(__AVX512F__)
  return (Floats)_mm512_max_ps((__m512)a, (__m512)b);
#elif defined(__AVX__)
  return (Floats)_mm256_max_ps((__m256)a, (__m256)b);
#elif defined(__SSE2__)
  return (Floats)_mm_max_ps((__m128)a, (__m128)b);
#else
  return a > b ? a : b;
#endif
}
/// Bit i: a ≤ b in lane i; false of what is not a number.
WAYWRIGHT_INLINE unsigned not_greater_bits(Floats a, Floats b) {
#if defined(__AVX512F__)
  return _mm512_cmp_ps_mask((__m512)a, (__m512)b, _CMP_LE_OQ);
#elif defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps((__m256)a, (__m256)b, _CMP_LE_OQ)));
#elif defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps((__m128)a, (__m128)b)));
#else
  unsigned out = 0;
  for (int k = 0; k < native; ++k) out |= (a[k] <= b[k] ? 1U : 0U) << k;
  return out;
#endif
}
/// The least of all lanes, in each.
WAYWRIGHT_INLINE Floats least_of(Floats v) {
#if defined(__AVX512F__)
  v = lesser(v, __builtin_shuffle(v, Ints{8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7}));
  v = lesser(v, __builtin_shuffle(v, Ints{4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11}));
  v = lesser(v, __builtin_shuffle(v, Ints{2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14, 15, 12, 13}));
  return lesser(v, __builtin_shuffle(v, Ints{1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14}));
#elif defined(__AVX__)
  v = lesser(v, __builtin_shuffle(v, Ints{4, 5, 6, 7, 0, 1, 2, 3}));
  v = lesser(v, __builtin_shuffle(v, Ints{2, 3, 0, 1, 6, 7, 4, 5}));
  return lesser(v, __builtin_shuffle(v, Ints{1, 0, 3, 2, 5, 4, 7, 6}));
#else
  v = lesser(v, __builtin_shuffle(v, Ints{2, 3, 0, 1}));
  return lesser(v, __builtin_shuffle(v, Ints{1, 0, 3, 2}));
#endif
}
/// Is a < b in any lane?
WAYWRIGHT_INLINE bool is_any_less(Floats a, Floats b) {
#if defined(__AVX512F__)
  return _mm512_cmp_ps_mask((__m512)a, (__m512)b, _CMP_LT_OQ) != 0;
#elif defined(__AVX__)
  return _mm256_movemask_ps(_mm256_cmp_ps((__m256)a, (__m256)b, _CMP_LT_OQ)) != 0;
#elif defined(__SSE2__)
  return _mm_movemask_ps(_mm_cmplt_ps((__m128)a, (__m128)b)) != 0;
#else
  const Ints less = a < b;
  std::int32_t is_any = 0;
  for (int k = 0; k < native; ++k) is_any |= less[k];
  return is_any != 0;
#endif
}
/// Correctly rounded, as IEEE has it.
WAYWRIGHT_INLINE Floats root(Floats a) {
#if defined(__AVX512F__)
  return (Floats)_mm512_sqrt_ps((__m512)a);
#elif defined(__AVX__)
  return (Floats)_mm256_sqrt_ps((__m256)a);
#elif defined(__SSE2__)
  return (Floats)_mm_sqrt_ps((__m128)a);
#else
  Floats v;
  for (int k = 0; k < native; ++k) v[k] = __builtin_sqrtf(a[k]);
  return v;
#endif
}

/// As core/random: the halves of its words, from word `first` on.
class Stream {
 public:
  WAYWRIGHT_INLINE Stream(std::uint64_t counter, std::uint64_t first) {
    for (int k = 0; k < native / 2; ++k) counter_[k] = counter + (first + static_cast<std::uint64_t>(k) + 1) * increment;
  }
  /// The next ones, uniform in [0, 1).
  WAYWRIGHT_INLINE Floats uniform() {
    Words z = counter_;
    counter_ += increment * static_cast<std::uint64_t>(native / 2);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    z = z ^ (z >> 31);
    using Halves = std::uint32_t __attribute__((vector_size(4 * native)));
    return __builtin_convertvector((Ints)((Halves)z >> 8), Floats) * 0x1.0p-24F;
  }

 private:
  static constexpr std::uint64_t increment = 0x9E3779B97F4A7C15ULL;
  Words counter_{};
};

constexpr float magic = 0x1.8p23F;  // adding it leaves the nearest whole number in the last bits

/// e^x for |x| ≤ 80, by 2^k e^r, |r| ≤ ln2/2, Taylor up to r^7: the first term left out is under 6e-9 of the sum.
WAYWRIGHT_INLINE Floats exponential(Floats x) {
  const Floats shifted = x * 1.44269504F + magic, k = shifted - magic;
  const Floats r = (x - k * 0.693145752F) - k * 1.42860677e-6F;  // the first factor has sixteen bits: exact
  Floats p = all(1.0F / 5040.0F);
  p = p * r + 1.0F / 720.0F;
  p = p * r + 1.0F / 120.0F;
  p = p * r + 1.0F / 24.0F;
  p = p * r + 1.0F / 6.0F;
  p = p * r + 0.5F;
  p = p * r + 1.0F;
  p = p * r + 1.0F;
  return p * (Floats)(((Ints)shifted + 127) << 23);
}

/// cos 2πl for |l| ≤ 1, by ± cos 2πq, |q| ≤ 1/4 exact, Taylor up to the power of 12: the first term left out is under 7e-9.
WAYWRIGHT_INLINE Floats cosine_of_turns(Floats l) {
  const Floats shifted = 2.0F * l + magic;
  const Floats q = 6.28318531F * (l - 0.5F * (shifted - magic));
  const Floats z = q * q;
  Floats p = all(1.0F / 479001600.0F);  // 1/12!
  p = p * z - 1.0F / 3628800.0F;
  p = p * z + 1.0F / 40320.0F;
  p = p * z - 1.0F / 720.0F;
  p = p * z + 1.0F / 24.0F;
  p = p * z - 0.5F;
  p = p * z + 1.0F;
  return (Floats)((Ints)p ^ ((Ints)shifted << 31));
}

constexpr float inside = 1.0F - 0x1.0p-21F;  // share of the radius that whoever leaves the disc is put at

void draw(Drawing& drawing) {
  const Drawing d = drawing;
  const std::uint64_t a = (std::uint64_t{d.agents} + 1) / 2, m = (std::uint64_t{d.moves} + 1) / 2;
  Stream us{d.counter, 0}, vs{d.counter, a};
  const float most = inside * d.radius;
  for (std::size_t i = 0; i < d.agents; i += native) {
    const Floats away = most * root(us.uniform()), turn = vs.uniform();
    store(d.x + i, away * cosine_of_turns(turn));
    store(d.y + i, away * cosine_of_turns(turn - 0.25F));
  }
  Stream rs{d.counter, 2 * a}, ss{d.counter, 2 * a + m}, ps{d.counter, 2 * a + 2 * m};
  const float share = d.choice < 1.0F ? d.choice : 1.0F;
  const float agents_by_p = share > 0.0F ? static_cast<float>(d.agents) / share : 0.0F, last = static_cast<float>(d.agents - 1);
  for (std::size_t i = 0; i < d.moves; i += native) {
    const Floats r = rs.uniform(), s = ss.uniform(), p = ps.uniform();
    const Ints is_spiral = p >= d.choice;
    const Floats l = 2.0F * r - 1.0F, reach = load(d.reach + i), by = reach - 2.0F * reach * r;
    const Floats spiral = exponential(lesser(greater(d.spiral * l, all(-80.0F)), all(80.0F))) * cosine_of_turns(l);
    store(d.factor + i, is_spiral ? spiral : by);
    store(d.scale + i, is_spiral ? all(1.0F) : 2.0F * s);
    const Ints other = __builtin_convertvector(lesser(agents_by_p * p, all(last)), Ints);
    store(d.other + i, (is_spiral | (absolute(by) < d.threshold)) | other);
  }
}

/// From where each lane's element says.
WAYWRIGHT_INLINE Floats picked(const float* from, Ints index) {
#if defined(__AVX512F__)
  return (Floats)_mm512_i32gather_ps((__m512i)index, from, 4);
#else
  Floats v;
  for (int k = 0; k < native; ++k) v[k] = from[index[k]];
  return v;
#endif
}

/// Does the line to a place come as near to the shadow's middle as that?
WAYWRIGHT_INLINE Ints darkened(const Flight& f, const Shadow& shadow, Floats x, Floats y) {
  const Floats to_x = x - f.begin_x, to_y = y - f.begin_y, length = to_x * to_x + to_y * to_y;
  const Floats across = to_x * shadow.y - to_y * shadow.x, along = to_x * shadow.x + to_y * shadow.y;
  return (across * across <= shadow.squared * length) & (along > 0.0F) & (along <= length);
}

struct Told {
  Ints is_seen, is_hidden;
};
/// Of the goal, from each place; near to the goal single precision does not tell the direction.
WAYWRIGHT_INLINE Told goal_told(const Flight& f, Floats x, Floats y) {
  const Ints yes = Ints{} - 1, no{};
  if (f.goal == Flight::Goal::is_seen) return {yes, no};
  if (f.goal == Flight::Goal::is_hidden) return {no, yes};
  if (f.goal == Flight::Goal::not_told) return {no, no};
  const Floats to_x = x - f.goal_x, to_y = y - f.goal_y, squared = to_x * to_x + to_y * to_y;
  const Ints is_away = squared > f.at_goal_squared;
  const Floats share = to_y / (is_away ? absolute(to_x) + absolute(to_y) : all(1.0F));
  const Floats around = to_x < 0.0F ? 2.0F - share : share < 0.0F ? 4.0F + share : share;
  const Ints bin = __builtin_convertvector(0.25F * directions * around, Ints) & (directions - 1);
  return {is_away & (squared < picked(f.seen_squares, bin)), is_away & (squared > picked(f.hidden_squares, bin))};
}

/// Is the line to each place known to be free?
WAYWRIGHT_INLINE Ints is_lit(const Flight& f, Floats x, Floats y) {
  const Floats to_x = x - f.begin_x, to_y = y - f.begin_y, off_x = x - f.lit_x, off_y = y - f.lit_y;
  return (to_x * to_x + to_y * to_y < f.lit_squared) | (off_x * off_x + off_y * off_y < f.lit_around_squared);
}

/// `so_many` registers are all agents: where it is positive they stay in them, else they are in memory.
template <int so_many>
class Swarm {
 public:
  WAYWRIGHT_INLINE explicit Swarm(const Flight& f) : f_{f}, leader_x_{f.leader_x}, leader_y_{f.leader_y}, enough_{f.enough}, count_{so_many > 0 ? so_many : static_cast<int>((f.agents + native - 1) / native)} {
    // Lanes beyond the agents are never promising.
    for (int k = 0; k < native; ++k) {
      const std::size_t agent = static_cast<std::size_t>(count_ - 1) * native + static_cast<std::size_t>(k);
      beyond_[k] = agent < f.agents ? 0.0F : __builtin_inff();
    }
    for (int i = 0; i < so_many; ++i) x_[i] = load(f.x + i * native), y_[i] = load(f.y + i * native);
  }

  WAYWRIGHT_INLINE bool rank() {
    const Floats enough = all(enough_);
    bool is_promising = false;
    for (int i = 0; i < count_; ++i) is_promising |= ranked(i, x(i), y(i), enough);
    return is_promising && is_open(enough);
  }

  /// One iteration, its first move's number.
  WAYWRIGHT_INLINE bool move(std::size_t first) {
    const Floats enough = all(enough_);
    const bool searches = first < f_.searching;
    if (so_many != 1 && searches) {
      for (int i = 0; i < so_many; ++i) store(f_.x + i * native, x_[i]), store(f_.y + i * native, y_[i]);
      if (so_many == 0) {
        __builtin_memcpy(f_.before_x, f_.x, f_.agents * sizeof(float));
        __builtin_memcpy(f_.before_y, f_.y, f_.agents * sizeof(float));
      }
    }
    bool is_promising = false;
    const Floats before_x = x(0), before_y = y(0);
    for (int i = 0; i < count_; ++i) {
      const std::size_t at = first + static_cast<std::size_t>(i) * native;
      Floats target_x = all(leader_x_), target_y = all(leader_y_);
      if (searches) {
        const Ints other = load(f_.other + at), is_search = other >= 0, whom = is_search ? other : Ints{};
        if (so_many == 1) {
          target_x = is_search ? __builtin_shuffle(before_x, whom) : target_x;
          target_y = is_search ? __builtin_shuffle(before_y, whom) : target_y;
        } else {
          target_x = is_search ? picked(so_many == 0 ? f_.before_x : f_.x, whom) : target_x;
          target_y = is_search ? picked(so_many == 0 ? f_.before_y : f_.y, whom) : target_y;
        }
      }
      const Floats factor = load(f_.factor + at), scale = load(f_.scale + at), low = all(-f_.radius), high = all(f_.radius), most = all(inside * f_.radius);
      Floats new_x = lesser(greater(target_x + factor * absolute(scale * target_x - x(i)), low), high);
      Floats new_y = lesser(greater(target_y + factor * absolute(scale * target_y - y(i)), low), high);
      const Floats squared = new_x * new_x + new_y * new_y;
      if (is_any_less(most * most, squared)) {
        const Floats share = most / greater(root(squared), most);
        new_x = share * new_x;
        new_y = share * new_y;
      }
      set(i, new_x, new_y);
      is_promising |= ranked(i, new_x, new_y, enough);
    }
    return is_promising && is_open(enough);
  }

  WAYWRIGHT_INLINE float leader_x() const { return leader_x_; }
  WAYWRIGHT_INLINE float leader_y() const { return leader_y_; }
  WAYWRIGHT_INLINE float enough() const { return enough_; }
  WAYWRIGHT_INLINE std::size_t least_one() const { return least_; }
  WAYWRIGHT_INLINE void keep() const {
    for (int i = 0; i < so_many; ++i) {
      store(f_.x + i * native, x_[i]);
      store(f_.y + i * native, y_[i]);
      store(f_.keys + i * native, keys_[i]);
      store(f_.bounds + i * native, bounds_[i]);
      store(f_.is_dark + i * native, is_dark_[i]);
    }
  }

  /// The first agent with the least bound. Bounds are numbers, or else no agents'.
  WAYWRIGHT_INLINE std::size_t least() const {
    Floats least = all(__builtin_inff());
    for (int i = 0; i < count_; ++i) least = lesser(bound(i), least);  // the second one where the first one is not a number
    least = least_of(least);
    for (int i = 0; i < count_; ++i) {
      if (const unsigned found = not_greater_bits(bound(i), least); found != 0) return static_cast<std::size_t>(i) * native + static_cast<std::size_t>(__builtin_ctz(found));
    }
    return 0;
  }

 private:
  WAYWRIGHT_INLINE Floats bound(int i) const { return so_many > 0 ? bounds_[i] : load(f_.bounds + i * native); }
  WAYWRIGHT_INLINE void set_bound(int i, Floats bound) {
    if (so_many > 0) bounds_[i] = bound;
    else store(f_.bounds + i * native, bound);
  }
  WAYWRIGHT_INLINE Ints known(int i) const { return so_many > 0 ? is_known_[i] : load(f_.is_known + i * native); }
  WAYWRIGHT_INLINE void set_known(int i, Ints is_known) {
    if (so_many > 0) is_known_[i] = is_known;
    else store(f_.is_known + i * native, is_known);
  }
  WAYWRIGHT_INLINE void set_dark(int i, Ints is_dark) {
    if (so_many > 0) is_dark_[i] = is_dark;
    else store(f_.is_dark + i * native, is_dark);
  }
  WAYWRIGHT_INLINE Floats key(int i) const { return so_many > 0 ? keys_[i] : load(f_.keys + i * native); }
  WAYWRIGHT_INLINE Floats x(int i) const { return so_many > 0 ? x_[i] : load(f_.x + i * native); }
  WAYWRIGHT_INLINE Floats y(int i) const { return so_many > 0 ? y_[i] : load(f_.y + i * native); }
  WAYWRIGHT_INLINE void set(int i, Floats new_x, Floats new_y) {
    if (so_many > 0) {
      x_[i] = new_x;
      y_[i] = new_y;
    } else {
      store(f_.x + i * native, new_x);
      store(f_.y + i * native, new_y);
    }
  }
  /// But for shadows.
  WAYWRIGHT_INLINE bool ranked(int i, Floats at_x, Floats at_y, Floats enough) {
    const Floats to_x = at_x - f_.goal_x, to_y = at_y - f_.goal_y;
    const Floats key = f_.per_radius * root(at_x * at_x + at_y * at_y) + f_.per_goal * root(to_x * to_x + to_y * to_y);
    Floats bound = f_.goal == Flight::Goal::is_hidden ? key + f_.hidden : key;
    if (i == count_ - 1) bound = bound + beyond_;
    if (so_many > 0) keys_[i] = key;
    else store(f_.keys + i * native, key);
    set_bound(i, bound);
    return is_any_less(bound, enough);
  }
  /// Is one promising, with shadows and what is told of the goal, that has to be looked at? One that has not becomes the leader.
  WAYWRIGHT_INLINE bool is_open(Floats enough) {
    bool is_promising = false;
    for (int i = 0; i < count_; ++i) {
      Ints is_dark{};
      for (std::size_t s = 0; s < f_.shadow_count; ++s) is_dark |= darkened(f_, f_.shadows[s], x(i), y(i));
      set_dark(i, is_dark);
      Floats bound = is_dark ? key(i) + f_.dark : key(i);
      if (f_.goal == Flight::Goal::is_hidden) bound = bound + f_.hidden;
      if (i == count_ - 1) bound = bound + beyond_;
      if (is_any_less(bound, enough)) {
        const Told told = goal_told(f_, x(i), y(i));
        if (f_.goal == Flight::Goal::told_by_view) bound = told.is_hidden ? bound + f_.hidden : bound;
        set_known(i, (told.is_seen | told.is_hidden) & is_lit(f_, x(i), y(i)));
        is_promising |= is_any_less(bound, enough);
      }
      set_bound(i, bound);
    }
    if (!is_promising) return false;
    least_ = least();
    const int i = so_many == 1 ? 0 : static_cast<int>(least_) / native, k = static_cast<int>(least_) % native;
    if (known(i)[k] == 0) return true;
    leader_x_ = x(i)[k];
    leader_y_ = y(i)[k];
    enough_ = bound(i)[k];
    return false;
  }

  const Flight& f_;
  float leader_x_, leader_y_, enough_;
  std::size_t least_ = 0;
  const int count_;
  Floats beyond_;
  Floats x_[so_many > 0 ? so_many : 1]{}, y_[so_many > 0 ? so_many : 1]{}, keys_[so_many > 0 ? so_many : 1]{}, bounds_[so_many > 0 ? so_many : 1]{};
  Ints is_dark_[so_many > 0 ? so_many : 1]{}, is_known_[so_many > 0 ? so_many : 1]{};
};

template <int so_many, bool moves>
WAYWRIGHT_INLINE void run(Flight& flight) {
  const Flight f = flight;
  Swarm<so_many> swarm{f};
  std::size_t first = f.first;
  bool is_promising = false;
  if (moves) {
    while (first < f.moves && !is_promising) {
      is_promising = swarm.move(first);
      first += f.agents;
    }
  } else {
    is_promising = swarm.rank();
  }
  swarm.keep();
  flight.first = first;
  flight.is_promising = is_promising;
  flight.least = swarm.least_one();
  flight.leader_x = swarm.leader_x();
  flight.leader_y = swarm.leader_y();
  flight.enough = swarm.enough();
}

template <bool moves>
WAYWRIGHT_INLINE void run_any(Flight& flight) {
  switch ((flight.agents + native - 1) / native) {
    case 1: return run<1, moves>(flight);
    case 2: return run<2, moves>(flight);
    case 3: return run<3, moves>(flight);
    default: return run<0, moves>(flight);
  }
}
void fly(Flight& flight) { run_any<true>(flight); }
void rank(Flight& flight) { run_any<false>(flight); }
void shade(const Flight& flight, const Shadow& shadow) {
  const Flight f = flight;
  for (std::size_t i = 0; i < f.agents; i += native) {
    const Floats bound = load(f.bounds + i), dark = load(f.keys + i) + f.dark;
    const Ints is_dark = darkened(f, shadow, load(f.x + i), load(f.y + i));
    store(f.bounds + i, is_dark ? greater(dark, bound) : bound);
    store(f.is_dark + i, load(f.is_dark + i) | is_dark);
  }
}

}  // namespace
}  // namespace waywright::whale_lanes
