// Slow and plain: the clearance of a footprint at one pose or along a path, by Boost.Geometry over every
// obstacle.
//
// It shares nothing with what it is an oracle for but the plain data types: placing, curve evaluation, inside
// tests and distances are its own or the library's. Objects are skipped only where a box or a circle about
// them is farther than the least distance found so far.
#pragma once

#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // of the library's own, where it is inlined
#endif
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include "waywright/map/map.hpp"
#include "waywright/path/path.hpp"
#include "waywright/vehicle/vehicle.hpp"

namespace waywright {

/// m; what is farther away than this counts as this far.
inline constexpr double oracle_cap = 10.0;

namespace oracle {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Point>;
using Line = bg::model::linestring<Point>;

inline Point point(Vec2 p) { return {p.x, p.y}; }

inline Polygon polygon(const std::vector<Vec2>& ring) {
  Polygon made;
  for (const Vec2 p : ring) bg::append(made.outer(), point(p));
  bg::correct(made);  // orientation and closing corner
  return made;
}

inline Line closed_line(const std::vector<Vec2>& ring) {
  Line line;
  for (const Vec2 p : ring) line.push_back(point(p));
  line.push_back(line.front());
  return line;
}

struct Extent {
  double x0, y0, x1, y1;
};

inline Extent extent(const std::vector<Vec2>& points, double grown = 0.0) {
  Extent e{points[0].x, points[0].y, points[0].x, points[0].y};
  for (const Vec2 p : points)
    e = {std::min(e.x0, p.x), std::min(e.y0, p.y), std::max(e.x1, p.x), std::max(e.y1, p.y)};
  return {e.x0 - grown, e.y0 - grown, e.x1 + grown, e.y1 + grown};
}

/// Lower bound on the distance of what lies in the two.
inline double gap(const Extent& a, const Extent& b) {
  const double dx = std::max({0.0, a.x0 - b.x1, b.x0 - a.x1});
  const double dy = std::max({0.0, a.y0 - b.y1, b.y0 - a.y1});
  return std::hypot(dx, dy);
}

/// The footprint somewhere: a polygon, or a centre with a radius.
struct Body {
  bool disc = false;
  double radius = 0.0;
  Point centre;
  Polygon area;
  std::vector<Vec2> corners;  // of the polygon, or the centre
  Extent box{};

  template <class Geometry>
  double distance_to(const Geometry& other) const {
    return disc ? std::max(0.0, bg::distance(centre, other) - radius) : bg::distance(area, other);
  }
};

/// The body frame at a pose.
inline Body place(const Footprint& footprint, double x, double y, double heading) {
  Body body;
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  body.disc = footprint.polygon.empty();
  body.centre = Point{x, y};
  if (body.disc) {
    body.radius = footprint.disc;
    body.corners = {{x, y}};
  } else {
    for (const Vec2 p : footprint.polygon)
      body.corners.push_back({x + c * p.x - s * p.y, y + s * p.x + c * p.y});
    body.area = polygon(body.corners);
  }
  body.box = extent(body.corners, body.radius);
  return body;
}

class Scene {
 public:
  Scene(const Map& map, const std::vector<Ring>& extra_boundaries, const std::vector<Ring>& extra_obstacles,
        const Footprint& footprint)
      : map_{map}, footprint_{footprint} {
    for (const auto* rings : {&map.boundaries, &extra_boundaries}) {
      for (const Ring& ring : *rings) boundaries_.push_back({polygon(ring), closed_line(ring), extent(ring)});
    }
    for (const auto* rings : {&map.obstacles, &extra_obstacles}) {
      for (const Ring& ring : *rings) obstacles_.push_back({polygon(ring), {}, extent(ring)});
    }
    for (const Polyline& line : map.lines) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        lines_.push_back({{}, Line{point(line[i]), point(line[i + 1])}, extent({line[i], line[i + 1]})});
      }
    }
  }

  /// Clearance at a pose; 0 on contact or outside; `limit` where it is at least that.
  double clearance(const Pose& pose, double limit) const {
    const Body body = place(footprint_, pose.x, pose.y, pose.heading);
    double least = limit;
    for (const Object& boundary : boundaries_) {
      if (!bg::within(point(body.corners[0]), boundary.area)) return 0.0;
      least = std::min(least, body.distance_to(boundary.line));
    }
    for (const Object& obstacle : obstacles_) {
      if (gap(obstacle.box, body.box) < least) least = std::min(least, body.distance_to(obstacle.area));
    }
    for (const Object& line : lines_) {
      if (gap(line.box, body.box) < least) least = std::min(least, body.distance_to(line.line));
    }
    for (const Vec2 p : map_.points) {
      if (gap({p.x, p.y, p.x, p.y}, body.box) < least) least = std::min(least, body.distance_to(point(p)));
    }
    for (const CellGrid& grid : map_.grids) least = std::min(least, to_cells(grid, pose, least));
    return std::max(0.0, least);
  }

 private:
  struct Object {
    Polygon area;
    Line line;
    Extent box;
  };

  /// In the grid's own frame, cells are squares along the axes.
  double to_cells(const CellGrid& grid, const Pose& pose, double limit) const {
    const double c = std::cos(grid.origin.heading);
    const double s = std::sin(grid.origin.heading);
    const double dx = pose.x - grid.origin.x;
    const double dy = pose.y - grid.origin.y;
    const Body body =
        place(footprint_, c * dx + s * dy, -s * dx + c * dy, pose.heading - grid.origin.heading);
    double least = limit;
    if (grid.bounds) {
      const double width = grid.columns * grid.cell;
      const double height = grid.rows * grid.cell;
      least = std::min({least, body.box.x0, body.box.y0, width - body.box.x1, height - body.box.y1});
      if (least <= 0.0) return 0.0;
    }
    const auto index = [&](double metres, int count) {
      return static_cast<int>(std::clamp(std::floor(metres / grid.cell), -1.0, static_cast<double>(count)));
    };
    const int column0 = std::max(0, index(body.box.x0 - least, grid.columns));
    const int column1 = std::min(grid.columns - 1, index(body.box.x1 + least, grid.columns));
    const int up0 = std::max(0, index(body.box.y0 - least, grid.rows));  // rows from the bottom
    const int up1 = std::min(grid.rows - 1, index(body.box.y1 + least, grid.rows));
    for (int up = up0; up <= up1; ++up) {
      for (int column = column0; column <= column1; ++column) {
        const auto at =
            static_cast<std::size_t>(grid.rows - 1 - up) * static_cast<std::size_t>(grid.columns) +
            static_cast<std::size_t>(column);
        if (grid.blocked[at] == 0) continue;
        const Extent box{column * grid.cell, up * grid.cell, (column + 1) * grid.cell, (up + 1) * grid.cell};
        if (gap(box, body.box) >= least) continue;
        const Point middle{0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
        if (body.distance_to(middle) - 0.71 * grid.cell >= least) continue;
        least = std::min(
            least, body.distance_to(
                       polygon({{box.x0, box.y0}, {box.x1, box.y0}, {box.x1, box.y1}, {box.x0, box.y1}})));
        if (least <= 0.0) return 0.0;
      }
    }
    return least;
  }

  const Map& map_;
  const Footprint& footprint_;
  std::vector<Object> boundaries_, obstacles_, lines_;
};

/// Poses of one piece by a parameter, evaluated from the definitions of the curves.
class Motion {
 public:
  Motion(const Piece& piece, double radius, double step) : piece_{piece}, radius_{radius}, step_{step} {}

  void collect(std::vector<Pose>& poses) const {
    const double end = parameters();
    const auto n = static_cast<std::size_t>(std::ceil(std::max(1.0, longest() / step_)));
    Pose before = at(0.0);
    poses.push_back(before);
    for (std::size_t i = 1; i <= n; ++i) {
      const double u0 = end * static_cast<double>(i - 1) / static_cast<double>(n);
      const double u1 = end * static_cast<double>(i) / static_cast<double>(n);
      const Pose after = at(u1);
      refine(u0, before, u1, after, 0, poses);
      before = after;
    }
  }

  /// The least of `clearance(pose, limit)` along the motion, or `least` where that is less: poses `coarse` apart first, then between those
  /// that can have something nearer between them, down to `fine`. No point moves farther than what lies between two poses, give or take
  /// the bend; so two clearances tell how little can be between.
  template <class Clearance>
  double least_of(const Clearance& clearance, double coarse, double fine, double least) const {
    const double end = parameters();
    const auto n = static_cast<std::size_t>(std::ceil(std::max(1.0, longest() / coarse)));
    std::vector<Measured> coarsely;
    for (std::size_t i = 0; i <= n; ++i) {
      const double u = end * static_cast<double>(i) / static_cast<double>(n);
      const Pose pose = at(u);
      coarsely.push_back({u, pose, clearance(pose, least + 2.0 * coarse)});
      least = std::min(least, coarsely.back().clearance);
    }
    for (std::size_t i = 0; i < n && least > 0.0; ++i) search(coarsely[i], coarsely[i + 1], clearance, fine, 0, least);
    return least;
  }

 private:
  struct Measured {
    double u = 0.0;
    Pose pose{};
    double clearance = 0.0;
  };

  template <class Clearance>
  void search(const Measured& a, const Measured& b, const Clearance& clearance, double fine, int depth, double& least) const {
    constexpr double bend = 1.5;  // of the way between two poses over the straight one
    const double moved = std::hypot(b.pose.x - a.pose.x, b.pose.y - a.pose.y) + radius_ * std::abs(std::remainder(b.pose.heading - a.pose.heading, 2.0 * M_PI));
    if (moved <= fine || depth >= deepest || 0.5 * (a.clearance + b.clearance - bend * moved) >= least || least <= 0.0) return;
    Measured middle{0.5 * (a.u + b.u), {}, 0.0};
    middle.pose = at(middle.u);
    middle.clearance = clearance(middle.pose, least + bend * moved);
    least = std::min(least, middle.clearance);
    search(a, middle, clearance, fine, depth + 1, least);
    search(middle, b, clearance, fine, depth + 1, least);
  }

  static constexpr int deepest = 16;

  /// Halved until no point of the body moves farther than the step.
  void refine(double u0, const Pose& p0, double u1, const Pose& p1, int depth,
              std::vector<Pose>& poses) const {
    const double turn = std::remainder(p1.heading - p0.heading, 2.0 * M_PI);
    const double moved = std::hypot(p1.x - p0.x, p1.y - p0.y) + radius_ * std::abs(turn);
    if (moved > step_ && depth < deepest) {
      const double middle = 0.5 * (u0 + u1);
      const Pose p = at(middle);
      refine(u0, p0, middle, p, depth + 1, poses);
      refine(middle, p, u1, p1, depth + 1, poses);
      return;
    }
    poses.push_back(p1);
  }

  double parameters() const {
    if (const auto* spline = std::get_if<Spline>(&piece_.curve))
      return static_cast<double>(spline->spans.size());
    if (const auto* sequence = std::get_if<PoseSequence>(&piece_.curve)) {
      return static_cast<double>(sequence->poses.size() - 1);
    }
    return 1.0;
  }

  /// Upper bound on the way of the curve, were all its spans as fast as the fastest; m
  double longest() const { return longest_way() + (piece_.heading ? radius_ * std::abs(piece_.heading->turn) : 0.0); }
  double longest_way() const {
    if (const auto* line = std::get_if<waywright::Line>(&piece_.curve)) return span(line->from, line->to);
    if (const auto* arc = std::get_if<Arc>(&piece_.curve)) return arc->length;
    if (const auto* clothoid = std::get_if<Clothoid>(&piece_.curve)) return clothoid->length;
    if (const auto* turn = std::get_if<Turn>(&piece_.curve))
      return radius_ * std::abs(turn->angle) + 0.01 * step_;
    double most = 0.0;
    if (const auto* sequence = std::get_if<PoseSequence>(&piece_.curve)) {
      for (std::size_t i = 0; i + 1 < sequence->poses.size(); ++i) {
        const Pose& a = sequence->poses[i];
        const Pose& b = sequence->poses[i + 1];
        most = std::max(most, std::hypot(b.x - a.x, b.y - a.y));
      }
    } else {
      for (const BezierSpan& bezier : std::get<Spline>(piece_.curve).spans) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(bezier.degree); ++i) {
          most = std::max(most, bezier.degree * span(bezier.control[i], bezier.control[i + 1]));
        }
      }
    }
    return most * parameters();
  }

  static double span(Vec2 a, Vec2 b) { return std::hypot(b.x - a.x, b.y - a.y); }

  Pose at(double u) const {
    Pose pose = std::visit([&](const auto& curve) { return pose_of(curve, u); }, piece_.curve);
    if (piece_.heading) pose.heading = piece_.heading->from + u * piece_.heading->turn;  // of lines and arcs u is a share of their length
    return pose;
  }

  Pose facing(double x, double y, double course) const {
    return {x, y, piece_.direction < 0 ? course + M_PI : course};
  }

  Pose pose_of(const waywright::Line& line, double u) const {
    const double dx = line.to.x - line.from.x;
    const double dy = line.to.y - line.from.y;
    return facing(line.from.x + u * dx, line.from.y + u * dy, std::atan2(dy, dx));
  }

  Pose pose_of(const Arc& arc, double u) const {
    const double s = u * arc.length;
    const double h = arc.start.heading;
    const double turn = arc.curvature * s;
    if (std::abs(turn) < 1e-3) {  // about the start's tangent: s − κ²s³/6 ahead, κs²/2 − κ³s⁴/24 to the left
      const double ahead = s * (1.0 - turn * turn / 6.0);
      const double left = s * (turn / 2.0 - turn * turn * turn / 24.0);
      return facing(arc.start.x + ahead * std::cos(h) - left * std::sin(h),
                    arc.start.y + ahead * std::sin(h) + left * std::cos(h), h + turn);
    }
    const double r = 1.0 / arc.curvature;  // the centre lies r to the left
    return facing(arc.start.x + r * (std::sin(h + turn) - std::sin(h)),
                  arc.start.y - r * (std::cos(h + turn) - std::cos(h)), h + turn);
  }

  Pose pose_of(const Clothoid& clothoid, double u) const {
    // Three-point Gauss on short panels, the standard library's sine and cosine.
    const double end = u * clothoid.length;
    const auto course = [&](double s) { return clothoid.start.heading + s * clothoid.curvature + 0.5 * s * s * clothoid.curvature_rate; };
    const double bend = std::max(std::abs(clothoid.curvature), std::abs(clothoid.curvature + clothoid.curvature_rate * clothoid.length));
    const int panels = 4 + static_cast<int>(std::min(1e5, 4.0 * bend * clothoid.length));
    const double h = end / panels;
    double x = 0.0, y = 0.0;
    for (int i = 0; i < panels; ++i) {
      for (const int k : {-1, 0, 1}) {
        const double weight = (k == 0 ? 8.0 : 5.0) / 18.0 * h;
        const double at = course(h * (i + 0.5 + 0.5 * k * std::sqrt(0.6)));
        x += weight * std::cos(at);
        y += weight * std::sin(at);
      }
    }
    return facing(clothoid.start.x + x, clothoid.start.y + y, course(end));
  }

  Pose pose_of(const Spline& spline, double u) const {
    const auto k = std::min(static_cast<std::size_t>(u), spline.spans.size() - 1);
    const BezierSpan& bezier = spline.spans[k];
    const double v = u - static_cast<double>(k);
    const auto [p, tangent] = casteljau(bezier, v);
    Vec2 along = tangent;
    // Where control points coincide the tangent of the limit is that of a place just beside.
    if (std::hypot(along.x, along.y) < 1e-12) along = casteljau(bezier, v < 0.5 ? v + 1e-5 : v - 1e-5).second;
    return facing(p.x, p.y, std::atan2(along.y, along.x));
  }

  static std::pair<Vec2, Vec2> casteljau(const BezierSpan& bezier, double v) {
    std::vector<Vec2> points(bezier.control.begin(), bezier.control.begin() + bezier.degree + 1);
    while (points.size() > 2) {
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        points[i] = {(1 - v) * points[i].x + v * points[i + 1].x,
                     (1 - v) * points[i].y + v * points[i + 1].y};
      }
      points.pop_back();
    }
    return {{(1 - v) * points[0].x + v * points[1].x, (1 - v) * points[0].y + v * points[1].y},
            {points[1].x - points[0].x, points[1].y - points[0].y}};
  }

  Pose pose_of(const Turn& turn, double u) const {
    return {turn.at.x, turn.at.y, turn.from + u * turn.angle};
  }

  Pose pose_of(const PoseSequence& sequence, double u) const {
    const auto k = std::min(static_cast<std::size_t>(u), sequence.poses.size() - 2);
    const Pose& a = sequence.poses[k];
    const Pose& b = sequence.poses[k + 1];
    const double v = u - static_cast<double>(k);
    return {a.x + v * (b.x - a.x), a.y + v * (b.y - a.y),
            a.heading + v * std::remainder(b.heading - a.heading, 2.0 * M_PI)};
  }

  const Piece& piece_;
  double radius_, step_;
};

inline double reach(const Footprint& footprint) {
  double r = footprint.polygon.empty() ? footprint.disc : 0.0;
  for (const Vec2 p : footprint.polygon) r = std::max(r, std::hypot(p.x, p.y));
  return r;
}

}  // namespace oracle

/// Vehicle poses along the path, so dense that no point of the footprint moves farther than `step` (m)
/// between two. Headings are not wrapped.
inline std::vector<Pose> oracle_poses(const Path& path, const Footprint& footprint, double step = 0.001) {
  std::vector<Pose> poses;
  const double radius =
      footprint.polygon.empty() ? 0.0 : oracle::reach(footprint);  // a disc does not change by turning
  for (const Piece& piece : path.pieces) oracle::Motion{piece, radius, step}.collect(poses);
  return poses;
}

/// Least distance from the footprint's area to obstacles (solid), boundaries, lines, points and blocked cells
/// (squares); m. 0 on contact or outside a boundary or a bounding grid; at most oracle_cap.
inline double oracle_clearance(const Map& map, const std::vector<Ring>& extra_boundaries,
                               const std::vector<Ring>& extra_obstacles, const Footprint& footprint,
                               const Pose& pose) {
  return oracle::Scene{map, extra_boundaries, extra_obstacles, footprint}.clearance(pose, oracle_cap);
}

/// The least of it over oracle_poses(path, footprint, step); the true least over the path is at most `step`/2
/// less. `tightest` receives the pose where it was found.
inline double oracle_path_clearance(const Map& map, const std::vector<Ring>& extra_boundaries,
                                    const std::vector<Ring>& extra_obstacles, const Footprint& footprint,
                                    const Path& path, double step = 0.001, Pose* tightest = nullptr) {
  const oracle::Scene scene{map, extra_boundaries, extra_obstacles, footprint};
  double least = oracle_cap;
  for (const Pose& pose : oracle_poses(path, footprint, step)) {
    const double clearance = scene.clearance(pose, least);
    if (clearance >= least) continue;
    least = clearance;
    if (tightest != nullptr) *tightest = pose;
    if (least <= 0.0) return 0.0;
  }
  return least;
}

/// Nearly the same with a hundredth of the poses: exact at the poses it looks at, which lie `fine` apart where it is tight (a bend sharper
/// than `coarse` can hide from it).
inline double oracle_refined_clearance(const Map& map, const Footprint& footprint, const Path& path, double coarse, double fine) {
  const oracle::Scene scene{map, {}, {}, footprint};
  const double radius = footprint.polygon.empty() ? 0.0 : oracle::reach(footprint);
  double least = oracle_cap;
  for (const Piece& piece : path.pieces) {
    least = oracle::Motion{piece, radius, fine}.least_of([&](const Pose& pose, double limit) { return scene.clearance(pose, limit); }, coarse, fine, least);
  }
  return least;
}

}  // namespace waywright
