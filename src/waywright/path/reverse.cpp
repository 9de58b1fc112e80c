#include <algorithm>
#include <type_traits>

#include "waywright/curve/arc.hpp"
#include "waywright/curve/clothoid.hpp"
#include "waywright/path/path.hpp"

namespace waywright {
namespace {

Line other_way(const Line& line) { return {line.to, line.from}; }
Arc other_way(const Arc& arc) {
  const CurvePoint end = evaluate(arc, arc.length);
  return {make_pose(end.position, wrap(end.course + pi)), -arc.curvature, arc.length};
}
Clothoid other_way(const Clothoid& clothoid) { return reversed(clothoid); }
Spline other_way(Spline spline) {
  std::reverse(spline.spans.begin(), spline.spans.end());
  for (BezierSpan& span : spline.spans) std::reverse(span.control.begin(), span.control.begin() + span.degree + 1);
  return spline;
}
Turn other_way(const Turn& turn) { return {turn.at, wrap(turn.from + turn.angle), -turn.angle}; }
PoseSequence other_way(PoseSequence sequence) {
  std::reverse(sequence.poses.begin(), sequence.poses.end());
  return sequence;
}

}  // namespace

Path reversed(const Path& path) {
  Path back;
  for (auto piece = path.pieces.rbegin(); piece != path.pieces.rend(); ++piece) {
    back.pieces.push_back({std::visit([](const auto& curve) -> Curve { return other_way(curve); }, piece->curve), -piece->direction});
    if (!piece->heading) continue;
    back.pieces.back().direction = piece->direction;
    back.pieces.back().heading = HeadingAlong{wrap(piece->heading->from + piece->heading->turn), -piece->heading->turn};
  }
  return back;
}

}  // namespace waywright
