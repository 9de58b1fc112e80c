#include "waywright/planner/plane/view.hpp"

#include <algorithm>
#include <array>

namespace waywright {
namespace {

constexpr double wider = 1.0 + 1e-9;  // for rounding

/// Where a ray meets the line through a and b; not a number or not positive where it does not.
double distance_along(Vec2 ray, Vec2 a, Vec2 b) {
  const Vec2 edge = b - a;
  return cross(a, edge) / cross(ray, edge);
}

}  // namespace

Vec2 PlaneView::direction(double around) {
  const double a = around < 4.0 ? around : around - 4.0;
  const Vec2 v = a < 1.0 ? Vec2{1.0 - a, a} : a < 2.0 ? Vec2{1.0 - a, 2.0 - a} : a < 3.0 ? Vec2{a - 3.0, 2.0 - a} : Vec2{a - 3.0, a - 4.0};
  return (1.0 / norm(v)) * v;
}

PlaneView::PlaneView(const PlaneSpace& space, Vec2 from) : space_{&space}, from_{from}, bins_(count) {
  const Box& region = space.region();
  farthest_ = norm(Vec2{std::max(region.high.x - from.x, from.x - region.low.x), std::max(region.high.y - from.y, from.y - region.low.y)});
  hide_behind_edges();
}

/// An edge that spans a whole bin hides everything in it that is farther than the edge. One pass over the map's edges.
void PlaneView::hide_behind_edges() {
  constexpr int bins = static_cast<int>(count);
  std::vector<Vec2> borders;
  for (int i = 0; i <= bins; ++i) borders.push_back(direction(4.0 * i / bins));
  for (const Segment& s : space_->problem().world().index().segments()) {
    Vec2 a = s.a - from_, b = s.b - from_;
    if (cross(a, b) < 0.0) std::swap(a, b);  // counter-clockwise, by less than half a turn
    if (!(cross(a, b) > 0.0)) continue;
    const auto first = static_cast<int>(std::ceil(around(a) * (bins / 4))), last = static_cast<int>(std::floor(around(b) * (bins / 4)));
    const int spanned = last >= first ? last - first : last + bins - first;
    if (spanned > bins / 2) continue;  // no whole bin, told as nearly all
    for (int k = 0; k < spanned; ++k) {
      const auto i = static_cast<std::size_t>((first + k) % bins);
      const double near = distance_along(borders[i], a, b), far = distance_along(borders[i + 1], a, b);
      const double least = std::max(near, far) * wider;
      if (near > 0.0 && far > 0.0 && std::isfinite(least)) bins_[i].hidden = std::min(bins_[i].hidden, least * least);
    }
  }
}

bool PlaneView::hides(Vec2 middle, double radius) {
  const Vec2 to = middle - from_;
  const double away = norm(to);
  if (!(away > wider * radius)) return false;
  // Between the tangents to the disc; one bin more on either side, for rounding. They are less than half a turn apart.
  const double sine = radius / away, cosine = std::sqrt(std::max(0.0, 1.0 - sine * sine));
  const std::size_t first = index(cosine * to - sine * left_of(to)) + count - 1, last = index(cosine * to + sine * left_of(to)) + 1;
  const double nearest = (away - radius) * (away - radius) / wider;
  for (std::size_t k = 0, bins = (last + 2 * count - first) % count + 1; k < bins; ++k) {
    const std::size_t i = (first + k) % count;
    if (bins_[i].hidden < nearest) continue;
    if (bins_[i].seen < 0.0) fill(i);
    if (!(bins_[i].hidden < nearest)) return false;
  }
  return true;
}

/// Of bins beside each other, whose rays do not wait for each other's look-ups. Rays of a bin are off its middle by no more than `spread` times their length.
void PlaneView::fill(std::size_t i) {
  const std::size_t first = i - i % together;
  Bin* const bins = &bins_[first];
  const double each = 4.0 / static_cast<double>(count), little = 0.25 * space_->table_cell();
  std::array<Vec2, together> middle;
  std::array<double, together> spread, t{};
  for (std::size_t k = 0; k < together; ++k) {
    const double at = static_cast<double>(first + k) * each;
    middle[k] = direction(at + 0.5 * each);
    spread[k] = wider * std::max(distance(direction(at), middle[k]), distance(direction(at + each), middle[k])) + 1e-12;
  }
  // All rays are free as far as the middle has room for the spread, too.
  std::array<bool, together> goes_on;
  goes_on.fill(true);
  for (bool is_any = true; is_any;) {
    is_any = false;
    for (std::size_t k = 0; k < together; ++k) {
      const double room = space_->room(from_ + t[k] * middle[k]) - t[k] * spread[k];
      goes_on[k] = goes_on[k] & (t[k] < farthest_) & (room > little);
      t[k] += goes_on[k] ? room / (1.0 + spread[k]) : 0.0;
      is_any |= goes_on[k];
    }
  }
  for (std::size_t k = 0; k < together; ++k) bins[k].seen = t[k] * t[k] / wider;
  // The first place that is too near to something whatever the ray: what is behind it is hidden.
  goes_on.fill(true);
  for (bool is_any = true; is_any;) {
    is_any = false;
    for (std::size_t k = 0; k < together; ++k) {
      goes_on[k] = goes_on[k] && t[k] < farthest_ && t[k] * t[k] < bins[k].hidden;
      if (!goes_on[k]) continue;
      const Vec2 here = from_ + t[k] * middle[k];
      is_any = true;
      goes_on[k] = !space_->is_surely_blocked(here, t[k] * spread[k]);
      if (goes_on[k]) t[k] += std::max(space_->room(here), 2.0 * little);
      else bins[k].hidden = t[k] * t[k] * wider;
    }
  }
}

}  // namespace waywright
