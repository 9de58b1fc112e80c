// Body of the kernels; included once for each instruction set, in a namespace of its own. No function of the standard library is
// called here: an inline one, compiled for a wide instruction set, could be the copy that the linker keeps for everyone.
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__ARM_NEON)
#include <arm_neon.h>
#endif

#include "waywright/planner/docking/lanes/kernels.hpp"

#define WAYWRIGHT_ALWAYS __attribute__((always_inline))
#define WAYWRIGHT_INLINE inline WAYWRIGHT_ALWAYS

namespace waywright::lanes {
namespace {

#if defined(__AVX512F__)
inline constexpr int native = 16;
#elif defined(__AVX__)
inline constexpr int native = 8;
#else
inline constexpr int native = 4;
#endif
inline constexpr int parts = width / native;

using NativeFloats = float __attribute__((vector_size(4 * native)));
using NativeInts = std::int32_t __attribute__((vector_size(4 * native)));

// Sixteen lanes in as many registers as they need. (A vector type of the full width would go through memory where the processor
// has none so wide.)
struct Floats {
  NativeFloats p[parts];
};
struct Ints {
  NativeInts p[parts];
};

template <class Out, class Operation>
WAYWRIGHT_INLINE Out lanewise(Operation operation) {
  Out out;
#pragma GCC unroll 4
  for (int i = 0; i < parts; ++i) out.p[i] = operation(i);
  return out;
}
WAYWRIGHT_INLINE Floats all(float v) {
  return lanewise<Floats>([&](int) WAYWRIGHT_ALWAYS { return NativeFloats{} + v; });
}
WAYWRIGHT_INLINE Floats operator+(Floats a, Floats b) {
  return lanewise<Floats>([&](int i) WAYWRIGHT_ALWAYS { return a.p[i] + b.p[i]; });
}
WAYWRIGHT_INLINE Floats operator-(Floats a, Floats b) {
  return lanewise<Floats>([&](int i) WAYWRIGHT_ALWAYS { return a.p[i] - b.p[i]; });
}
WAYWRIGHT_INLINE Floats operator*(Floats a, Floats b) {
  return lanewise<Floats>([&](int i) WAYWRIGHT_ALWAYS { return a.p[i] * b.p[i]; });
}
WAYWRIGHT_INLINE Floats operator/(Floats a, Floats b) {
  return lanewise<Floats>([&](int i) WAYWRIGHT_ALWAYS { return a.p[i] / b.p[i]; });
}
WAYWRIGHT_INLINE Floats operator*(Floats a, float b) { return a * all(b); }
WAYWRIGHT_INLINE Floats operator+(float a, Floats b) { return all(a) + b; }
WAYWRIGHT_INLINE Floats operator-(Floats a, float b) { return a - all(b); }
WAYWRIGHT_INLINE Ints operator>(Floats a, Floats b) {
  return lanewise<Ints>([&](int i) WAYWRIGHT_ALWAYS { return a.p[i] > b.p[i]; });
}
WAYWRIGHT_INLINE Ints operator>=(Floats a, Floats b) {
  return lanewise<Ints>([&](int i) WAYWRIGHT_ALWAYS { return a.p[i] >= b.p[i]; });
}
WAYWRIGHT_INLINE Ints operator&(Ints a, Ints b) {
  return lanewise<Ints>([&](int i) WAYWRIGHT_ALWAYS { return a.p[i] & b.p[i]; });
}
WAYWRIGHT_INLINE Ints operator|(Ints a, Ints b) {
  return lanewise<Ints>([&](int i) WAYWRIGHT_ALWAYS { return a.p[i] | b.p[i]; });
}
WAYWRIGHT_INLINE Ints operator~(Ints a) {
  return lanewise<Ints>([&](int i) WAYWRIGHT_ALWAYS { return ~a.p[i]; });
}
WAYWRIGHT_INLINE Ints operator+(Ints a, Ints b) {
  return lanewise<Ints>([&](int i) WAYWRIGHT_ALWAYS { return a.p[i] + b.p[i]; });
}
WAYWRIGHT_INLINE Floats select(Ints mask, Floats a, Floats b) {
  return lanewise<Floats>([&](int i) WAYWRIGHT_ALWAYS { return mask.p[i] ? a.p[i] : b.p[i]; });
}
WAYWRIGHT_INLINE Ints truncated(Floats a) {
  return lanewise<Ints>([&](int i) WAYWRIGHT_ALWAYS { return __builtin_convertvector(a.p[i], NativeInts); });
}
// What `select(a > b, a, b)` and `select(b > a, a, b)` give, numbers or not: one instruction where the processor's is just that.
WAYWRIGHT_INLINE Floats greater(Floats a, Floats b) {
#if defined(__SSE2__)
  return lanewise<Floats>([&](int i) WAYWRIGHT_ALWAYS {
#if defined(__AVX512F__)
    return (NativeFloats)_mm512_max_ps((__m512)a.p[i], (__m512)b.p[i]);
#elif defined(__AVX__)
    return (NativeFloats)_mm256_max_ps((__m256)a.p[i], (__m256)b.p[i]);
#else
    return (NativeFloats)_mm_max_ps((__m128)a.p[i], (__m128)b.p[i]);
#endif
  });
#else
  return select(a > b, a, b);
#endif
}
/// a where it is in [0, most], `most` elsewhere.
WAYWRIGHT_INLINE Ints within(Ints a, std::int32_t most) {
  return lanewise<Ints>([&](int i) WAYWRIGHT_ALWAYS {
    using Unsigned = std::uint32_t __attribute__((vector_size(4 * native)));
    const Unsigned limit = Unsigned{} + static_cast<std::uint32_t>(most);
    const Unsigned u = (Unsigned)a.p[i];
    return (NativeInts)(u < limit ? u : limit);
  });
}
WAYWRIGHT_INLINE Ints operator<<(Ints a, int by) {
  return lanewise<Ints>([&](int i) WAYWRIGHT_ALWAYS { return a.p[i] << by; });
}
WAYWRIGHT_INLINE Floats magnitude(Floats a) {
  return lanewise<Floats>([&](int i) WAYWRIGHT_ALWAYS { return (NativeFloats)((NativeInts)a.p[i] & 0x7FFFFFFF); });
}

/// Values of the quintic's basis and of its derivatives at the samples.
struct alignas(64) Basis {
  float e[traced], a[traced], c[traced], b[traced];
  float e1[traced], a1[traced], c1[traced], b1[traced];
  float e2[traced], a2[traced], c2[traced], b2[traced];
  float e3[traced], a3[traced], c3[traced], b3[traced];
  float weight[traced];  ///< of the trapezoidal rule over u
};

constexpr Basis make_basis() {
  Basis b{};
  for (int i = 0; i < traced; ++i) {
    const double u = i < samples ? static_cast<double>(i) / (samples - 1) : 1.0;
    const double u2 = u * u;
    const double u3 = u2 * u;
    const double u4 = u2 * u2;
    const double u5 = u4 * u;
    b.e[i] = static_cast<float>(10 * u3 - 15 * u4 + 6 * u5);
    b.a[i] = static_cast<float>(u - 6 * u3 + 8 * u4 - 3 * u5);
    b.c[i] = static_cast<float>(-4 * u3 + 7 * u4 - 3 * u5);
    b.b[i] = static_cast<float>(0.5 * u2 - 1.5 * u3 + 1.5 * u4 - 0.5 * u5);
    b.e1[i] = static_cast<float>(30 * u2 - 60 * u3 + 30 * u4);
    b.a1[i] = static_cast<float>(1 - 18 * u2 + 32 * u3 - 15 * u4);
    b.c1[i] = static_cast<float>(-12 * u2 + 28 * u3 - 15 * u4);
    b.b1[i] = static_cast<float>(u - 4.5 * u2 + 6 * u3 - 2.5 * u4);
    b.e2[i] = static_cast<float>(60 * u - 180 * u2 + 120 * u3);
    b.a2[i] = static_cast<float>(-36 * u + 96 * u2 - 60 * u3);
    b.c2[i] = static_cast<float>(-24 * u + 84 * u2 - 60 * u3);
    b.b2[i] = static_cast<float>(1 - 9 * u + 18 * u2 - 10 * u3);
    b.e3[i] = static_cast<float>(60 - 360 * u + 360 * u2);
    b.a3[i] = static_cast<float>(-36 + 192 * u - 180 * u2);
    b.c3[i] = static_cast<float>(-24 + 168 * u - 180 * u2);
    b.b3[i] = static_cast<float>(-9 + 36 * u - 30 * u2);
    const double inner = 1.0 / (samples - 1);
    b.weight[i] = static_cast<float>(i == 0 || i == samples - 1 ? 0.5 * inner : i < samples ? inner : 0.0);
  }
  return b;
}
constexpr Basis basis = make_basis();

WAYWRIGHT_INLINE Floats load(const float* from) {
  return lanewise<Floats>([from](int i) WAYWRIGHT_ALWAYS {
    NativeFloats v;
    __builtin_memcpy(&v, from + native * i, sizeof v);
    return v;
  });
}
WAYWRIGHT_INLINE void store(float* to, Floats a) {
#pragma GCC unroll 4
  for (int i = 0; i < parts; ++i) __builtin_memcpy(to + native * i, &a.p[i], sizeof a.p[i]);
}

WAYWRIGHT_INLINE Floats root(Floats a) {
  return lanewise<Floats>([&](int i) WAYWRIGHT_ALWAYS {
#if defined(__AVX512F__)
    return (NativeFloats)_mm512_sqrt_ps((__m512)a.p[i]);
#elif defined(__AVX__)
    return (NativeFloats)_mm256_sqrt_ps((__m256)a.p[i]);
#elif defined(__SSE2__)
    return (NativeFloats)_mm_sqrt_ps((__m128)a.p[i]);
#elif defined(__aarch64__)
    return (NativeFloats)vsqrtq_f32((float32x4_t)a.p[i]);
#else
    NativeFloats v;
    for (int k = 0; k < native; ++k) v[k] = __builtin_sqrtf(a.p[i][k]);
    return v;
#endif
  });
}

WAYWRIGHT_INLINE Floats gather(const float* from, Ints at) {
  return lanewise<Floats>([&](int i) WAYWRIGHT_ALWAYS {
#if defined(__AVX512F__)
    return (NativeFloats)_mm512_i32gather_ps((__m512i)at.p[i], from, 4);
#elif defined(__AVX2__)
    return (NativeFloats)_mm256_i32gather_ps(from, (__m256i)at.p[i], 4);
#else
    return NativeFloats{from[at.p[i][0]], from[at.p[i][1]], from[at.p[i][2]], from[at.p[i][3]]};
#endif
  });
}

/// The lanes of `a`, then the first of `b`, but for the first: in registers, since a load that straddles a store waits for it.
WAYWRIGHT_INLINE NativeFloats shifted(NativeFloats a, NativeFloats b) {
#if defined(__AVX512F__)
  return __builtin_shufflevector(a, b, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16);
#elif defined(__AVX__)
  return __builtin_shufflevector(a, b, 1, 2, 3, 4, 5, 6, 7, 8);
#else
  return __builtin_shufflevector(a, b, 1, 2, 3, 4);
#endif
}
/// Lane i holds lane i + 1; the last one something.
WAYWRIGHT_INLINE Floats next_lanes(Floats a) {
  return lanewise<Floats>([&](int i) WAYWRIGHT_ALWAYS { return shifted(a.p[i], a.p[i + 1 < parts ? i + 1 : 0]); });
}

/// Bit i: lane i is true (all ones).
WAYWRIGHT_INLINE std::uint16_t bits(Ints mask) {
  unsigned out = 0;
  for (int i = 0; i < parts; ++i) {
#if defined(__AVX512DQ__)
    out = _cvtmask16_u32(_mm512_movepi32_mask((__m512i)mask.p[i]));
#elif defined(__AVX__)
    out |= static_cast<unsigned>(_mm256_movemask_ps((__m256)mask.p[i])) << (native * i);
#elif defined(__SSE2__)
    out |= static_cast<unsigned>(_mm_movemask_ps((__m128)mask.p[i])) << (native * i);
#else
    for (int k = 0; k < native; ++k) out |= (mask.p[i][k] != 0 ? 1U : 0U) << (native * i + k);
#endif
  }
  return static_cast<std::uint16_t>(out);
}

/// In a fixed order of the lanes, whatever the registers.
WAYWRIGHT_INLINE float sum_of(Floats v) {
  float s[width];
  store(s, v);
  for (int half = width / 2; half > 0; half /= 2) {
    for (int i = 0; i < half; ++i) s[i] += s[i + half];
  }
  return s[0];
}
WAYWRIGHT_INLINE float greatest_of(Floats v) {
  float s[width];
  store(s, v);
  float g = s[0];
  for (int i = 1; i < width; ++i) g = s[i] > g ? s[i] : g;
  return g;
}

/// Of three neighbours whose middle is the highest: the top of the parabola through them. (The last sample is repeated: no summit.)
WAYWRIGHT_INLINE Floats peak(Floats a, Floats b, Floats c) {
  const Floats bend = a + c - (b + b);
  const Floats top = b - (a - c) * (a - c) / (bend * 8.0F);
  return select((b >= a) & (b > c) & (all(0.0F) > bend), top, b);
}

template <bool with_rate, bool bent>
WAYWRIGHT_INLINE void trace_all(const Quintic& q, Track& track) {
  Floats length = all(0.0F);
  for (int i = 0; i < traced; i += width) {
    const auto sum = [i](const float* e, float chord, const float* a, float tangent, const float* c, float end, const float* b, float bend) WAYWRIGHT_ALWAYS {
      const Floats straight = load(e + i) * chord + load(a + i) * tangent + load(c + i) * end;
      if constexpr (bent) return straight + load(b + i) * bend;
      return straight;
    };
    const Basis& b = basis;
    store(&track.x[i], q.from_x + sum(b.e, q.chord_x, b.a, q.tangent_x, b.c, q.end_tangent_x, b.b, q.bend_x));
    store(&track.y[i], q.from_y + sum(b.e, q.chord_y, b.a, q.tangent_y, b.c, q.end_tangent_y, b.b, q.bend_y));
    const Floats x1 = sum(b.e1, q.chord_x, b.a1, q.tangent_x, b.c1, q.end_tangent_x, b.b1, q.bend_x);
    const Floats y1 = sum(b.e1, q.chord_y, b.a1, q.tangent_y, b.c1, q.end_tangent_y, b.b1, q.bend_y);
    const Floats x2 = sum(b.e2, q.chord_x, b.a2, q.tangent_x, b.c2, q.end_tangent_x, b.b2, q.bend_x);
    const Floats y2 = sum(b.e2, q.chord_y, b.a2, q.tangent_y, b.c2, q.end_tangent_y, b.b2, q.bend_y);
    const Floats squared = x1 * x1 + y1 * y1;
    const Floats speed = root(squared);
    const Floats inverse = all(1.0F) / greater(speed, all(1e-12F));
    store(&track.heading_x[i], x1 * inverse * q.facing);
    store(&track.heading_y[i], y1 * inverse * q.facing);
    const Floats inverse2 = inverse * inverse;
    const Floats turn = x1 * y2 - y1 * x2;  // N; κ = N / |p′|³
    store(&track.curvature[i], turn * inverse * inverse2);
    if constexpr (with_rate) {
      // dκ/ds = (N′ |p′|² − 3 N (p′·p″)) / |p′|⁶
      const Floats x3 = sum(b.e3, q.chord_x, b.a3, q.tangent_x, b.c3, q.end_tangent_x, b.b3, q.bend_x);
      const Floats y3 = sum(b.e3, q.chord_y, b.a3, q.tangent_y, b.c3, q.end_tangent_y, b.b3, q.bend_y);
      const Floats rate = (x1 * y3 - y1 * x3) * squared - turn * (x1 * x2 + y1 * y2) * 3.0F;
      store(&track.rate[i], rate * inverse2 * inverse2 * inverse2);
    }
    length = length + speed * load(b.weight + i);
  }
  store(&track.x[traced], all(track.x[samples - 1]));
  store(&track.y[traced], all(track.y[samples - 1]));
  store(&track.curvature[traced], all(track.curvature[samples - 1]));
  if constexpr (with_rate) store(&track.rate[traced], all(track.rate[samples - 1]));

  Floats change = all(0.0F), top_curvature = change, top_rate = change;
  for (int i = 0; i < traced; i += width) {
    const Floats dx = load(&track.x[i + 1]) - load(&track.x[i]);
    const Floats dy = load(&track.y[i + 1]) - load(&track.y[i]);
    const Floats k0 = load(&track.curvature[i]);
    const Floats k1 = load(&track.curvature[i + 1]);
    const Floats step = root(dx * dx + dy * dy) * 1.002F;
    store(&track.step[i], step);
    store(&track.turn[i], greater(magnitude(k0), magnitude(k1)) * step);
    change = change + magnitude(k1 - k0);
    const auto highest = [](const float* list) WAYWRIGHT_ALWAYS {
      const Floats first = magnitude(load(list));
      return greater(first, peak(first, magnitude(load(list + 1)), magnitude(load(list + 2))));
    };
    top_curvature = greater(top_curvature, highest(&track.curvature[i]));
    if constexpr (with_rate) top_rate = greater(top_rate, highest(&track.rate[i]));
  }
  track.length = sum_of(length);
  track.curvature_change = sum_of(change);
  track.max_curvature = greatest_of(top_curvature);
  track.max_rate = greatest_of(top_rate);
}

void trace(const Quintic& q, bool with_rate, Track& track) {
  if (q.bend_x == 0.0F && q.bend_y == 0.0F) {
    with_rate ? trace_all<true, false>(q, track) : trace_all<false, false>(q, track);
  } else {
    with_rate ? trace_all<true, true>(q, track) : trace_all<false, true>(q, track);
  }
}

/// The vehicle at sixteen neighbouring samples.
struct Stretch {
  Floats column, row;  ///< position in cells of the field
  Floats heading_x, heading_y, step, turn;
};

/// The field at a disc's centre. A place outside of it, or none at all, leads to a cell of its rim, where nothing is known.
WAYWRIGHT_INLINE Floats field_at(const Stretch& at, const Disc& disc, const Field& field) {
  const float along = disc.x * field.inverse_cell;
  const float left = disc.y * field.inverse_cell;
  const Ints column = truncated(at.column + at.heading_x * along - at.heading_y * left);
  const Ints row = truncated(at.row + at.heading_y * along + at.heading_x * left);
  return gather(field.value, (within(row, field.last_row) << field.row_shift) + within(column, field.last_column));
}

/// Which of a stretch's fifteen intervals are not shown to be clear by these discs, and which samples are surely too near.
/// Adds how deep they are to `depth` where it is given.
WAYWRIGHT_INLINE void look(const Stretch& at, Discs discs, const Field& field, Ints& open, Ints& hit, Floats* depth) {
  for (int k = 0; k < discs.count; ++k) {
    const Disc& disc = discs.first[k];
    const Floats value = field_at(at, disc, field);
    if (depth != nullptr) *depth = *depth + greater(all(disc.middle) - greater(value, all(0.0F)), all(0.0F));
    hit = hit | ((value >= all(0.0F)) & (all(disc.inner) >= value));
    const Floats slack = value - disc.outer;
    // The centre moves with the origin and swings about it: an interval is clear where its ends' slacks reach each other.
    open = open | ~(slack + next_lanes(slack) > at.step + at.turn * disc.reach);
  }
}

WAYWRIGHT_INLINE Stretch stretch_at(const Track& track, const Field& field, int i) {
  return {load(&track.x[i]) * field.inverse_cell, load(&track.y[i]) * field.inverse_cell, load(&track.heading_x[i]), load(&track.heading_y[i]),
          load(&track.step[i]),                   load(&track.turn[i])};
}

void screen(const Track& track, Discs coarse, Discs fine, const Field& field, Screen& out) {
  constexpr unsigned intervals = (1U << (width - 1)) - 1U;
  out.hit = samples;
  Floats deficit = all(0.0F);
  for (int b = 0; b < stretches; ++b) {
    const Stretch at = stretch_at(track, field, b * (width - 1));
    Ints open = {}, hit = {};
    Floats depth = all(0.0F);
    look(at, coarse, field, open, hit, &depth);
    deficit = deficit + depth * at.step;
    out.open[b] = static_cast<std::uint16_t>(bits(open) & intervals);
  }
  out.deficit = sum_of(deficit);
  for (int b = 0; b < stretches; ++b) {
    if (out.open[b] == 0) continue;
    const int i = b * (width - 1);
    Ints open = {}, hit = {};
    look(stretch_at(track, field, i), fine, field, open, hit, nullptr);
    out.open[b] = static_cast<std::uint16_t>(out.open[b] & bits(open));
    if (const unsigned hits = bits(hit); hits != 0) {
      out.hit = i + __builtin_ctz(hits);
      return;
    }
  }
}

}  // namespace
}  // namespace waywright::lanes

#undef WAYWRIGHT_INLINE
#undef WAYWRIGHT_ALWAYS
