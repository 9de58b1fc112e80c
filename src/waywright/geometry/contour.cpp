#include "waywright/geometry/contour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "waywright/geometry/obstacle_index.hpp"

namespace waywright {
namespace {

constexpr std::int64_t none = -1;

/// Edges have numbers: from a node to the right 2·node, up 2·node + 1. A level's line goes from edge to edge, through one square each time.
class Contours {
 public:
  Contours(std::span<const double> values, int columns, int rows, double level)
      : values_{values}, columns_{columns}, level_{level}, next_(2 * values.size(), none), has_before_(2 * values.size(), 0) {
    for (int row = 0; row + 1 < rows; ++row) {
      for (int column = 0; column + 1 < columns; ++column) add_square(column, row);
    }
  }

  std::vector<ContourLine> lines() {
    std::vector<ContourLine> all;
    for (std::size_t edge = 0; edge < next_.size(); ++edge) {
      if (next_[edge] != none && has_before_[edge] == 0) all.push_back(follow(edge));
    }
    for (std::size_t edge = 0; edge < next_.size(); ++edge) {  // what has no beginning is closed
      if (next_[edge] != none) all.push_back(follow(edge));
    }
    return all;
  }

 private:
  std::size_t node(int column, int row) const { return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column); }

  void add_square(int column, int row) {
    // Counter-clockwise; the edge after each corner leads to the next one.
    const std::array<std::size_t, 4> corners{node(column, row), node(column + 1, row), node(column + 1, row + 1), node(column, row + 1)};
    const std::array<std::size_t, 4> edges{2 * corners[0], 2 * corners[1] + 1, 2 * corners[3], 2 * corners[0] + 1};
    std::array<bool, 4> above{};
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!std::isfinite(values_[corners[k]])) return;
      above[k] = values_[corners[k]] >= level_;
      sum += 0.25 * values_[corners[k]];
    }
    // A line comes out of the edge where the way around goes down, and into one where it goes up: past the lower corner between them where what is above is joined.
    const bool joins_above = sum >= level_;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!above[k] || above[(k + 1) % 4]) continue;
      const auto goes_up = [&](std::size_t edge) { return !above[edge] && above[(edge + 1) % 4]; };
      std::size_t to = k;
      do to = (to + (joins_above ? 1 : 3)) % 4;
      while (!goes_up(to));
      next_[edges[k]] = static_cast<std::int64_t>(edges[to]);
      has_before_[edges[to]] = 1;
    }
  }

  Vec2 point(std::size_t edge) const {
    const std::size_t from = edge / 2, to = edge % 2 == 0 ? from + 1 : from + static_cast<std::size_t>(columns_);
    const double a = values_[from], b = values_[to], share = std::clamp((level_ - a) / (b - a), 0.0, 1.0);
    const auto column = static_cast<double>(from % static_cast<std::size_t>(columns_)), row = static_cast<double>(from / static_cast<std::size_t>(columns_));
    return edge % 2 == 0 ? Vec2{column + share, row} : Vec2{column, row + share};
  }

  ContourLine follow(std::size_t first) {
    ContourLine line;
    std::size_t edge = first;
    for (;;) {
      line.points.push_back(point(edge));
      const std::int64_t to = std::exchange(next_[edge], none);
      if (to == none) return line;
      edge = static_cast<std::size_t>(to);
      if (edge == first) {
        line.is_closed = true;
        return line;
      }
    }
  }

  std::span<const double> values_;
  int columns_;
  double level_;
  std::vector<std::int64_t> next_;
  std::vector<std::uint8_t> has_before_;
};

}  // namespace

std::vector<ContourLine> contour_lines(std::span<const double> values, int columns, int rows, double level) {
  if (columns < 2 || rows < 2) return {};
  return Contours{values, columns, rows, level}.lines();
}

Polyline simplified(const Polyline& line, double tolerance) {
  if (line.size() < 3) return line;
  std::vector<std::uint8_t> is_kept(line.size(), 0);
  is_kept.front() = is_kept.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> waiting{{0, line.size() - 1}};
  while (!waiting.empty()) {
    const auto [first, last] = waiting.back();
    waiting.pop_back();
    std::size_t farthest = first;
    double off = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      if (const double away = point_segment_distance(line[i], line[first], line[last]); away > off) off = away, farthest = i;
    }
    if (farthest == first) continue;
    is_kept[farthest] = 1;
    waiting.emplace_back(first, farthest);
    waiting.emplace_back(farthest, last);
  }
  Polyline kept;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (is_kept[i] != 0) kept.push_back(line[i]);
  }
  return kept;
}

}  // namespace waywright
