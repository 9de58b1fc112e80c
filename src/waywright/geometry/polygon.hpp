// Rings (closed polygons without holes) and what is asked of them.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "waywright/core/pose.hpp"

namespace waywright {

/// Corners in order; the closing edge from back() to front() is implied. Counter-clockwise once repaired.
using Ring = std::vector<Vec2>;
using Polyline = std::vector<Vec2>;

struct Box {
  Vec2 low{};
  Vec2 high{};
  bool contains(Vec2 p) const { return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y; }
};

Box bounding_box(const std::vector<Vec2>& points);  ///< @pre not empty

/// Signed area in m², positive for counter-clockwise.
double signed_area(const Ring& ring);

/// Inside or on the edge. Even-odd rule; exact on the edge up to rounding.
bool contains(std::span<const Vec2> ring, Vec2 point);

/// Radius of the largest disc about the point that the ring's area holds; 0 where the point is not in it.
double inner_radius(const Ring& ring, Vec2 center);

/// Counter-clockwise convex hull without collinear corners.
Ring convex_hull(std::vector<Vec2> points);
/// The same into `hull`, whose memory is reused; `points` are put into another order.
void convex_hull(std::vector<Vec2>& points, Ring& hull);

/// True where the ring is convex (collinear corners allowed).
bool is_convex(const Ring& ring);

/// Least distance between two parallel lines that enclose the points (rotating calipers). 0 for fewer than 3 points.
double least_width(const std::vector<Vec2>& points);

/// Nearest point of the ring's area (the point itself where it lies inside).
Vec2 nearest_in(const Ring& ring, Vec2 point);

/// Rings of ring ∩ half-plane {p : dot(normal, p) ≥ offset}; several where a concave ring falls apart.
/// Clipping is done by Boost.Geometry. @pre ring is simple and counter-clockwise.
std::vector<Ring> clip_half_plane(const Ring& ring, Vec2 normal, double offset);

/// What was mended, or why it cannot be.
struct RingRepair {
  Ring ring;                           ///< counter-clockwise, no duplicate corners
  std::vector<std::string> mended;     ///< "2 duplicate corners removed", "clockwise order reversed"
  std::optional<std::string> refused;  ///< set where the ring cannot be used: "edges 0 and 2 cross at (1, 1)"
};

/// Makes a ring usable where that is safe: duplicate corners and a repeated closing corner are dropped, clockwise order is
/// reversed; crossing edges, spikes of no width and zero area are refused.
RingRepair repair_ring(Ring ring);

Ring transformed(const Ring& ring, const Frame& frame);

/// Rectangle with corners low and high, counter-clockwise.
Ring rectangle(Vec2 low, Vec2 high);

}  // namespace waywright
