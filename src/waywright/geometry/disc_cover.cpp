#include "waywright/geometry/disc_cover.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/geometry/obstacle_index.hpp"

namespace waywright {
namespace {

/// Box of the part of the ring with low ≤ axis ≤ high: corners inside and crossings of the two cuts.
Box slab_box(const Ring& ring, double Vec2::* axis, double low, double high) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{{infinity, infinity}, {-infinity, -infinity}};
  const auto add = [&](Vec2 p) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i];
    const Vec2 b = ring[(i + 1) % ring.size()];
    if (a.*axis >= low && a.*axis <= high) add(a);
    for (const double cut : {low, high}) {
      if ((a.*axis < cut) == (b.*axis < cut)) continue;
      Vec2 p = a + ((cut - a.*axis) / (b.*axis - a.*axis)) * (b - a);
      p.*axis = cut;
      add(p);
    }
  }
  return box;
}

}  // namespace

std::vector<CoverDisc> disc_cover(const Ring& ring, double bulge, int most) {
  const Box box = bounding_box(ring);
  const Vec2 size = box.high - box.low;
  double Vec2::* axis = size.x >= size.y ? &Vec2::x : &Vec2::y;
  double Vec2::* across = size.x >= size.y ? &Vec2::y : &Vec2::x;
  std::vector<CoverDisc> discs;
  for (int slabs = 1; slabs <= most; ++slabs) {
    discs.clear();
    double worst = 0.0;
    const double thickness = size.*axis / slabs;
    for (int k = 0; k < slabs; ++k) {
      const double low = box.low.*axis + k * thickness;
      const Box slab = slab_box(ring, axis, low, k + 1 == slabs ? box.high.*axis : low + thickness);
      if (!(slab.low.x <= slab.high.x)) continue;
      const Vec2 half = 0.5 * (slab.high - slab.low);
      const Vec2 center = 0.5 * (slab.high + slab.low);
      const double radius = norm(half) * (1.0 + 1e-12);
      worst = std::max(worst, radius - half.*across);
      discs.push_back({center, radius, inner_radius(ring, center)});
    }
    if (worst <= bulge) break;
  }
  return discs;
}

}  // namespace waywright
