#include "waywright/map/distance_rows.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "waywright/map/distance_field.hpp"

#if defined(__x86_64__)
#define WAYWRIGHT_AVX2 [[gnu::target("avx2")]]
#endif

namespace waywright::distance_rows {
namespace {

constexpr int block = 32;        // cells whose search goes on together
constexpr int farthest = 96;     // columns to each side: beyond, the stack of parabolas takes over
constexpr int long_reach = 48;   // where the row before needed more on average, the stack is quicker from the start
constexpr int farthest_pair = 32;  // columns
constexpr int pad = farthest + 2 * block;
constexpr std::int32_t far_square = static_cast<std::int32_t>(far) * far;
static_assert(2LL * far_square + 2 * farthest_pair * farthest_pair <= std::numeric_limits<std::int32_t>::max());

[[gnu::always_inline]] inline void step_down_body(std::int16_t* carry, const std::uint8_t* blocked, std::int16_t* out, int columns) {
  for (int c = 0; c < columns; ++c) {
    const int more = carry[c] + 1;
    const int value = blocked[c] != 0 ? 0 : more < far ? more : far;
    carry[c] = static_cast<std::int16_t>(value);
    out[c] = static_cast<std::int16_t>(value);
  }
}

[[gnu::always_inline]] inline void step_up_body(std::int16_t* carry, std::int16_t* row, int columns) {
  for (int c = 0; c < columns; ++c) {
    const std::int16_t more = static_cast<std::int16_t>(carry[c] + 1);
    const std::int16_t value = more < row[c] ? more : row[c];
    carry[c] = value;
    row[c] = value;
  }
}

[[gnu::always_inline]] inline void square_body(const std::int16_t* vertical, std::int32_t* squares, int columns) {
  for (int c = 0; c < columns; ++c) squares[c] = static_cast<std::int32_t>(vertical[c]) * vertical[c];
}

/// Outwards from every cell of a block until nothing farther can be nearer. Returns how far; −1 where that was not far enough.
[[gnu::always_inline]] inline int outward_body(const std::int32_t* squares, std::int32_t* out) {
  std::int32_t best[block];
  std::int32_t worst = 0;
  for (int j = 0; j < block; ++j) {
    best[j] = squares[j];
    worst = best[j] > worst ? best[j] : worst;
  }
  int k = 1;
  while (k * k < worst) {
    if (k > farthest) return -1;
    for (int end = k + 4; k < end; ++k) {
      const std::int32_t square = k * k;
      for (int j = 0; j < block; ++j) {
        const std::int32_t left = squares[j - k], right = squares[j + k];
        const std::int32_t value = (left < right ? left : right) + square;
        best[j] = value < best[j] ? value : best[j];
      }
    }
    worst = 0;
    for (int j = 0; j < block; ++j) worst = best[j] > worst ? best[j] : worst;
  }
  for (int j = 0; j < block; ++j) out[j] = best[j];
  return k;
}

/// Marks the columns whose parabola may be lowest somewhere. One that is nowhere under both of a pair as far to its left and right is not: at a
/// cell where it were lowest both of them would be as low, so that the leftmost of the lowest always stays.
[[gnu::always_inline]] inline void mark_body(const std::int32_t* squares, std::int32_t* marks, int columns) {
  for (int c = 0; c < columns; ++c) marks[c] = 2 * squares[c] < squares[c - 1] + squares[c + 1] + 2 ? 1 : 0;
  for (int k = 2; k <= farthest_pair; k *= 2) {
    for (int c = 0; c < columns; ++c) marks[c] &= 2 * squares[c] < squares[c - k] + squares[c + k] + 2 * k * k ? 1 : 0;
  }
}

/// One parabola over the cells where it is lowest.
[[gnu::always_inline]] inline void fill_body(std::int32_t* out, int begin, int end, int place, std::int32_t height) {
  for (int c = begin; c < end; ++c) out[c] = (c - place) * (c - place) + height;
}

#if defined(__x86_64__)
WAYWRIGHT_AVX2 void step_down_avx2(std::int16_t* carry, const std::uint8_t* blocked, std::int16_t* out, int columns) { step_down_body(carry, blocked, out, columns); }
WAYWRIGHT_AVX2 void step_up_avx2(std::int16_t* carry, std::int16_t* row, int columns) { step_up_body(carry, row, columns); }
WAYWRIGHT_AVX2 void square_avx2(const std::int16_t* vertical, std::int32_t* squares, int columns) { square_body(vertical, squares, columns); }
WAYWRIGHT_AVX2 int outward_avx2(const std::int32_t* squares, std::int32_t* out) { return outward_body(squares, out); }
WAYWRIGHT_AVX2 void mark_avx2(const std::int32_t* squares, std::int32_t* marks, int columns) { mark_body(squares, marks, columns); }
WAYWRIGHT_AVX2 void fill_avx2(std::int32_t* out, int begin, int end, int place, std::int32_t height) { fill_body(out, begin, end, place, height); }
const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
#define WAYWRIGHT_BEST(name, ...) (has_avx2 ? name##_avx2(__VA_ARGS__) : name##_body(__VA_ARGS__))
#else
#define WAYWRIGHT_BEST(name, ...) name##_body(__VA_ARGS__)
#endif

}  // namespace

void step_down(std::int16_t* carry, const std::uint8_t* blocked, std::int16_t* out, int columns) { WAYWRIGHT_BEST(step_down, carry, blocked, out, columns); }
void step_up(std::int16_t* carry, std::int16_t* row, int columns) { WAYWRIGHT_BEST(step_up, carry, row, columns); }

Workspace::Workspace(int columns, bool is_bounded)
    : columns_{columns}, is_bounded_{is_bounded}, squares_(static_cast<std::size_t>(columns) + 2 * pad + block, far_square),
      place_(static_cast<std::size_t>(columns) + 2), height_(static_cast<std::size_t>(columns) + 2),
      marks_(static_cast<std::size_t>(columns)), kept_(static_cast<std::size_t>(columns) + 3) {
  if (is_bounded) squares_[pad - 1] = 0;
}

void Workspace::row(const std::int16_t* vertical, std::int32_t* out) {
  std::int32_t* squares = squares_.data() + pad;
  WAYWRIGHT_BEST(square, vertical, squares, columns_);
  if (is_bounded_) squares[columns_] = 0;
  int reached = 0;
  int blocks = 0;
  if (reach_ <= long_reach) {
    for (int c = 0; c < columns_; c += block, ++blocks) {
      std::int32_t rest[block];
      const bool is_whole = c + block <= columns_;
      const int far_off = WAYWRIGHT_BEST(outward, squares + c, is_whole ? out + c : rest);
      if (far_off < 0) {
        reach_ = farthest;
        break;
      }
      if (!is_whole) std::copy(rest, rest + (columns_ - c), out + c);
      reached += far_off;
    }
    if (blocks * block >= columns_) {
      reach_ = reached / blocks;
      return;
    }
  }
  envelope(out);
}

/// The lower envelope of the row's parabolas, left to right. Each is dropped again where the next one is lower before it has been lowest.
void Workspace::envelope(std::int32_t* out) {
  const std::int32_t* squares = squares_.data() + pad;
  std::int32_t* place = place_.data();
  std::int32_t* height = height_.data();
  // Which may be lowest somewhere: of far ones none, and the blocked cells beside a bounded row always.
  std::int32_t* marks = marks_.data();
  WAYWRIGHT_BEST(mark, squares, marks, columns_);
  int kept = 0;
  if (is_bounded_) kept_[static_cast<std::size_t>(kept++)] = -1;
  for (int c = 0; c < columns_; ++c) {
    kept_[static_cast<std::size_t>(kept)] = c;
    kept += marks[c] & static_cast<std::int32_t>(squares[c] != far_square);
  }
  if (is_bounded_) kept_[static_cast<std::size_t>(kept++)] = columns_;
  int top = -1;
  for (int i = 0; i < kept; ++i) {
    const int q = kept_[static_cast<std::size_t>(i)];
    const std::int64_t h = squares[q];
    // (x − p)² + h meets (x − q)² + h' at (h' + q² − h − p²) / 2(q − p).
    while (top > 0) {
      const std::int64_t p1 = place[top - 1], p2 = place[top];
      const std::int64_t a = height[top] + p2 * p2 - height[top - 1] - p1 * p1;
      const std::int64_t b = h + static_cast<std::int64_t>(q) * q - height[top] - p2 * p2;
      if (a * (q - p2) < b * (p2 - p1)) break;
      --top;
    }
    ++top;
    place[top] = q;
    height[top] = static_cast<std::int32_t>(h);
  }
  if (top < 0) {
    std::fill(out, out + columns_, DistanceField::nowhere);
    return;
  }
  int begin = 0;
  std::int64_t sum = 0;
  for (int i = 0; i <= top && begin < columns_; ++i) {
    int end = columns_;
    if (i < top) {
      // The first cell where the next one is as low: rounded up.
      const std::int64_t p1 = place[i], p2 = place[i + 1];
      const std::int64_t over = height[i + 1] + p2 * p2 - height[i] - p1 * p1;
      const std::int64_t under = 2 * (p2 - p1);
      end = over <= 0 ? 0 : static_cast<int>(std::min<std::int64_t>((over + under - 1) / under, columns_));
      if (end <= begin) continue;
    }
    WAYWRIGHT_BEST(fill, out, begin, end, place[i], height[i]);
    begin = end;
  }
  // Look outwards again in the next row where that would have been enough here.
  for (int c = 0; c < columns_; c += block) sum += out[c];
  const std::int64_t seen = (columns_ + block - 1) / block;
  reach_ = sum < seen * long_reach * long_reach / 2 ? long_reach : farthest;
}

}  // namespace waywright::distance_rows
