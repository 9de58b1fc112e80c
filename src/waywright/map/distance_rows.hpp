// The inner loops of the distance transform, a row at a time: plain loops over whole numbers that compilers make vector code of, compiled
// also for AVX2 and chosen when the program runs. Whole numbers: the same values either way.
#pragma once

#include <cstdint>
#include <vector>

namespace waywright::distance_rows {

/// Distance along a column where it has nothing blocked. One more still fits 16 bits, and its square is more than any square between
/// two cells of a grid of DistanceField::longest_side.
inline constexpr std::int16_t far = 32766;

/// From the row above to this one: 0 at blocked cells, else one more. `carry` is the row above, and becomes this one.
void step_down(std::int16_t* carry, const std::uint8_t* blocked, std::int16_t* out, int columns);
/// From the row below: the least of what is there and one more than below.
void step_up(std::int16_t* carry, std::int16_t* row, int columns);

/// Rows of squared distances from rows of distances along columns. The cells beside the row are blocked where `is_bounded`.
class Workspace {
 public:
  Workspace(int columns, bool is_bounded);
  void row(const std::int16_t* vertical, std::int32_t* out);

 private:
  void envelope(std::int32_t* out);

  int columns_;
  bool is_bounded_;
  int reach_ = 0;                      ///< how far the last row's outward search went on average: near rows are alike
  std::vector<std::int32_t> squares_;  ///< of the distances along columns, with far ones on both sides
  std::vector<std::int32_t> place_, height_;  ///< the stack of parabolas
  std::vector<std::int32_t> marks_, kept_;
};

}  // namespace waywright::distance_rows
