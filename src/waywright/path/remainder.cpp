#include "waywright/path/remainder.hpp"

#include <algorithm>
#include <type_traits>

#include "waywright/curve/arc.hpp"
#include "waywright/curve/bezier.hpp"
#include "waywright/curve/clothoid.hpp"

namespace waywright {
namespace {

constexpr double same_place = 1e-9;  // m

// Each @pre 0 ≤ driven < the curve's length.

Line rest_of(const Line& line, double driven) { return {evaluate(line, driven).position, line.to}; }

Arc rest_of(const Arc& arc, double driven) {
  const CurvePoint from = evaluate(arc, driven);
  return {make_pose(from.position, from.course), arc.curvature, arc.length - driven};
}

Clothoid rest_of(const Clothoid& clothoid, double driven) { return rest_from(clothoid, driven); }

Spline rest_of(const Spline& spline, double driven) {
  Spline rest{spline.kind, {}};
  for (std::size_t i = 0; i < spline.spans.size(); ++i) {
    const BezierSpan& span = spline.spans[i];
    const bool is_last = i + 1 == spline.spans.size();
    if (driven > 0.0 || rest.spans.empty()) {
      const ArcLengthTable table{span};
      if (driven >= table.length() - same_place && !is_last) {
        driven = std::max(0.0, driven - table.length());
        continue;
      }
      rest.spans.push_back(rest_from(span, table.parameter(driven)));
      driven = 0.0;
      continue;
    }
    rest.spans.push_back(span);
  }
  return rest;
}

Turn rest_of(const Turn& turn, double) { return turn; }

PoseSequence rest_of(const PoseSequence& sequence, double driven) {
  const std::vector<Pose>& poses = sequence.poses;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const Pose& a = poses[i];
    const Pose& b = poses[i + 1];
    const double step = distance(a.position(), b.position());
    if (driven >= step && i + 2 < poses.size()) {
      driven -= step;
      continue;
    }
    const double t = step > 0.0 ? std::min(1.0, driven / step) : 0.0;
    PoseSequence rest;
    rest.poses.push_back(make_pose(a.position() + t * (b.position() - a.position()), wrap(a.heading + t * shorter_turn(a.heading, b.heading))));
    rest.poses.insert(rest.poses.end(), poses.begin() + static_cast<std::ptrdiff_t>(i) + 1, poses.end());
    return rest;
  }
  return sequence;
}

}  // namespace

Path remainder(const Path& path, double driven) {
  std::size_t first = 0;
  driven = std::max(0.0, driven);
  double here = length(path.pieces[0]);
  const auto is_driven = [&] { return path.pieces[first].direction == 0 ? driven > same_place : driven >= here - same_place; };
  while (first + 1 < path.pieces.size() && is_driven()) {
    driven = std::max(0.0, driven - here);
    here = length(path.pieces[++first]);
  }
  Path rest;
  const Piece& cut = path.pieces[first];
  // At the path's very end a little of it is left.
  driven = std::min(driven, std::max(0.0, here - same_place));
  rest.pieces.push_back({std::visit([&](const auto& curve) -> Curve { return rest_of(curve, driven); }, cut.curve), cut.direction});
  if (cut.heading) {
    const double turned = cut.heading->turn * driven / here;
    rest.pieces.back().heading = HeadingAlong{wrap(cut.heading->from + turned), cut.heading->turn - turned};
  }
  for (std::size_t i = first + 1; i < path.pieces.size(); ++i) rest.pieces.push_back(path.pieces[i]);
  return rest;
}

Path beginning(const Path& path, double s) {
  Path until;
  for (const Piece& piece : path.pieces) {
    const double here = length(piece);
    if (!until.pieces.empty() && s <= same_place) break;
    if (piece.direction != 0 && s < here - same_place) {
      // Cut from its other end, as it would be driven back.
      Path whole;
      whole.pieces.push_back(piece);
      const Path back = remainder(reversed(whole), here - std::max(s, same_place));
      until.pieces.push_back(reversed(back).pieces.front());
      break;
    }
    until.pieces.push_back(piece);
    s -= here;
  }
  return until;
}

}  // namespace waywright
