// The generalised Voronoi diagram of segments and points: where two of them are equally near, and none is nearer.
//
// Built by Boost.Polygon (Fortune's sweep, S. Fortune: A sweepline algorithm for Voronoi diagrams, Algorithmica 2 (1987), for segments), which wants whole numbers and
// segments that meet at their ends alone. So places are rounded to a grid of `unit()`, and segments that cross, touch or lie on each other are cut where they do, until
// none does (each cut is rounded again).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "waywright/geometry/obstacle_index.hpp"

namespace waywright {

/// What lies on one side of an edge: the inside of a segment, or a point (a == b), be it a segment's end.
struct VoronoiSite {
  Vec2 a{}, b{};
  bool is_point() const { return a == b; }
};

/// Between two vertices. Straight where both sites are points or both are segments, else a part of a parabola with the point as its focus and the segment's line as its
/// directrix.
struct VoronoiEdge {
  std::uint32_t from = 0, to = 0;
  VoronoiSite left, right;
  bool is_straight() const { return left.is_point() == right.is_point(); }
};

struct VoronoiPlace {
  Vec2 at{};
  double clearance = 0.0;  ///< m, to the sites of its edge
};

/// Immutable once made.
///
/// Laws: at each place of an edge its two sites are equally far, and no other one is nearer, up to error(); the clearance falls to both sides across the edge. Edges are
/// not there that lead to infinity, that part a segment from its own end, or that end blindly and are ridges flatter than `flat` (what rounding and chords of curves make
/// of a straight wall). All others are, so that what is between the sites, where it is bounded, is as connected as its edges are.
class VoronoiDiagram {
 public:
  static constexpr double least_unit = 0x1p-20;  ///< m; of maps wider than 512 m the 2⁻²⁹th part of their width
  static constexpr double flat = 0.01;           ///< rad, between the directions to the two sites

  /// Empty where rounding and cutting did not come to an end (segments that cross by the thousand within a few units).
  static std::optional<VoronoiDiagram> of(std::span<const Segment> segments);

  double unit() const { return unit_; }    ///< m
  double error() const { return error_; }  ///< m, that no site is off by more from what was given
  const std::vector<VoronoiSite>& sites() const { return sites_; }  ///< segments and points alone, as rounded and cut
  const std::vector<Vec2>& vertices() const { return vertices_; }
  const std::vector<VoronoiEdge>& edges() const { return edges_; }

  /// Places along an edge, both ends among them: none farther than `spacing` from the next, the edge nowhere farther than `sagitta` from the line between them; the one of
  /// least clearance is one of them, so that the clearance rises or falls all the way between two. @pre spacing, sagitta > 0
  std::vector<VoronoiPlace> places(const VoronoiEdge& edge, double spacing, double sagitta) const;

 private:
  VoronoiDiagram() = default;
  void prune();

  double unit_ = 0.0, error_ = 0.0;
  std::vector<VoronoiSite> sites_;
  std::vector<Vec2> vertices_;
  std::vector<VoronoiEdge> edges_;
};

double distance(const VoronoiSite& site, Vec2 from);
Vec2 nearest(const VoronoiSite& site, Vec2 to);

/// Where the tangents in two places of a curved edge meet: the control point of the quadratic Bézier curve that the edge is between them. Empty of a straight edge, or one
/// that is too narrow to tell from a line.
std::optional<Vec2> control_point(const VoronoiEdge& edge, Vec2 from, Vec2 to);

}  // namespace waywright
