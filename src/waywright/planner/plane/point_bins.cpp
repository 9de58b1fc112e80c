#include "waywright/planner/plane/point_bins.hpp"

namespace waywright {
namespace {

constexpr std::size_t first_bins = 64;
constexpr std::size_t growth = 4;
constexpr std::size_t most_bins = 1U << 22U;

}  // namespace

void PointBins::clear(const Box& region) {
  region_ = region;
  points_.clear();
  next_.clear();
  arrange(first_bins);
}

void PointBins::arrange(std::size_t bins) {
  const Vec2 size = region_.high - region_.low;
  const double width = std::max(size.x, 1e-9), height = std::max(size.y, 1e-9);
  side_ = std::max(std::sqrt(width * height / static_cast<double>(bins)), std::max(width, height) / static_cast<double>(bins));
  per_metre_ = 1.0 / side_;
  columns_ = static_cast<int>(width * per_metre_) + 1;
  rows_ = static_cast<int>(height * per_metre_) + 1;
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), none);
  for (std::size_t i = points_.size(); i-- > 0;) {  // those added first come first
    std::uint32_t& first = first_[bin(column_of(points_[i].x), row_of(points_[i].y))];
    next_[i] = first;
    first = static_cast<std::uint32_t>(i);
  }
}

std::uint32_t PointBins::add(Vec2 point) {
  const auto index = static_cast<std::uint32_t>(points_.size());
  points_.push_back(point);
  std::uint32_t& first = first_[bin(column_of(point.x), row_of(point.y))];
  next_.push_back(first);
  first = index;
  if (points_.size() > 2 * first_.size() && first_.size() < most_bins) arrange(growth * first_.size());
  return index;
}

void PointBins::look(int column, int row, Vec2 to, double& best, std::uint32_t& found) const {
  for (std::uint32_t i = first_[bin(column, row)]; i != none; i = next_[i]) {
    const double d = squared_norm(points_[i] - to);
    if (d < best || (d == best && i < found)) {
      best = d;
      found = i;
    }
  }
}

std::uint32_t PointBins::nearest(Vec2 to) const {
  std::uint32_t found = none;
  double best = std::numeric_limits<double>::infinity();
  const int c = column_of(to.x), r = row_of(to.y);
  // How far what lies outside of ring k is from the point: k bins, and to the edge of its own one.
  const double left = to.x - (region_.low.x + c * side_), below = to.y - (region_.low.y + r * side_);
  const double inside = std::min(std::min(left, side_ - left), std::min(below, side_ - below));
  const int last = std::max(std::max(c, columns_ - 1 - c), std::max(r, rows_ - 1 - r));
  for (int k = 0; k <= last; ++k) {
    if (k > 0) {
      const double clear = inside + (k - 1) * side_;
      if (clear > 0.0 && clear * clear > best) break;
    }
    const int c0 = c - k, c1 = c + k, r0 = r - k, r1 = r + k;
    for (int column = std::max(0, c0); column <= std::min(columns_ - 1, c1); ++column) {
      if (r0 >= 0) look(column, r0, to, best, found);
      if (k > 0 && r1 < rows_) look(column, r1, to, best, found);
    }
    for (int row = std::max(0, r0 + 1); row <= std::min(rows_ - 1, r1 - 1); ++row) {
      if (c0 >= 0) look(c0, row, to, best, found);
      if (c1 < columns_) look(c1, row, to, best, found);
    }
  }
  return found;
}

}  // namespace waywright
