// Doubles as many as one register of the instruction set has, for kernels that are compiled once for each. Included within a file of kernels, in their unnamed namespace,
// so that no copy of it is anybody else's; that file has included <cstdint>, where there is SSE2 <immintrin.h>, and defined WAYWRIGHT_INLINE.
#if defined(__AVX512F__)
inline constexpr int native = 8;
#elif defined(__AVX__)
inline constexpr int native = 4;
#else
inline constexpr int native = 2;
#endif

using Doubles = double __attribute__((vector_size(8 * native)));
using Mask = std::int64_t __attribute__((vector_size(8 * native)));

WAYWRIGHT_INLINE Doubles load(const double* from) {
  Doubles v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
WAYWRIGHT_INLINE void store(double* to, Doubles v) { __builtin_memcpy(to, &v, sizeof v); }
// What `a < b ? a : b` and `a > b ? a : b` give, in one instruction where the processor's is just that.
WAYWRIGHT_INLINE Doubles lesser(Doubles a, Doubles b) {
#if defined(__AVX512F__)
  return (Doubles)_mm512_min_pd((__m512d)a, (__m512d)b);
#elif defined(__AVX__)
  return (Doubles)_mm256_min_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__)
  return (Doubles)_mm_min_pd((__m128d)a, (__m128d)b);
#else
  return a < b ? a : b;
#endif
}
WAYWRIGHT_INLINE Doubles greater(Doubles a, Doubles b) {
#if defined(__AVX512F__)
  return (Doubles)_mm512_max_pd((__m512d)a, (__m512d)b);
#elif defined(__AVX__)
  return (Doubles)_mm256_max_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__)
  return (Doubles)_mm_max_pd((__m128d)a, (__m128d)b);
#else
  return a > b ? a : b;
#endif
}
/// Bit i: lane i is true (all ones).
WAYWRIGHT_INLINE unsigned bits(Mask mask) {
#if defined(__AVX512DQ__)
  return _cvtmask8_u32(_mm512_movepi64_mask((__m512i)mask));
#elif defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_pd((__m256d)mask));
#elif defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_pd((__m128d)mask));
#else
  unsigned out = 0;
  for (int k = 0; k < native; ++k) out |= (mask[k] != 0 ? 1U : 0U) << k;
  return out;
#endif
}
/// Bit i: a < b in lane i; false of what is not a number.
WAYWRIGHT_INLINE unsigned less_bits(Doubles a, Doubles b) {
#if defined(__AVX512DQ__)
  return _cvtmask8_u32(_mm512_cmp_pd_mask((__m512d)a, (__m512d)b, _CMP_LT_OQ));
#else
  return bits(a < b);
#endif
}
/// Correctly rounded, as IEEE has it.
WAYWRIGHT_INLINE Doubles root(Doubles a) {
#if defined(__AVX512F__)
  return (Doubles)_mm512_sqrt_pd((__m512d)a);
#elif defined(__AVX__)
  return (Doubles)_mm256_sqrt_pd((__m256d)a);
#elif defined(__SSE2__)
  return (Doubles)_mm_sqrt_pd((__m128d)a);
#else
  Doubles v;
  for (int k = 0; k < native; ++k) v[k] = __builtin_sqrt(a[k]);
  return v;
#endif
}
