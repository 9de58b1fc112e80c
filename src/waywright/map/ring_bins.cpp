#include "waywright/map/ring_bins.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr std::size_t most_entries_per_ring = 8;

std::uint32_t bin_of(double along, double inverse, std::uint32_t count) {
  const double bin = std::floor(along * inverse);
  return bin > 0.0 ? std::min(count - 1, static_cast<std::uint32_t>(std::min(bin, 4e9))) : 0;
}

}  // namespace

RingBins::RingBins(std::span<const Box> boxes) {
  if (boxes.empty()) return;
  bounds_ = boxes.front();
  for (const Box& box : boxes) {
    bounds_.low = {std::min(bounds_.low.x, box.low.x), std::min(bounds_.low.y, box.low.y)};
    bounds_.high = {std::max(bounds_.high.x, box.high.x), std::max(bounds_.high.y, box.high.y)};
  }
  // About four bins a ring; fewer where large rings would be in too many.
  auto side = static_cast<std::uint32_t>(std::ceil(2.0 * std::sqrt(static_cast<double>(std::min<std::size_t>(boxes.size(), 1U << 20)))));
  for (;; side /= 2) {
    columns_ = rows_ = std::max(side, 1U);
    const Vec2 size = bounds_.high - bounds_.low;
    inverse_width_ = size.x > 0.0 ? columns_ / size.x : 0.0;
    inverse_height_ = size.y > 0.0 ? rows_ / size.y : 0.0;
    if (sort_into(boxes, most_entries_per_ring * boxes.size()) || side <= 1) return;
  }
}

/// False, with nothing sorted, where that makes more entries than wanted: of one bin never.
bool RingBins::sort_into(std::span<const Box> boxes, std::size_t most_entries) {
  const auto each_bin = [&](const Box& box, auto&& seen) {
    const std::uint32_t first_column = bin_of(box.low.x - bounds_.low.x, inverse_width_, columns_), last_column = bin_of(box.high.x - bounds_.low.x, inverse_width_, columns_);
    const std::uint32_t first_row = bin_of(box.low.y - bounds_.low.y, inverse_height_, rows_), last_row = bin_of(box.high.y - bounds_.low.y, inverse_height_, rows_);
    for (std::uint32_t row = first_row; row <= last_row; ++row) {
      for (std::uint32_t column = first_column; column <= last_column; ++column) seen(static_cast<std::size_t>(row) * columns_ + column);
    }
  };
  const auto bins_of = [&](const Box& box) {
    const double across = 1.0 + bin_of(box.high.x - bounds_.low.x, inverse_width_, columns_) - bin_of(box.low.x - bounds_.low.x, inverse_width_, columns_);
    const double up = 1.0 + bin_of(box.high.y - bounds_.low.y, inverse_height_, rows_) - bin_of(box.low.y - bounds_.low.y, inverse_height_, rows_);
    return across * up;
  };
  double entries = 0.0;
  for (const Box& box : boxes) entries += bins_of(box);
  if (entries > static_cast<double>(most_entries)) return false;
  begins_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  for (const Box& box : boxes) each_bin(box, [&](std::size_t bin) { ++begins_[bin + 1]; });
  for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
  entries_.resize(begins_.back());
  std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) each_bin(boxes[i], [&](std::size_t bin) { entries_[next[bin]++] = i; });
  return true;
}

std::span<const std::uint32_t> RingBins::near(Vec2 point) const {
  if (entries_.empty() || !bounds_.contains(point)) return {};
  const std::size_t bin = static_cast<std::size_t>(bin_of(point.y - bounds_.low.y, inverse_height_, rows_)) * columns_ + bin_of(point.x - bounds_.low.x, inverse_width_, columns_);
  return {entries_.data() + begins_[bin], entries_.data() + begins_[bin + 1]};
}

}  // namespace waywright
