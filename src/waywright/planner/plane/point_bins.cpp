#include "waywright/planner/plane/point_bins.hpp"

namespace waywright {
namespace {

constexpr std::size_t first_bins = 16;
constexpr std::size_t growth = 4;
constexpr std::size_t fullest = 12;  // points a bin on the average
constexpr std::size_t most_bins = 1U << 20U;

}  // namespace

void PointBins::clear(const Box& region) {
  region_ = region;
  points_.clear();
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
  pieces_.clear();
  for (std::uint32_t i = 0; i < points_.size(); ++i) put(i);
}

void PointBins::put(std::uint32_t index) {
  const Vec2 point = points_[index];
  std::uint32_t& first = first_[bin(column_of(point.x), row_of(point.y))];
  if (first == none || pieces_[first].count == wide) {
    pieces_.emplace_back();
    pieces_.back().next = first;
    first = static_cast<std::uint32_t>(pieces_.size() - 1);
  }
  Piece& piece = pieces_[first];
  piece.x[piece.count] = point.x;
  piece.y[piece.count] = point.y;
  piece.index[piece.count++] = index;
}

std::uint32_t PointBins::add(Vec2 point) {
  const auto index = static_cast<std::uint32_t>(points_.size());
  points_.push_back(point);
  if (points_.size() > fullest * first_.size() && first_.size() < most_bins) {
    arrange(growth * first_.size());
  } else {
    put(index);
  }
  return index;
}

void PointBins::look(int column, int row, Vec2 to, double& best, std::uint32_t& found) const {
  const double across = gap(to.x - region_.low.x, column, columns_), up = gap(to.y - region_.low.y, row, rows_);
  if (across * across + up * up > best) return;
  for (std::uint32_t p = first_[bin(column, row)]; p != none; p = pieces_[p].next) {
    const Piece& piece = pieces_[p];
    for (std::uint32_t k = 0; k < piece.count; ++k) {
      const double dx = piece.x[k] - to.x, dy = piece.y[k] - to.y, d = dx * dx + dy * dy;
      if (d < best || (d == best && piece.index[k] < found)) {
        best = d;
        found = piece.index[k];
      }
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
