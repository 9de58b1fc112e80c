#include "waywright/geometry/box_table.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr double bins_a_box = 4.0;
constexpr double most_a_side = 256.0;
constexpr double least_bin = 0.01;  // m: so that rounding of coordinates is far below a bin
constexpr double grown = 1e-9;      // of a box's half circumference

}  // namespace

BoxTable::BoxTable(const std::vector<Box>& boxes) {
  if (boxes.empty()) return;
  std::vector<Box> all = boxes;
  for (Box& box : all) {
    const double by = grown * (1.0 + (box.high.x - box.low.x) + (box.high.y - box.low.y));
    box.low = box.low - Vec2{by, by};
    box.high = box.high + Vec2{by, by};
  }
  bounds_ = all.front();
  for (const Box& box : all) {
    bounds_.low = {std::min(bounds_.low.x, box.low.x), std::min(bounds_.low.y, box.low.y)};
    bounds_.high = {std::max(bounds_.high.x, box.high.x), std::max(bounds_.high.y, box.high.y)};
  }
  const double width = bounds_.high.x - bounds_.low.x, height = bounds_.high.y - bounds_.low.y;
  bin_ = std::max({least_bin, std::sqrt(width * height / (bins_a_box * static_cast<double>(boxes.size()))), std::max(width, height) / most_a_side});
  columns_ = static_cast<int>(width / bin_) + 1;
  rows_ = static_cast<int>(height / bin_) + 1;
  begins_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  const auto for_each_bin = [&](const auto& visit) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (int row = row_of(all[i].low.y); row <= row_of(all[i].high.y); ++row) {
        for (int column = column_of(all[i].low.x); column <= column_of(all[i].high.x); ++column) {
          visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column), static_cast<std::uint32_t>(i));
        }
      }
    }
  };
  for_each_bin([&](std::size_t at, std::uint32_t) { ++begins_[at + 1]; });
  for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
  boxes_.resize(begins_.back());
  std::vector<std::uint32_t> next = begins_;
  for_each_bin([&](std::size_t at, std::uint32_t box) { boxes_[next[at]++] = box; });
}

// Clamped first: what is left is cut off as floor would have it.
int BoxTable::column_of(double x) const { return static_cast<int>(std::clamp((x - bounds_.low.x) / bin_, 0.0, columns_ - 1.0)); }
int BoxTable::row_of(double y) const { return static_cast<int>(std::clamp((y - bounds_.low.y) / bin_, 0.0, rows_ - 1.0)); }

BoxTable::Bin BoxTable::bin(int column, int row) const {
  const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  return {boxes_.data() + begins_[at], boxes_.data() + begins_[at + 1]};
}

BoxTable::Bin BoxTable::at(Vec2 point) const {
  if (columns_ == 0 || !bounds_.contains(point)) return {};
  return bin(column_of(point.x), row_of(point.y));
}

void BoxTable::along(Vec2 from, Vec2 to, std::vector<std::uint32_t>& found) const {
  found.clear();
  if (columns_ == 0) return;
  const Vec2 a = from.y <= to.y ? from : to, b = from.y <= to.y ? to : from;
  const double low_x = std::min(a.x, b.x), high_x = std::max(a.x, b.x);
  if (b.y < bounds_.low.y || a.y > bounds_.high.y || high_x < bounds_.low.x || low_x > bounds_.high.x) return;
  const double rise = b.y - a.y;
  const bool is_level = !(rise > 1e-3 * bin_);  // then the row's part of it is not worth its rounding
  int bins = 0;
  for (int row = row_of(a.y); row <= row_of(b.y); ++row) {
    double first = low_x, last = high_x;
    if (!is_level) {
      const double bottom = bounds_.low.y + row * bin_;
      const auto x_at = [&](double y) { return a.x + std::clamp((y - a.y) / rise, 0.0, 1.0) * (b.x - a.x); };
      // Of the lowest and the topmost row what lies beyond the table is clamped into it: they begin and end with the way.
      const double low = row == 0 ? a.x : x_at(bottom), high = row == rows_ - 1 ? b.x : x_at(bottom + bin_);
      first = std::min(low, high);
      last = std::max(low, high);
    }
    // A bin more on either side than rounding could matter.
    const int begin = std::max(0, column_of(first) - 1), end = std::min(columns_ - 1, column_of(last) + 1);
    for (int column = begin; column <= end; ++column) {
      const Bin here = bin(column, row);
      found.insert(found.end(), here.begin(), here.end());
      ++bins;
    }
  }
  if (bins > 1) {
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }
}

}  // namespace waywright
