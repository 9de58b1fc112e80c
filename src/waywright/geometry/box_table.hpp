// Which of many boxes may be near a point or a straight way: bins over all of them.
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// Immutable; safe to read from many threads.
///
/// Law: a box that a point lies in, or that a way comes nearer to than a billionth of the box's half circumference, is always among those found; others may be.
class BoxTable {
 public:
  BoxTable() = default;
  explicit BoxTable(const std::vector<Box>& boxes);

  /// Numbers of boxes that may hold the point: those of one bin, rising.
  struct Bin {
    const std::uint32_t* first = nullptr;
    const std::uint32_t* last = nullptr;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
  };
  Bin at(Vec2 point) const;

  /// Numbers of boxes that the straight way may come near, rising, each once; in place of what `found` held.
  void along(Vec2 from, Vec2 to, std::vector<std::uint32_t>& found) const;

 private:
  Bin bin(int column, int row) const;
  int column_of(double x) const;
  int row_of(double y) const;

  Box bounds_{};
  double bin_ = 0.0;  ///< m
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> begins_, boxes_;
};

}  // namespace waywright
