#include "waywright/geometry/pole.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

namespace waywright {
namespace {

constexpr int most_cells = 4000;

/// m to the outline: over 0 inside, under 0 outside.
double depth(const Ring& ring, Vec2 p) { return contains(ring, p) ? inner_radius(ring, p) : -distance(p, nearest_in(ring, p)); }

struct Cell {
  Vec2 middle{};
  double half = 0.0;
  double depth = 0.0;
  int number = 0;  ///< of two with one bound the older is looked at first
  double bound() const { return depth + half * std::sqrt(2.0); }
  bool operator<(const Cell& other) const { return bound() != other.bound() ? bound() < other.bound() : number > other.number; }
};

Vec2 mean_of(const Ring& ring) {
  Vec2 sum{};
  for (const Vec2 p : ring) sum = sum + p;
  return (1.0 / static_cast<double>(ring.size())) * sum;
}

/// About the first corner, so that nothing cancels far from the origin.
Vec2 centre_of_area(const Ring& ring) {
  double twice = 0.0;
  Vec2 sum{};
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vec2 a = ring[i] - ring.front(), b = ring[i + 1] - ring.front();
    const double part = a.x * b.y - a.y * b.x;
    twice += part;
    sum = sum + part * (a + b);
  }
  return twice != 0.0 ? ring.front() + (1.0 / (3.0 * twice)) * sum : mean_of(ring);
}

}  // namespace

Vec2 pole_of_inaccessibility(const Ring& ring, double precision) {
  const Box box = bounding_box(ring);
  const Vec2 size = box.high - box.low;
  const double side = std::min(size.x, size.y);
  if (ring.size() < 3 || !(side > 0.0) || !std::isfinite(size.x + size.y)) return mean_of(ring);
  const Vec2 centre = centre_of_area(ring);
  Cell best{centre, 0.0, depth(ring, centre), 0};
  std::priority_queue<Cell> open;
  int looked_at = 0;
  const auto look = [&](Vec2 middle, double half) {
    const Cell cell{middle, half, depth(ring, middle), ++looked_at};
    if (cell.depth > best.depth + precision) best = cell;
    if (cell.bound() > best.depth + precision) open.push(cell);
  };
  const double half = std::max(0.5 * side, std::max(size.x, size.y) / 64.0);
  for (double x = box.low.x + half; x - half < box.high.x; x += 2.0 * half) {
    for (double y = box.low.y + half; y - half < box.high.y; y += 2.0 * half) look({x, y}, half);
  }
  while (!open.empty() && looked_at < most_cells) {
    const Cell cell = open.top();
    open.pop();
    if (!(cell.bound() > best.depth + precision)) break;
    const double quarter = 0.5 * cell.half;
    for (const double dx : {-quarter, quarter}) {
      for (const double dy : {-quarter, quarter}) look(cell.middle + Vec2{dx, dy}, quarter);
    }
  }
  return best.middle;
}

}  // namespace waywright
