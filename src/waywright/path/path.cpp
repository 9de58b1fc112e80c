#include "waywright/path/path.hpp"

#include <type_traits>

#include "waywright/curve/arc.hpp"
#include "waywright/curve/bezier.hpp"
#include "waywright/curve/clothoid.hpp"

namespace waywright {
namespace {

struct Ends {
  CurvePoint start, end;
};

Ends ends_of(const Line& line) { return {evaluate(line, 0.0), {line.to, angle_of(line.to - line.from), 0.0, 0.0}}; }
Ends ends_of(const Arc& arc) { return {evaluate(arc, 0.0), evaluate(arc, arc.length)}; }
Ends ends_of(const Clothoid& clothoid) { return {evaluate(clothoid, 0.0), evaluate(clothoid, clothoid.length)}; }
Ends ends_of(const Spline& spline) { return {evaluate(spline.spans.front(), 0.0), evaluate(spline.spans.back(), 1.0)}; }

Pose vehicle_pose(const CurvePoint& point, int direction) {
  return make_pose(point.position, direction < 0 ? wrap(point.course + pi) : point.course);
}

template <class Select>
Pose end_of(const Piece& piece, Select select, bool at_end) {
  return std::visit(
      [&](const auto& curve) -> Pose {
        using C = std::decay_t<decltype(curve)>;
        if constexpr (std::is_same_v<C, Turn>) {
          return make_pose(curve.at, wrap(at_end ? curve.from + curve.angle : curve.from));
        } else if constexpr (std::is_same_v<C, PoseSequence>) {
          return at_end ? curve.poses.back() : curve.poses.front();
        } else {
          const CurvePoint end = select(ends_of(curve));
          if (piece.heading) return make_pose(end.position, wrap(piece.heading->from + (at_end ? piece.heading->turn : 0.0)));
          return vehicle_pose(end, piece.direction);
        }
      },
      piece.curve);
}

template <class Select>
double curvature_of(const Piece& piece, Select select) {
  return std::visit(
      [&](const auto& curve) -> double {
        using C = std::decay_t<decltype(curve)>;
        if constexpr (std::is_same_v<C, Turn> || std::is_same_v<C, PoseSequence>) {
          return 0.0;
        } else {
          return select(ends_of(curve)).curvature;
        }
      },
      piece.curve);
}

constexpr auto first = [](const Ends& e) { return e.start; };
constexpr auto last = [](const Ends& e) { return e.end; };

}  // namespace

Pose start_pose(const Piece& piece) { return end_of(piece, first, false); }
Pose end_pose(const Piece& piece) { return end_of(piece, last, true); }
Pose start_pose(const Path& path) { return start_pose(path.pieces.front()); }
Pose end_pose(const Path& path) { return end_pose(path.pieces.back()); }
double start_curvature(const Piece& piece) { return curvature_of(piece, first); }
double end_curvature(const Piece& piece) { return curvature_of(piece, last); }

double length(const Piece& piece) {
  return std::visit(
      [](const auto& curve) -> double {
        using C = std::decay_t<decltype(curve)>;
        if constexpr (std::is_same_v<C, Line>) {
          return arc_length(curve);
        } else if constexpr (std::is_same_v<C, Arc> || std::is_same_v<C, Clothoid>) {
          return curve.length;
        } else if constexpr (std::is_same_v<C, Spline>) {
          double sum = 0.0;
          for (const BezierSpan& span : curve.spans) sum += ArcLengthTable{span}.length();
          return sum;
        } else if constexpr (std::is_same_v<C, Turn>) {
          return 0.0;
        } else {
          double sum = 0.0;
          for (std::size_t i = 0; i + 1 < curve.poses.size(); ++i) {
            sum += distance(curve.poses[i].position(), curve.poses[i + 1].position());
          }
          return sum;
        }
      },
      piece.curve);
}

double length(const Path& path) {
  double sum = 0.0;
  for (const Piece& piece : path.pieces) sum += length(piece);
  return sum;
}

bool is_course_jump(const Sample& before, const Sample& after, double tolerance) {
  return !(before.faces_along && after.faces_along) && before.direction != 0 && after.direction != 0 && before.s == after.s &&
         std::abs(shorter_turn(before.course, after.course)) > tolerance;
}

bool is_direction_change(const Sample& before, const Sample& after) { return before.direction != after.direction; }

}  // namespace waywright
