// Points of the plane in bins, asked for the nearest one and for those within a distance; points are added one after another.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// Bins grow finer with the number of points, so that each has a few, and lie in pieces of eight, coordinates beside each other. One object, one thread. Points
/// outside of the region are taken, too (in its outermost bins).
class PointBins {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Empty, for points of this region. Memory is kept.
  void clear(const Box& region);
  /// Its index: one more than that of the one before.
  std::uint32_t add(Vec2 point);
  std::size_t size() const { return points_.size(); }
  Vec2 operator[](std::uint32_t i) const { return points_[i]; }
  const std::vector<Vec2>& points() const { return points_; }

  /// Of several the one added first. `none` where there is no point.
  std::uint32_t nearest(Vec2 to) const;
  struct Near {
    double squared;  ///< m², the distance's square
    std::uint32_t index;
  };
  /// Those within `radius`, in an order that depends on the points alone.
  void within(Vec2 at, double radius, std::vector<Near>& found) const { found.resize(gather(at, radius, found)); }
  /// The same in the first places of memory that grows and never shrinks: how many there are.
  std::size_t gather(Vec2 at, double radius, std::vector<Near>& memory) const {
    const double squared = radius * radius;
    std::size_t count = 0;
    const int r0 = row_of(at.y - radius), r1 = row_of(at.y + radius);
    for (int row = r0; row <= r1; ++row) {
      const double off = gap(at.y - region_.low.y, row, rows_);
      if (off > radius) continue;
      const double half = std::sqrt(squared - off * off) + slack();  // of the disc's chord
      const int c0 = column_of(at.x - half), c1 = column_of(at.x + half);
      for (int column = c0; column <= c1; ++column) {
        for (std::uint32_t p = first_[bin(column, row)]; p != none; p = pieces_[p].next) {
          const Piece& piece = pieces_[p];
          if (memory.size() < count + wide) memory.resize(2 * (count + wide));
          Near* const out = memory.data();
          std::array<double, wide> d;
          for (std::size_t k = 0; k < wide; ++k) {
            const double dx = piece.x[k] - at.x, dy = piece.y[k] - at.y;
            d[k] = dx * dx + dy * dy;
          }
          for (std::size_t k = 0; k < wide; ++k) {  // each is written, and stays where it is near: no branch to guess
            out[count] = {d[k], piece.index[k]};
            count += d[k] <= squared ? 1 : 0;
          }
        }
      }
    }
    return count;
  }
  /// The same, calling seen(index, squared distance) for each.
  template <class Seen>
  void visit(Vec2 at, double radius, Seen&& seen) const {
    std::vector<Near> found;
    within(at, radius, found);
    for (const Near& n : found) seen(n.index, n.squared);
  }

 private:
  static constexpr std::size_t wide = 8;
  static constexpr double nowhere = std::numeric_limits<double>::infinity();
  struct Piece {
    std::array<double, wide> x{nowhere, nowhere, nowhere, nowhere, nowhere, nowhere, nowhere, nowhere}, y{};
    std::array<std::uint32_t, wide> index{};
    std::uint32_t count = 0;
    std::uint32_t next = none;
  };
  void arrange(std::size_t bins);
  void put(std::uint32_t index);
  int column_of(double x) const { return static_cast<int>(std::clamp((x - region_.low.x) * per_metre_, 0.0, columns_ - 1.0)); }
  int row_of(double y) const { return static_cast<int>(std::clamp((y - region_.low.y) * per_metre_, 0.0, rows_ - 1.0)); }
  std::size_t bin(int column, int row) const { return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column); }
  double slack() const { return 1e-9 * side_; }  // for rounding, where bins are left out
  /// How far a place is from the bins of a row (column), which the outermost ones have no end of; a little less, for rounding.
  double gap(double from_low, int i, int count) const {
    const double below = i > 0 ? i * side_ - from_low : 0.0, above = i + 1 < count ? from_low - (i + 1) * side_ : 0.0;
    return std::max(0.0, std::max(below, above) - slack());
  }
  void look(int column, int row, Vec2 to, double& best, std::uint32_t& found) const;

  Box region_{};
  double side_ = 1.0, per_metre_ = 1.0;
  int columns_ = 1, rows_ = 1;
  std::vector<Vec2> points_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> first_;  ///< piece of each bin: the one that is being filled
};

}  // namespace waywright
