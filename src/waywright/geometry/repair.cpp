// Which rings can be used, which can be mended safely, and what is wrong with the others.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/geometry/crossing.hpp"
#include "waywright/geometry/polygon.hpp"

namespace waywright {
namespace {

constexpr double least_angle = 1e-12;  // rad: edges that fold back by less enclose nothing but rounding
constexpr double least_share = 1e-12;  // width that a ring must have, of its size
constexpr double rounding = 1e-15;     // of the greatest coordinate: a few units in the last place

/// Neighbouring edges that run back over each other: a spike without width.
bool folds_back(Vec2 before, Vec2 corner, Vec2 after) {
  const Vec2 in = corner - before;
  const Vec2 out = after - corner;
  return dot(in, out) < 0.0 && std::abs(cross(in, out)) <= least_angle * norm(in) * norm(out);
}

std::optional<std::string> find_spike(const Ring& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t corner = (i + 1) % n;
    if (!folds_back(ring[i], ring[corner], ring[(i + 2) % n])) continue;
    return fmt::format("the outline folds back on itself at corner {}, ({:g}, {:g})", corner, ring[corner].x,
                       ring[corner].y);
  }
  return std::nullopt;
}

/// All corners on one line, up to rounding.
bool is_flat(const Ring& ring) {
  const Box box = bounding_box(ring);
  const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const double far =
      std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  return !(least_width(ring) > least_share * size + rounding * far);
}

}  // namespace

RingRepair repair_ring(Ring ring) {
  RingRepair repair;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (is_finite(ring[i])) continue;
    repair.refused = fmt::format("corner {} has a coordinate that is not finite", i);
    return repair;
  }
  const std::size_t given = ring.size();
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (const std::size_t dropped = given - ring.size(); dropped > 0) {
    repair.mended.push_back(fmt::format("{} duplicate corner{} removed", dropped, dropped == 1 ? "" : "s"));
  }
  if (ring.size() < 3) {
    repair.refused =
        fmt::format("a polygon needs at least 3 different corners and this one has {}", ring.size());
    return repair;
  }
  if (is_flat(ring)) {
    repair.refused = "the polygon has no area";
    return repair;
  }
  if (auto spike = find_spike(ring)) {
    repair.refused = std::move(spike);
    return repair;
  }
  if (auto crossing = find_crossing(ring)) {
    repair.refused = std::move(crossing);
    return repair;
  }
  const double area = signed_area(ring);
  if (!(std::abs(area) > 0.0)) {  // too small for its square to be a number
    repair.refused = "the polygon has no area";
    return repair;
  }
  if (area < 0.0) {
    std::reverse(ring.begin() + 1, ring.end());  // the first corner stays the first
    repair.mended.emplace_back("clockwise order reversed");
  }
  repair.ring = std::move(ring);
  return repair;
}

}  // namespace waywright
