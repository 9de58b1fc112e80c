#include "waywright/planner/plane/rounded_way.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr double same_place = 1e-9;     // m
constexpr double no_turn = 1e-9;        // rad
constexpr double least_radius = 0.01;   // m
constexpr double chord_angle = 0.2;     // rad, of the chords by which an arc is tested
constexpr int halvings = 8;

std::vector<Vec2> apart(const std::vector<Vec2>& points) {
  std::vector<Vec2> all{points.front()};
  for (const Vec2 p : points) {
    if (distance(all.back(), p) > same_place) all.push_back(p);
  }
  return all;
}

bool is_arc_free(const PlaneSpace& space, Vec2 from, Vec2 along, double radius, double angle, double beyond) {
  const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / chord_angle)));
  const double step = angle / chords, side = angle > 0.0 ? 1.0 : -1.0;
  const double bow = radius * (1.0 - sin_cos(0.5 * step).cos);
  const Vec2 middle = from + side * radius * left_of(along);
  const Vec2 spoke = from - middle;
  Vec2 before = from;
  for (int i = 1; i <= chords; ++i) {
    const SinCos turned = sin_cos(step * i);
    const Vec2 after = middle + Vec2{turned.cos * spoke.x - turned.sin * spoke.y, turned.sin * spoke.x + turned.cos * spoke.y};
    if (!space.is_free(before, after, space.needed() + beyond + bow)) return false;
    before = after;
  }
  return true;
}

struct Cut {
  double taken = 0.0;  // m of each line beside the corner
  double radius = 0.0, angle = 0.0;
};

Cut cut_at(const PlaneSpace& space, Vec2 before, Vec2 corner, Vec2 after, double beyond) {
  const Vec2 in = (1.0 / distance(before, corner)) * (corner - before), out = (1.0 / distance(corner, after)) * (after - corner);
  const double angle = arc_tangent(cross(in, out), dot(in, out));
  if (std::abs(angle) < no_turn) return {};
  const SinCos half = sin_cos(0.5 * std::abs(angle));
  const double least = std::max(least_radius, 1.0 / space.problem().vehicle().max_curvature());
  double taken = 0.5 * std::min(distance(before, corner), distance(corner, after));
  for (int k = 0; k < halvings; ++k, taken *= 0.5) {
    const double radius = taken * half.cos / half.sin;
    if (radius < least) break;
    if (is_arc_free(space, corner - taken * in, in, radius, angle, beyond)) return {taken, radius, angle};
  }
  return {};
}

double length_of(const std::vector<Curve>& curves) {
  double sum = 0.0;
  for (const Curve& curve : curves) sum += length(Piece{curve, 1, {}});
  return sum;
}

}  // namespace

std::vector<Curve> rounded_way(const PlaneSpace& space, const std::vector<Vec2>& points, double beyond) {
  const std::vector<Vec2> way = apart(points);
  std::vector<Curve> curves;
  Vec2 at = way.front();
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Cut cut = i + 1 < way.size() ? cut_at(space, way[i - 1], way[i], way[i + 1], beyond) : Cut{};
    const Vec2 in = (1.0 / distance(way[i - 1], way[i])) * (way[i] - way[i - 1]);
    const Vec2 end = cut.taken > 0.0 ? way[i] - cut.taken * in : way[i];
    if (distance(at, end) > same_place) curves.push_back(Line{at, end});
    at = end;
    if (cut.taken == 0.0) continue;
    curves.push_back(Arc{make_pose(end, angle_of(in)), (cut.angle > 0.0 ? 1.0 : -1.0) / cut.radius, cut.radius * std::abs(cut.angle)});
    const Vec2 out = (1.0 / distance(way[i], way[i + 1])) * (way[i + 1] - way[i]);
    at = way[i] + cut.taken * out;
  }
  return curves;
}

Path driven_way(const PlaneSpace& space, const std::vector<Vec2>& points, double heading, double turn, double beyond) {
  Path path;
  const std::vector<Curve> curves = rounded_way(space, points, beyond);
  const auto turn_by = [&](Vec2 at, double angle) {
    if (std::abs(angle) > no_turn) path.pieces.push_back({Turn{at, heading, angle}, 0, {}});
    heading = wrap(heading + angle);
  };
  if (curves.empty()) {
    turn_by(points.front(), turn);
    return path;
  }
  if (space.problem().vehicle().moves_any_way()) {
    const double whole = length_of(curves);
    double done = 0.0;
    for (const Curve& curve : curves) {
      Piece piece{curve, 1, {}};
      const double share = length(piece) / whole;
      piece.heading = HeadingAlong{wrap(heading + done * turn), share * turn};
      done += share;
      path.pieces.push_back(std::move(piece));
    }
    return path;
  }
  const double end = wrap(heading + turn);
  for (const Curve& curve : curves) {
    const Piece piece{curve, 1, {}};
    const Pose start = start_pose(piece);
    turn_by(start.position(), shorter_turn(heading, start.heading));
    path.pieces.push_back(piece);
    heading = end_pose(piece).heading;
  }
  turn_by(end_pose(path.pieces.back()).position(), shorter_turn(heading, end));
  return path;
}

std::vector<Vec2> thinned_way(const PlaneSpace& space, const std::vector<Vec2>& points, double tolerance) {
  std::vector<Vec2> kept{points.front()};
  const auto stays_near = [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from + 1; k < to; ++k) {
      if (point_segment_distance(points[k], points[from], points[to]) > tolerance) return false;
    }
    return space.is_free(points[from], points[to]);
  };
  for (std::size_t i = 0; i + 1 < points.size();) {
    // As far as doubling finds, then as far as halving does: each run is looked at a few times only.
    std::size_t good = i + 1, step = 1;
    while (i + 2 * step < points.size() && stays_near(i, i + 2 * step)) good = i + (step *= 2);
    std::size_t bad = std::min(i + 2 * step, points.size());
    while (bad - good > 1) {
      const std::size_t middle = good + (bad - good) / 2;
      (stays_near(i, middle) ? good : bad) = middle;
    }
    kept.push_back(points[good]);
    i = good;
  }
  return kept;
}

std::vector<Vec2> without_stubs(const PlaneSpace& space, std::vector<Vec2> points, double reach) {
  for (int side = 0; side < 2; ++side) {  // its end, then turned about its beginning
    const Vec2 end = points.back();
    std::size_t first = points.size() - 1;  // of those that are within reach up to the end
    while (first > 0 && distance(points[first - 1], end) <= reach) --first;
    std::size_t from = first > 0 ? first - 1 : 0;
    while (from + 2 < points.size() && !space.is_free(points[from], end)) ++from;
    if (from + 2 < points.size()) points.erase(points.begin() + static_cast<std::ptrdiff_t>(from) + 1, points.end() - 1);
    std::reverse(points.begin(), points.end());
  }
  return points;
}

}  // namespace waywright
