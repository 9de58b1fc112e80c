#include "waywright/planner/field/tree_world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/geometry/obstacle_index.hpp"

namespace waywright {
namespace {

constexpr int corners_of_disc = 256;   // of a polygon around a disc, that the collars of others keep from
constexpr double model_share = 0.2;    // of the distance to the model's nearest rim and to its goal, that a step in it is long at most
constexpr double model_step = 0.01;    // of the model's radius
constexpr int halvings = 40;

/// The second after the first.
PlaneImage composed(const PlaneImage& second, const PlaneImage& first) {
  return {second.at, second.xx * first.xx + second.xy * first.yx, second.xx * first.xy + second.xy * first.yy, second.yx * first.xx + second.yy * first.yx,
          second.yx * first.xy + second.yy * first.yy};
}

std::optional<Vec2> centre_of(const Ring& ring) {
  const Ring kernel = kernel_of(ring);
  if (kernel.empty()) return std::nullopt;
  return largest_circle_in(kernel).centre;
}

/// Touches an obstacle's disc from outside, the outer one from inside.
Ring polygon_of(const Disc& disc, bool is_outside) {
  Ring ring;
  const double radius = is_outside ? disc.radius : disc.radius / sin_cos(pi / corners_of_disc).cos;
  for (int i = 0; i < corners_of_disc; ++i) ring.push_back(disc.centre + radius * unit(i * (two_pi / corners_of_disc)));
  return ring;
}

}  // namespace

tl::expected<TreeMap, std::string> TreeMap::of(const Ring& outside, const std::vector<Ring>& obstacles, const std::function<bool()>& stops) {
  using tl::unexpected;
  auto trees = star_trees(outside, obstacles, stops);
  if (!trees) return unexpected{trees.error()};
  TreeMap map;
  map.leaves_ = std::move(trees->purges);
  map.rims_.push_back(outside);
  map.rims_.insert(map.rims_.end(), obstacles.begin(), obstacles.end());
  // Rims as they are now; each star that is made to a disc is one to those that come after.
  std::vector<Ring> now = std::move(trees->stars);
  now.push_back(std::move(trees->outside));
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (stops && stops()) return unexpected<std::string>{"not all stars were made to discs"};
    const bool is_outside = i + 1 == now.size();
    const auto centre = centre_of(now[i]);
    if (!centre) return unexpected{is_outside ? std::string{"of the boundary no star is left"} : fmt::format("of the obstacle at ({:.3f}, {:.3f}) no star is left", now[i].front().x, now[i].front().y)};
    std::vector<Ring> others = now;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    map.stars_.emplace_back(now[i], *centre, is_outside, others);
    const Disc& disc = map.stars_.back().disc();
    now[i] = polygon_of(disc, is_outside);
    if (is_outside) map.model_.outside = disc;
    else map.model_.obstacles.push_back(disc);
  }
  return map;
}

PlaneImage TreeMap::at(Vec2 q) const {
  PlaneImage image{q};
  for (const LeafPurge& leaf : leaves_) image = composed(leaf.at(image.at), image);
  for (const StarRounding& star : stars_) image = composed(star.at(image.at), image);
  return image;
}

Vec2 TreeMap::back(Vec2 q) const {
  for (std::size_t i = stars_.size(); i-- > 0;) q = stars_[i].back(q);
  for (std::size_t i = leaves_.size(); i-- > 0;) q = leaves_[i].back(q);
  return q;
}

bool TreeMap::is_free(Vec2 q) const {
  if (!contains(rims_.front(), q)) return false;
  return std::none_of(rims_.begin() + 1, rims_.end(), [&](const Ring& ring) { return contains(ring, q); });
}

bool TreeMap::is_free(Vec2 from, Vec2 to) const {
  const Vec2 along = to - from;
  const auto meets = [&](Vec2 a, Vec2 b) {
    const double side_a = cross(along, a - from), side_b = cross(along, b - from), before = cross(b - a, from - a), after = cross(b - a, to - a);
    return ((side_a >= 0.0) != (side_b >= 0.0) || side_a == 0.0 || side_b == 0.0) && ((before >= 0.0) != (after >= 0.0) || before == 0.0 || after == 0.0) &&
           std::max(std::min(a.x, b.x), std::min(from.x, to.x)) <= std::min(std::max(a.x, b.x), std::max(from.x, to.x)) &&
           std::max(std::min(a.y, b.y), std::min(from.y, to.y)) <= std::min(std::max(a.y, b.y), std::max(from.y, to.y));
  };
  return std::none_of(rims_.begin(), rims_.end(), [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (meets(ring[i], ring[(i + 1) % ring.size()])) return true;
    }
    return false;
  });
}

double TreeMap::distance_to_rim(Vec2 q) const {
  if (!is_free(q)) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const Ring& ring : rims_) {
    for (std::size_t i = 0; i < ring.size(); ++i) least = std::min(least, point_segment_distance(q, ring[i], ring[(i + 1) % ring.size()]));
  }
  return least;
}

Vec2 TreeNavigation::slope(Vec2 q) const {
  const PlaneImage image = map_->at(q);
  const Vec2 g = function_.slope(image.at);
  return {image.xx * g.x + image.yx * g.y, image.xy * g.x + image.yy * g.y};
}

Vec2 TreeNavigation::next(Vec2 q, double longest) const {
  const Vec2 at = map_->at(q).at, g = function_.slope(at);
  const double steep = norm(g), rim = function_.distance_to_rim(at);
  if (!(steep > 0.0) || !std::isfinite(steep) || !(rim > 0.0)) return q;
  double step = std::min({model_step * function_.world().outside.radius, model_share * rim, distance(at, function_.goal())});
  for (int k = 0; k < halvings; ++k, step *= 0.5) {
    const Vec2 to = map_->back(at - (step / steep) * g);
    if (distance(q, to) <= longest && map_->is_free(q, to)) return to;
  }
  return q;
}

std::optional<Vec2> TreeNavigation::way_off(Vec2 q) const {
  const PlaneImage j = map_->at(q);
  const auto way = waywright::way_off(function_.curvature(j.at));
  if (!way) return std::nullopt;
  const Vec2 back{j.yy * way->x - j.xy * way->y, j.xx * way->y - j.yx * way->x};
  return (1.0 / norm(back)) * back;
}

std::optional<Vec2> TreeNavigation::minimum_near(Vec2 q, double within) const {
  const auto at = waywright::minimum_near([&](Vec2 p) { return function_.slope(p); }, [&](Vec2 p) { return function_.curvature(p); }, [&](Vec2 p) { return function_.distance_to_rim(p); }, map_->at(q).at, within);
  if (!at) return std::nullopt;
  return map_->back(*at);
}

}  // namespace waywright
