#include "waywright/scenario/zone_rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/geometry/obstacle_index.hpp"
#include "waywright/geometry/stretches.hpp"

namespace waywright {
namespace {

constexpr double on_outline = 1e-6;  // m

Box box_of(Vec2 a, Vec2 b) { return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}}; }

/// Inside, and farther than on_outline from every edge: most edges are told to be farther by their box.
bool is_inside(const ZoneRules::Weighed& zone, Vec2 point) {
  if (!zone.box.contains(point) || !contains(zone.area, point)) return false;
  constexpr double clearly = 2.0 * on_outline;
  for (std::size_t i = 0; i < zone.area.size(); ++i) {
    const Vec2 a = zone.area[i], b = zone.area[i + 1 == zone.area.size() ? 0 : i + 1];
    if ((a.x < point.x - clearly && b.x < point.x - clearly) || (a.x > point.x + clearly && b.x > point.x + clearly)) continue;
    if ((a.y < point.y - clearly && b.y < point.y - clearly) || (a.y > point.y + clearly && b.y > point.y + clearly)) continue;
    if (!(point_segment_distance(point, a, b) > on_outline)) return false;
  }
  return true;
}

double bounded(double product) { return std::clamp(product, ZoneRules::least_product, ZoneRules::most_product); }

/// The least (or greatest) product that zones of one kind can have at a point: at most those whose boxes meet overlap there.
double extreme_product(const std::vector<ZoneRules::Weighed>& zones, bool least) {
  double extreme = 1.0;
  for (const ZoneRules::Weighed& zone : zones) {
    if ((zone.factor < 1.0) != least) continue;
    double product = 1.0;
    for (const ZoneRules::Weighed& other : zones) {
      if ((other.factor < 1.0) == least && meet(zone.box, other.box)) product = bounded(product * other.factor);
    }
    extreme = least ? std::min(extreme, product) : std::max(extreme, product);
  }
  return extreme;
}

}  // namespace

ZoneRules::ZoneRules(const std::vector<Zone>& zones) {
  for (std::size_t i = 0; i < zones.size(); ++i) {
    const Zone& zone = zones[i];
    const Box box = bounding_box(zone.area);
    switch (zone.type) {
      case ZoneType::forbidden: break;
      case ZoneType::directed: directed_.push_back({title_of(zone, i), zone.area, box, zone.direction, unit(zone.direction)}); break;
      case ZoneType::preferred:
      case ZoneType::penalty: weighed_.push_back({zone.area, box, zone.factor}); break;
      case ZoneType::speed_limit: {
        World area;
        area.add_obstacle(zone.area, title_of(zone, i));
        area.build();
        limits_.push_back({title_of(zone, i), std::move(area), box, zone.speed});
        break;
      }
    }
  }
  const auto boxes_of = [](const auto& zones_of_a_kind) {
    std::vector<Box> boxes;
    for (const auto& zone : zones_of_a_kind) boxes.push_back(zone.box);
    return boxes;
  };
  directed_near_ = BoxTable{boxes_of(directed_)};
  weighed_near_ = BoxTable{boxes_of(weighed_)};
  least_factor_ = extreme_product(weighed_, true);
  most_factor_ = extreme_product(weighed_, false);
}

double ZoneRules::factor_at(Vec2 point) const {
  double product = 1.0;
  for (const std::uint32_t i : weighed_near_.at(point)) {
    if (is_inside(weighed_[i], point)) product *= weighed_[i].factor;
  }
  return bounded(product);
}

double ZoneRules::cost(Vec2 from, Vec2 to) const {
  const double length = distance(from, to);
  const Box box = box_of(from, to);
  std::vector<double> shares{0.0, 1.0};
  std::vector<std::uint32_t> found;
  weighed_near_.along(from, to, found);
  std::vector<const Weighed*> near;
  for (const std::uint32_t i : found) {
    const Weighed& zone = weighed_[i];
    if (!meet(zone.box, box)) continue;
    near.push_back(&zone);
    add_crossings(zone.area, from, to, shares);
  }
  if (near.empty()) return length;
  const auto factor_there = [&](Vec2 point) {
    double product = 1.0;
    for (const Weighed* zone : near) {
      if (is_inside(*zone, point)) product *= zone->factor;
    }
    return bounded(product);
  };
  std::sort(shares.begin(), shares.end());
  double more = 0.0;  // than the length, as a share of it: exactly none where no zone is
  for (std::size_t i = 1; i < shares.size(); ++i) {
    const double part = shares[i] - shares[i - 1];
    if (part > 0.0) more += part * (factor_there(from + 0.5 * (shares[i - 1] + shares[i]) * (to - from)) - 1.0);
  }
  return (1.0 + more) * length;
}

bool ZoneRules::may_be_driven(Vec2 from, Vec2 to) const {
  if (from == to) return true;
  const Box box = box_of(from, to);
  std::vector<std::uint32_t> found;
  directed_near_.along(from, to, found);
  return std::all_of(found.begin(), found.end(), [&](std::uint32_t i) {
    const Directed& zone = directed_[i];
    return !meet(zone.box, box) || !zone.is_against(to - from, planned_course) || stretches_deeper_than(zone.area, planned_depth, from, to).empty();
  });
}

}  // namespace waywright
