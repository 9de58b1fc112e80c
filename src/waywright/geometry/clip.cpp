// Clipping by Boost.Geometry, each answer checked.
//
// The library's rescaling to integers costs half of the digits, so it is off. Without it corners within
// rounding of the cutting line can mislead it (whole pieces lost, or the cutting box returned), so every
// answer is held against an independent measure of the area; where it fails, the line is moved by parts in
// 1e10 of the ring's size, which brings it clear of those corners.
#define BOOST_GEOMETRY_NO_ROBUSTNESS
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <algorithm>
#include <array>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>

#include "waywright/geometry/polygon.hpp"

namespace waywright {
namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, false, true>;  // counter-clockwise, closed

constexpr double nudge = 1e-10;          // of the ring's size
constexpr double area_tolerance = 1e-9;  // of the ring's area
constexpr double sliver = 1e-9;          // of the ring's size: thinner pieces are rounding, not room
constexpr std::array<double, 9> nudges{0.0, 1.0, -1.0, 2.0, -2.0, 4.0, -4.0, 8.0, -8.0};

BoostPolygon to_boost(const Ring& ring) {
  BoostPolygon polygon;
  for (const Vec2 p : ring) bg::append(polygon.outer(), BoostPoint{p.x, p.y});
  bg::append(polygon.outer(), BoostPoint{ring.front().x, ring.front().y});
  return polygon;
}

/// Ring ∩ {x ≥ limit} after Sutherland and Hodgman (1974): pieces of a concave ring stay joined by edges of
/// no width along the line, which add nothing to the area.
Ring joined_clip(const Ring& ring, double limit) {
  Ring clipped;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i];
    const Vec2 b = ring[(i + 1) % ring.size()];
    if (a.x >= limit) clipped.push_back(a);
    if ((a.x >= limit) != (b.x >= limit)) {
      clipped.push_back({limit, a.y + (limit - a.x) / (b.x - a.x) * (b.y - a.y)});
    }
  }
  return clipped;
}

std::vector<Ring> boost_clip(const Ring& ring, const Box& box, double limit) {
  const double beyond = 1.0 + (box.high.x - box.low.x) + (box.high.y - box.low.y);
  const Ring half_plane = rectangle({limit, box.low.y - beyond}, {box.high.x + beyond, box.high.y + beyond});
  std::vector<BoostPolygon> pieces;
  bg::intersection(to_boost(ring), to_boost(half_plane), pieces);
  std::vector<Ring> rings;
  for (const BoostPolygon& piece : pieces) {
    Ring clipped;
    for (const BoostPoint& p : piece.outer()) clipped.push_back({p.x(), p.y()});
    if (clipped.size() > 1) clipped.pop_back();  // Boost repeats the first corner
    rings.push_back(std::move(clipped));
  }
  return rings;
}

/// Simple counter-clockwise pieces inside the ring's box, of the right area altogether.
bool is_right(const std::vector<Ring>& pieces, const Box& box, double area, double tolerance) {
  const double slack = 1e-9 * (box.high.x - box.low.x + box.high.y - box.low.y);
  const Box outer{box.low - Vec2{slack, slack}, box.high + Vec2{slack, slack}};
  double sum = 0.0;
  for (const Ring& piece : pieces) {
    if (!std::all_of(piece.begin(), piece.end(), [&](Vec2 p) { return outer.contains(p); })) return false;
    const RingRepair repair = repair_ring(piece);
    if (repair.refused || signed_area(piece) <= 0.0) return false;
    sum += signed_area(piece);
  }
  return std::abs(sum - area) <= tolerance;
}

}  // namespace

std::vector<Ring> clip_half_plane(const Ring& ring, Vec2 normal, double offset) {
  const double length = norm(normal);
  if (ring.size() < 3 || !(length > 0.0)) return {};
  // In a frame with its x axis along the normal the half-plane is x ≥ offset / |normal|.
  const Frame frame{make_pose({}, angle_of(normal))};
  Ring local;
  for (const Vec2 p : ring) local.push_back(frame.to_local(p));
  const Box box = bounding_box(local);
  const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const double line = offset / length;
  if (box.low.x >= line - sliver * size) return {ring};
  if (box.high.x <= line + sliver * size) return {};

  const double tolerance = area_tolerance * signed_area(local);
  std::vector<Ring> pieces;
  bool right = false;
  for (std::size_t i = 0; i < nudges.size() && !right; ++i) {
    const double limit = line + nudges[i] * nudge * size;
    pieces = boost_clip(local, box, limit);
    std::erase_if(pieces, [&](const Ring& p) {
      return p.size() < 3 || bounding_box(p).high.x <= limit + sliver * size;
    });
    right = is_right(pieces, box, signed_area(joined_clip(local, limit)), tolerance);
  }
  if (!right) pieces = {joined_clip(local, line)};
  // A fixed order whatever order the library finds them in, the same in every frame: along the line, from its
  // right.
  std::sort(pieces.begin(), pieces.end(), [](const Ring& a, const Ring& b) {
    const Box p = bounding_box(a);
    const Box q = bounding_box(b);
    return p.low.y < q.low.y || (p.low.y == q.low.y && p.low.x < q.low.x);
  });
  for (Ring& piece : pieces) piece = transformed(piece, frame);
  return pieces;
}

}  // namespace waywright
