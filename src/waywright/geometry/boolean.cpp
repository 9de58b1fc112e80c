#define BOOST_GEOMETRY_NO_ROBUSTNESS
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include "waywright/geometry/boolean.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>

namespace waywright {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, false, true>;  // counter-clockwise, closed
using BoostArea = bg::model::multi_polygon<BoostPolygon>;

constexpr double area_tolerance = 1e-9;  // of both areas
constexpr double sliver = 1e-9;          // of an area: less is rounding

BoostPolygon to_boost(const Ring& ring) {
  BoostPolygon polygon;
  for (const Vec2 p : ring) bg::append(polygon.outer(), BoostPoint{p.x, p.y});
  bg::append(polygon.outer(), BoostPoint{ring.front().x, ring.front().y});
  return polygon;
}

double area_of(const std::vector<BoostPolygon>& pieces) {
  double area = 0.0;
  for (const BoostPolygon& piece : pieces) area += bg::area(piece);
  return area;
}

/// Simple counter-clockwise rings, slivers left out; empty where a piece has a hole or cannot be used.
std::optional<std::vector<Ring>> rings_of(const std::vector<BoostPolygon>& pieces, double whole) {
  std::vector<Ring> rings;
  for (const BoostPolygon& piece : pieces) {
    if (bg::area(piece) <= sliver * whole) continue;
    if (!piece.inners().empty()) return std::nullopt;
    Ring ring;
    for (const BoostPoint& p : piece.outer()) ring.push_back({p.x(), p.y()});
    RingRepair repair = repair_ring(std::move(ring));
    if (repair.refused) return std::nullopt;
    rings.push_back(std::move(repair.ring));
  }
  return rings;
}

/// With their holes.
std::optional<std::vector<Region>> regions_of(const std::vector<BoostPolygon>& pieces, double whole) {
  std::vector<Region> regions;
  const auto ring_of = [](const auto& points) {
    Ring ring;
    for (const BoostPoint& p : points) ring.push_back({p.x(), p.y()});
    return repair_ring(std::move(ring));
  };
  for (const BoostPolygon& piece : pieces) {
    if (bg::area(piece) <= sliver * whole) continue;
    RingRepair outer = ring_of(piece.outer());
    if (outer.refused) return std::nullopt;
    Region region{std::move(outer.ring), {}};
    for (const auto& inner : piece.inners()) {
      if (std::abs(bg::area(inner)) <= sliver * whole) continue;
      RingRepair hole = ring_of(inner);
      if (hole.refused) return std::nullopt;
      region.holes.push_back(std::move(hole.ring));
    }
    regions.push_back(std::move(region));
  }
  return regions;
}

}  // namespace

std::optional<std::vector<Region>> without(const Ring& a, const std::vector<Ring>& others, const std::function<bool()>& stops) {
  BoostArea rest;
  rest.push_back(to_boost(a));
  const double whole = signed_area(a);
  for (const Ring& ring : others) {
    if (stops && stops()) return std::nullopt;
    BoostArea next, common;
    const BoostPolygon one = to_boost(ring);
    bg::difference(rest, one, next);
    bg::intersection(rest, one, common);
    if (std::abs(area_of(next) + area_of(common) - area_of(rest)) > area_tolerance * whole) return std::nullopt;
    rest = std::move(next);
  }
  return regions_of(rest, whole);
}

std::optional<Ring> joined(const Ring& a, const Ring& b) {
  std::vector<BoostPolygon> both, common;
  bg::union_(to_boost(a), to_boost(b), both);
  bg::intersection(to_boost(a), to_boost(b), common);
  const double whole = signed_area(a) + signed_area(b);
  if (std::abs(area_of(both) + area_of(common) - whole) > area_tolerance * whole) return std::nullopt;
  auto rings = rings_of(both, whole);
  if (!rings || rings->size() != 1) return std::nullopt;
  return rings->front();
}

std::optional<std::vector<Ring>> without(const Ring& a, const Ring& b) {
  std::vector<BoostPolygon> rest, common;
  bg::difference(to_boost(a), to_boost(b), rest);
  bg::intersection(to_boost(a), to_boost(b), common);
  const double whole = signed_area(a);
  if (std::abs(area_of(rest) + area_of(common) - whole) > area_tolerance * whole) return std::nullopt;
  return rings_of(rest, whole);
}

}  // namespace waywright
