// Which rings can be used, which can be mended safely, and what is wrong with the others.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "waywright/geometry/polygon.hpp"

namespace waywright {
namespace {

constexpr double least_angle = 1e-12;  // rad: edges that fold back by less enclose nothing but rounding
constexpr double least_share = 1e-12;  // width that a ring must have, of its size
constexpr double rounding = 1e-15;     // of the greatest coordinate: a few units in the last place

int sign_of_turn(Vec2 a, Vec2 b, Vec2 c) {
  const double turn = cross(b - a, c - a);
  return turn > 0.0 ? 1 : turn < 0.0 ? -1 : 0;
}

bool on_segment(Vec2 p, Vec2 a, Vec2 b) { return sign_of_turn(a, b, p) == 0 && dot(p - a, p - b) <= 0.0; }

struct Meeting {
  Vec2 point{};
  bool crosses = false;  ///< through each other, rather than touching or lying on one another
};

/// A common point of two closed segments.
std::optional<Meeting> meeting(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const int abc = sign_of_turn(a, b, c);
  const int abd = sign_of_turn(a, b, d);
  const int cda = sign_of_turn(c, d, a);
  const int cdb = sign_of_turn(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) {
    return Meeting{a + (cross(c - a, d - c) / cross(b - a, d - c)) * (b - a), true};
  }
  if (on_segment(c, a, b)) return Meeting{c, false};
  if (on_segment(d, a, b)) return Meeting{d, false};
  if (on_segment(a, c, d)) return Meeting{a, false};
  if (on_segment(b, c, d)) return Meeting{b, false};
  return std::nullopt;
}

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

/// The first pair of edges that meet where they should not, by a sweep over x.
std::optional<std::string> find_crossing(const Ring& ring) {
  const std::size_t n = ring.size();
  const auto low = [&](std::size_t i) { return std::min(ring[i].x, ring[(i + 1) % n].x); };
  const auto high = [&](std::size_t i) { return std::max(ring[i].x, ring[(i + 1) % n].x); };
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return low(a) < low(b) || (low(a) == low(b) && a < b); });
  std::vector<std::size_t> active;
  for (const std::size_t i : order) {
    std::erase_if(active, [&](std::size_t k) { return high(k) < low(i); });
    const Vec2 a = ring[i];
    const Vec2 b = ring[(i + 1) % n];
    for (const std::size_t k : active) {
      const Vec2 c = ring[k];
      const Vec2 d = ring[(k + 1) % n];
      if (std::min(a.y, b.y) > std::max(c.y, d.y) || std::max(a.y, b.y) < std::min(c.y, d.y)) continue;
      if ((i + 1) % n == k || (k + 1) % n == i)
        continue;  // neighbours share a corner; spikes are looked for before
      const auto met = meeting(a, b, c, d);
      if (!met) continue;
      return fmt::format("edges {} and {} {} at ({:g}, {:g})", std::min(i, k), std::max(i, k),
                         met->crosses ? "cross" : "touch", met->point.x, met->point.y);
    }
    active.push_back(i);
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
