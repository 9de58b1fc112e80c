#include "waywright/planner/plane/shadow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double wider = 1e-9;  // of the distance, for rounding

/// Where a ray meets the line through a and b; not a number or not positive where it does not.
double distance_along(Vec2 ray, Vec2 a, Vec2 b) {
  const Vec2 edge = b - a;
  return cross(a, edge) / cross(ray, edge);
}

}  // namespace

Vec2 Shadow::direction(double around) {
  const double a = around < 4.0 ? around : around - 4.0;
  const Vec2 v = a < 1.0 ? Vec2{1.0 - a, a} : a < 2.0 ? Vec2{1.0 - a, 2.0 - a} : a < 3.0 ? Vec2{a - 3.0, 2.0 - a} : Vec2{a - 3.0, a - 4.0};
  return (1.0 / norm(v)) * v;
}

Shadow::Shadow(const PlaneSpace& space, Vec2 light) : light_{light}, squares_(bins, std::numeric_limits<double>::infinity()) {
  std::vector<Vec2> borders;
  for (int i = 0; i <= bins; ++i) borders.push_back(direction(4.0 * i / bins));
  for (const Segment& s : space.problem().world().index().segments()) {
    Vec2 a = s.a - light, b = s.b - light;
    if (cross(a, b) < 0.0) std::swap(a, b);  // counter-clockwise, by less than half a turn
    if (!(cross(a, b) > 0.0)) continue;
    const auto first = static_cast<int>(std::ceil(around(a) * (bins / 4))), last = static_cast<int>(std::floor(around(b) * (bins / 4)));
    const int count = last >= first ? last - first : last + bins - first;
    if (count > bins / 2) continue;  // no whole bin, told as nearly all
    for (int k = 0; k < count; ++k) {
      const int i = (first + k) % bins;
      const double near = distance_along(borders[static_cast<std::size_t>(i)], a, b), far = distance_along(borders[static_cast<std::size_t>(i) + 1], a, b);
      const double least = std::max(near, far) * (1.0 + wider);
      if (!(near > 0.0) || !(far > 0.0) || !std::isfinite(least)) continue;
      double& square = squares_[static_cast<std::size_t>(i)];
      square = std::min(square, least * least);
    }
  }
}

}  // namespace waywright
