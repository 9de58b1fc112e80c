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

/// The direction whose number is `around`, see PlaneView::around.
Vec2 direction(double around) {
  const double a = around < 4.0 ? around : around - 4.0;
  const Vec2 v = a < 1.0 ? Vec2{1.0 - a, a} : a < 2.0 ? Vec2{1.0 - a, 2.0 - a} : a < 3.0 ? Vec2{a - 3.0, 2.0 - a} : Vec2{a - 3.0, a - 4.0};
  return (1.0 / norm(v)) * v;
}

/// Rays between two borders are off the middle one by no more than `spread` times their length.
struct Fan {
  Vec2 middle;
  double spread;
};
std::vector<Fan> fans_of(std::size_t count) {
  const double each = 4.0 / static_cast<double>(count);
  std::vector<Fan> fans;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = static_cast<double>(i) * each;
    const Vec2 middle = direction(at + 0.5 * each);
    fans.push_back({middle, wider * std::max(distance(direction(at), middle), distance(direction(at + each), middle)) + 1e-12});
  }
  return fans;
}
std::vector<Vec2> borders_of(std::size_t count) {
  std::vector<Vec2> borders;
  for (std::size_t i = 0; i <= count; ++i) borders.push_back(direction(4.0 * static_cast<double>(i) / static_cast<double>(count)));
  return borders;
}

/// Squared, from a point to the line from a to b.
double squared_distance(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a, to = p - a;
  const double squared = squared_norm(along);
  const double share = squared > 0.0 ? std::clamp(dot(to, along) / squared, 0.0, 1.0) : 0.0;
  return squared_norm(to - share * along);
}

}  // namespace

PlaneView::PlaneView(const PlaneSpace& space, Vec2 from) : space_{&space}, from_{from}, bins_(count), is_free_{space.is_free(from)}, seen_squares_(count), hidden_squares_(count), bundles_(count / bundle, -1.0) {
  const Box& region = space.region();
  farthest_ = norm(Vec2{std::max(region.high.x - from.x, from.x - region.low.x), std::max(region.high.y - from.y, from.y - region.low.y)});
  hide_behind_edges();
  tell(0, count);
}

/// An edge that spans a whole bin hides everything in it that is farther than the edge. One pass over the map's edges.
void PlaneView::hide_behind_edges() {
  constexpr int bins = static_cast<int>(count);
  static const std::vector<Vec2> borders = borders_of(count);
  for (const Segment& s : space_->problem().world().index().segments()) {
    Vec2 a = s.a - from_, b = s.b - from_;
    if (cross(a, b) < 0.0) std::swap(a, b);  // counter-clockwise, by less than half a turn
    if (!(cross(a, b) > 0.0)) continue;
    const auto first = static_cast<int>(std::ceil(around(a) * (bins / 4))), last = static_cast<int>(std::floor(around(b) * (bins / 4)));
    const int spanned = last >= first ? last - first : last + bins - first;
    if (spanned > bins / 2) continue;  // no whole bin, told as nearly all
    double far = distance_along(borders[static_cast<std::size_t>(first % bins)], a, b);
    for (int k = 0; k < spanned; ++k) {
      const auto i = static_cast<std::size_t>((first + k) % bins);
      const double near = far;
      far = distance_along(borders[i + 1], a, b);
      const double least = std::max(near, far) * wider;
      if (near > 0.0 && far > 0.0 && std::isfinite(least)) bins_[i].hidden = std::min(bins_[i].hidden, least * least);
    }
  }
}

/// What of an edge and of what is needed around it comes into a bin lies between the tangents from the place to the discs about the edge's ends.
void PlaneView::gather_edges() {
  is_gathered_ = true;
  const double needed = wider * space_->needed() + 1e-9;
  struct Range {
    std::size_t first, bins;
  };
  std::vector<Range> ranges;
  first_.assign(count + 1, 0);
  for (const Segment& s : space_->problem().world().index().segments()) {
    Edge edge{s.a - from_, s.b - from_, 0.0};
    if (cross(edge.a, edge.b) < 0.0) std::swap(edge.a, edge.b);
    edge.near = std::sqrt(squared_distance({}, edge.a, edge.b)) / wider;
    Range range{0, count};
    if (edge.near > wider * needed) {
      const auto tangent = [&](Vec2 end, double side) {
        const double sine = needed / norm(end), cosine = std::sqrt(std::max(0.0, 1.0 - sine * sine));
        return cosine * end + side * sine * left_of(end);
      };
      const Vec2 right_a = tangent(edge.a, -1.0), right_b = tangent(edge.b, -1.0), left_a = tangent(edge.a, 1.0), left_b = tangent(edge.b, 1.0);
      const std::size_t first = index(cross(right_a, right_b) >= 0.0 ? right_a : right_b) + count - 1, last = index(cross(left_a, left_b) >= 0.0 ? left_b : left_a) + 1;
      range = {first % count, (last + 2 * count - first) % count + 1};
    }
    edges_.push_back(edge);
    ranges.push_back(range);
    for (std::size_t k = 0; k < range.bins; ++k) ++first_[(range.first + k) % count + 1];
  }
  for (std::size_t i = 0; i < count; ++i) first_[i + 1] += first_[i];
  of_bin_.resize(first_[count]);
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t e = 0; e < ranges.size(); ++e) {
    for (std::size_t k = 0; k < ranges[e].bins; ++k) of_bin_[next[(ranges[e].first + k) % count]++] = static_cast<std::uint32_t>(e);
  }
}

/// Nothing solid is entered from a free place without coming too near to an edge.
bool PlaneView::sees_beyond(Vec2 point) {
  if (!is_free_) return false;
  if (!is_gathered_) gather_edges();
  const Vec2 to = point - from_;
  const double away = norm(to), needed = space_->needed();
  if (!(away > 0.0)) return true;
  const Vec2 along = (1.0 / away) * to;
  const std::size_t bin = index(to);
  for (std::uint32_t k = first_[bin]; k < first_[bin + 1]; ++k) {
    const Edge& edge = edges_[of_bin_[k]];
    if (edge.near > away + needed) continue;
    const double a = cross(along, edge.a), b = cross(along, edge.b);
    if (std::min(a, b) > needed || std::max(a, b) < -needed) continue;
    if (std::min(a, b) <= 0.0 && std::max(a, b) >= 0.0 && a != b) {  // it meets the whole line: where?
      const double at = dot(along, edge.a + (a / (a - b)) * (edge.b - edge.a));
      if (at >= 0.0 && at <= away) return false;
    }
    const double least = std::min(std::min(squared_distance(edge.a, {}, to), squared_distance(edge.b, {}, to)), std::min(squared_distance({}, edge.a, edge.b), squared_distance(to, edge.a, edge.b)));
    if (least <= needed * needed) return false;
  }
  return true;
}

/// Of bins and what is beside them, as their neighbours allow.
void PlaneView::tell(std::size_t first, std::size_t bins) {
  constexpr double single = 1e-5;  // of a square, more than rounding is
  const auto seen = [&](std::size_t i) {
    const double all = bundles_[i / bundle];
    return std::max(bins_[i].seen, all > 0.0 ? all * all : 0.0);
  };
  std::size_t before = (first + count - 2) % count, at = (first + count - 1) % count;
  double seen_before = seen(before), seen_here = seen(at), hidden_before = bins_[before].hidden, hidden_here = bins_[at].hidden;
  for (std::size_t k = 0; k < bins + 2; ++k) {
    const std::size_t after = (at + 1) % count;
    const double seen_after = seen(after), hidden_after = bins_[after].hidden;
    seen_squares_[at] = static_cast<float>((1.0 - single) * std::min({seen_before, seen_here, seen_after}));
    hidden_squares_[at] = static_cast<float>((1.0 + single) * std::max({hidden_before, hidden_here, hidden_after}));
    seen_before = seen_here, seen_here = seen_after, hidden_before = hidden_here, hidden_here = hidden_after;
    at = after;
  }
}

PlaneView::Seen PlaneView::seen_from_all(Vec2 middle, double radius) {
  const Vec2 to = middle - from_;
  const double away = norm(to), farthest = wider * (away + radius);
  if (!(away > wider * radius)) return space_->room(from_) > farthest ? Seen::yes : Seen::not_told;
  // Between the tangents to the disc; one bin more on either side, for rounding. They are less than half a turn apart.
  const double sine = radius / away, cosine = std::sqrt(std::max(0.0, 1.0 - sine * sine));
  const std::size_t first = index(cosine * to - sine * left_of(to)) + count - 1, last = index(cosine * to + sine * left_of(to)) + 1;
  const std::size_t bins = (last + 2 * count - first) % count + 1;
  if (bundle_seen((first + bins / 2) % count / bundle) > farthest) {
    for (std::size_t k = 0; k < bins; k += bundle) {
      if (!(bundle_seen((first + k) % count / bundle) > farthest)) return Seen::not_told;
    }
    return bundle_seen(last % count / bundle) > farthest ? Seen::yes : Seen::not_told;
  }
  const double nearest = (away - radius) * (away - radius) / wider;
  for (std::size_t k = 0; k < bins; ++k) {
    const std::size_t i = (first + k) % count;
    if (bins_[i].hidden < nearest) continue;
    if (bins_[i].seen < 0.0) fill(i);
    if (!(bins_[i].hidden < nearest)) return Seen::not_told;
  }
  return Seen::no;
}

/// As far as the middle of a bundle has room for the spread, too.
double PlaneView::bundle_seen(std::size_t b) {
  double& seen = bundles_[b];
  if (seen >= 0.0) return seen;
  static const std::vector<Fan> fans = fans_of(count / bundle);
  const auto [middle, spread] = fans[b];
  const double little = space_->table_cell();
  double t = 0.0;
  while (t < farthest_) {
    const double room = space_->room(from_ + t * middle) - t * spread;
    if (!(room > little)) break;
    t += room / (1.0 + spread);
  }
  seen = t / wider;
  tell(b * bundle, bundle);
  return seen;
}

/// Of bins beside each other, whose rays do not wait for each other's look-ups, from where their bundle ends on.
void PlaneView::fill(std::size_t i) {
  const std::size_t first = i - i % together;
  Bin* const bins = &bins_[first];
  static const std::vector<Fan> all = fans_of(count);
  const Fan* const fans = &all[first];
  const double little = 0.25 * space_->table_cell();
  std::array<double, together> t;
  t.fill(bundle_seen(first / bundle));
  // All rays are free as far as the middle has room for the spread, too.
  std::array<bool, together> goes_on;
  goes_on.fill(true);
  for (bool is_any = true; is_any;) {
    is_any = false;
    for (std::size_t k = 0; k < together; ++k) {
      const double room = space_->room(from_ + t[k] * fans[k].middle) - t[k] * fans[k].spread;
      goes_on[k] = goes_on[k] & (t[k] < farthest_) & (room > little);
      t[k] += goes_on[k] ? room / (1.0 + fans[k].spread) : 0.0;
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
      const Vec2 here = from_ + t[k] * fans[k].middle;
      is_any = true;
      goes_on[k] = !space_->is_surely_blocked(here, t[k] * fans[k].spread);
      if (goes_on[k]) t[k] += std::max(space_->room(here), 2.0 * little);
      else bins[k].hidden = t[k] * t[k] * wider;
    }
  }
  tell(first, together);
}

}  // namespace waywright
