// Body of the kernels; included once for each instruction set, in a namespace of its own. No function of the standard library is
// called here: an inline one, compiled for a wide instruction set, could be the copy that the linker keeps for everyone.
#include <cstdint>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include "waywright/planner/grid/lanes/kernels.hpp"

namespace waywright::move_lanes {
namespace {

#if defined(__AVX512F__)

// The rows above and below, eight cells each from two columns to the left on, and four of each other row from one to the left on:
// A = [row + 1 | row − 1], B = [row + 2, row − 2, row, –]. Lane i of what comes out is where move i leads to.
inline __m512i in_order(__m512i a, __m512i b) {
  const __m512i order = _mm512_setr_epi32(16 + 10, 4, 3, 16 + 2, 2, 16 + 0, 1, 0, 16 + 8, 8 + 0, 8 + 1, 16 + 4, 8 + 2, 16 + 6, 8 + 3, 8 + 4);
  return _mm512_permutex2var_epi32(a, order, b);
}
inline __m512i around(const std::uint32_t* here, std::ptrdiff_t width) {
  const auto eight = [&](std::ptrdiff_t row) { return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(here + row * width - 2)); };
  const auto four = [&](std::ptrdiff_t row) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(here + row * width - 1)); };
  const __m512i a = _mm512_inserti64x4(_mm512_castsi256_si512(eight(1)), eight(-1), 1);
  __m512i b = _mm512_inserti32x4(_mm512_castsi128_si512(four(2)), four(-2), 1);
  b = _mm512_inserti32x4(b, four(0), 2);
  return in_order(a, b);
}
inline __m512i around(const std::uint16_t* here, std::ptrdiff_t width) {
  const auto eight = [&](std::ptrdiff_t row) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(here + row * width - 2)); };
  const auto four = [&](std::ptrdiff_t row) { return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(here + row * width - 1)); };
  const __m256i a = _mm256_inserti128_si256(_mm256_castsi128_si256(eight(1)), eight(-1), 1);
  const __m256i b = _mm256_inserti128_si256(_mm256_castsi128_si256(_mm_unpacklo_epi64(four(2), four(-2))), four(0), 1);
  return in_order(_mm512_cvtepu16_epi32(a), _mm512_cvtepu16_epi32(b));
}

std::uint32_t leave(const Lattice& lattice, const From& from, Arrivals& arrivals) {
  const auto all = [](std::uint32_t v) { return _mm512_set1_epi32(static_cast<int>(v)); };
  __m512i cost = _mm512_load_si512(lattice.weight);
  if (lattice.danger != nullptr) {
    const std::uint16_t* const danger = lattice.danger + from.cell;
    const __m512i both = _mm512_add_epi32(around(danger, lattice.width), all(*danger));
    cost = _mm512_add_epi32(cost, _mm512_srli_epi32(_mm512_mullo_epi32(cost, both), 9));
  }
  const __m512i sum = _mm512_add_epi32(cost, all(from.cost));
  const __mmask16 better = _mm512_mask_cmplt_epu32_mask(static_cast<__mmask16>(from.free), _mm512_add_epi32(sum, all(from.base)), around(from.key, lattice.width));
  if (better == 0) return 0;
  const __m512i x = _mm512_abs_epi32(_mm512_add_epi32(_mm512_load_si512(lattice.column), all(static_cast<std::uint32_t>(from.column))));
  const __m512i y = _mm512_abs_epi32(_mm512_add_epi32(_mm512_load_si512(lattice.row), all(static_cast<std::uint32_t>(from.row))));
  const __m512i most = _mm512_max_epu32(x, y), least = _mm512_min_epu32(x, y);
  const auto way = [&](int k) { return _mm512_add_epi32(_mm512_mullo_epi32(most, all(lattice.most[k])), _mm512_mullo_epi32(least, all(lattice.least[k]))); };
  const __m512i rest = _mm512_sub_epi32(_mm512_max_epu32(_mm512_max_epu32(way(0), way(1)), all(lattice.less)), all(lattice.less));
  _mm512_store_si512(arrivals.cost, sum);
  _mm512_store_si512(arrivals.bound, _mm512_add_epi32(sum, rest));
  return better;
}

#elif defined(__AVX2__)

struct Halves {
  __m256i low, high;  // moves 0 to 7, 8 to 15
};
// Of the row that is one on: eight cells from two columns to the left. Of the row that is two on, and of this row: four from one to the left.
inline __m256i half(__m256i next, __m256i after_and_here, bool up) {
  const __m256i from_next = _mm256_permutevar8x32_epi32(next, up ? _mm256_setr_epi32(0, 4, 3, 0, 2, 0, 1, 0) : _mm256_setr_epi32(0, 0, 1, 0, 2, 0, 3, 4));
  const __m256i from_others = _mm256_permutevar8x32_epi32(after_and_here, up ? _mm256_setr_epi32(6, 0, 0, 2, 0, 0, 0, 0) : _mm256_setr_epi32(4, 0, 0, 0, 0, 2, 0, 0));
  return _mm256_blend_epi32(from_next, from_others, 0b00101001);
}
inline Halves around(const std::uint32_t* here, std::ptrdiff_t width) {
  const auto eight = [&](std::ptrdiff_t row) { return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(here + row * width - 2)); };
  const auto four = [&](std::ptrdiff_t row) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(here + row * width - 1)); };
  const auto with_here = [&](std::ptrdiff_t row) { return _mm256_inserti128_si256(_mm256_castsi128_si256(four(row)), four(0), 1); };
  return {half(eight(1), with_here(2), true), half(eight(-1), with_here(-2), false)};
}
inline Halves around(const std::uint16_t* here, std::ptrdiff_t width) {
  const auto eight = [&](std::ptrdiff_t row) { return _mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(here + row * width - 2))); };
  const auto four = [&](std::ptrdiff_t row) { return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(here + row * width - 1)); };
  const auto with_here = [&](std::ptrdiff_t row) { return _mm256_cvtepu16_epi32(_mm_unpacklo_epi64(four(row), four(0))); };
  return {half(eight(1), with_here(2), true), half(eight(-1), with_here(-2), false)};
}

inline __m256i all(std::uint32_t v) { return _mm256_set1_epi32(static_cast<int>(v)); }
inline __m256i load(const void* p) { return _mm256_load_si256(static_cast<const __m256i*>(p)); }

inline std::uint32_t leave_half(const Lattice& lattice, const From& from, __m256i danger, std::uint32_t danger_here, __m256i key, int first, Arrivals& arrivals) {
  __m256i cost = load(lattice.weight + first);
  if (lattice.danger != nullptr) cost = _mm256_add_epi32(cost, _mm256_srli_epi32(_mm256_mullo_epi32(cost, _mm256_add_epi32(danger, all(danger_here))), 9));
  const __m256i sum = _mm256_add_epi32(cost, all(from.cost));
  const __m256i new_key = _mm256_add_epi32(sum, all(from.base));
  const __m256i is_worse = _mm256_cmpeq_epi32(_mm256_max_epu32(new_key, key), new_key);
  const std::uint32_t better = ~static_cast<std::uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(is_worse))) & (from.free >> first) & 0xFFU;
  if (better == 0) return 0;
  const __m256i x = _mm256_abs_epi32(_mm256_add_epi32(load(lattice.column + first), all(static_cast<std::uint32_t>(from.column))));
  const __m256i y = _mm256_abs_epi32(_mm256_add_epi32(load(lattice.row + first), all(static_cast<std::uint32_t>(from.row))));
  const __m256i most = _mm256_max_epu32(x, y), least = _mm256_min_epu32(x, y);
  const auto way = [&](int k) { return _mm256_add_epi32(_mm256_mullo_epi32(most, all(lattice.most[k])), _mm256_mullo_epi32(least, all(lattice.least[k]))); };
  const __m256i rest = _mm256_sub_epi32(_mm256_max_epu32(_mm256_max_epu32(way(0), way(1)), all(lattice.less)), all(lattice.less));
  _mm256_store_si256(reinterpret_cast<__m256i*>(arrivals.cost + first), sum);
  _mm256_store_si256(reinterpret_cast<__m256i*>(arrivals.bound + first), _mm256_add_epi32(sum, rest));
  return better << first;
}

std::uint32_t leave(const Lattice& lattice, const From& from, Arrivals& arrivals) {
  Halves danger{};
  std::uint32_t danger_here = 0;
  if (lattice.danger != nullptr) {
    danger = around(lattice.danger + from.cell, lattice.width);
    danger_here = lattice.danger[from.cell];
  }
  const Halves key = around(from.key, lattice.width);
  return leave_half(lattice, from, danger.low, danger_here, key.low, 0, arrivals) | leave_half(lattice, from, danger.high, danger_here, key.high, 8, arrivals);
}

#else

std::uint32_t leave(const Lattice& lattice, const From& from, Arrivals& arrivals) {
  std::uint32_t better = 0;
  const std::uint32_t danger_here = lattice.danger == nullptr ? 0 : lattice.danger[from.cell];
  for (std::uint32_t left = from.free; left != 0; left &= left - 1) {
    const auto i = static_cast<unsigned>(__builtin_ctz(left));
    const std::ptrdiff_t there = lattice.row[i] * lattice.width + lattice.column[i];
    std::uint32_t cost = lattice.weight[i];
    if (lattice.danger != nullptr) cost += (cost * (danger_here + lattice.danger[from.cell + there])) >> 9;
    const std::uint32_t sum = from.cost + cost;
    if (sum + from.base >= from.key[there]) continue;
    const std::int32_t column = from.column + lattice.column[i], row = from.row + lattice.row[i];
    const auto x = static_cast<std::uint32_t>(column < 0 ? -column : column), y = static_cast<std::uint32_t>(row < 0 ? -row : row);
    const std::uint32_t most = x > y ? x : y, least = x > y ? y : x;
    const std::uint32_t first = most * lattice.most[0] + least * lattice.least[0], second = most * lattice.most[1] + least * lattice.least[1];
    const std::uint32_t way = first > second ? first : second;
    better |= 1U << i;
    arrivals.cost[i] = sum;
    arrivals.bound[i] = sum + (way > lattice.less ? way - lattice.less : 0);
  }
  return better;
}

#endif

}  // namespace
}  // namespace waywright::move_lanes
