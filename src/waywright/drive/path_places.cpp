#include "waywright/drive/path_places.hpp"

#include <algorithm>
#include <type_traits>

#include "waywright/curve/arc.hpp"
#include "waywright/curve/clothoid.hpp"

namespace waywright {
namespace {

/// Which of parts that end there holds s, and how much of s lies before it.
std::pair<std::size_t, double> part_at(const std::vector<double>& ends, double s) {
  const auto it = std::upper_bound(ends.begin(), ends.end(), s);
  const auto i = static_cast<std::size_t>(std::min(it, std::prev(ends.end())) - ends.begin());
  return {i, i == 0 ? 0.0 : ends[i - 1]};
}

}  // namespace

PathPlaces::PathPlaces(const Path& path) {
  for (const Piece& piece : path.pieces) {
    if (piece.direction == 0) continue;
    Prepared prepared{piece, {}, {}, 0.0};
    double sum = 0.0;
    if (const auto* spline = std::get_if<Spline>(&piece.curve)) {
      for (const BezierSpan& span : spline->spans) {
        prepared.spans.emplace_back(span);
        prepared.ends.push_back(sum += prepared.spans.back().length());
      }
    } else if (const auto* sequence = std::get_if<PoseSequence>(&piece.curve)) {
      for (std::size_t i = 0; i + 1 < sequence->poses.size(); ++i) {
        prepared.ends.push_back(sum += distance(sequence->poses[i].position(), sequence->poses[i + 1].position()));
      }
    } else {
      sum = waywright::length(piece);
    }
    prepared.length = sum;
    ends_.push_back((ends_.empty() ? 0.0 : ends_.back()) + sum);
    pieces_.push_back(std::move(prepared));
  }
  if (ends_.empty()) ends_.push_back(0.0);  // nothing but turns
}

PathPlace PathPlaces::at(double s) const {
  if (pieces_.empty()) return {};
  const auto [i, before] = part_at(ends_, s);
  return on(pieces_[i], std::clamp(s - before, 0.0, ends_[i] - before));
}

PathPlace PathPlaces::on(const Prepared& prepared, double s) const {
  const auto place = [&](const CurvePoint& p) {
    if (const auto& heading = prepared.piece.heading) return PathPlace{make_pose(p.position, wrap(heading->from + heading->turn * s / prepared.length)), p.curvature};
    return PathPlace{make_pose(p.position, wrap(prepared.piece.direction < 0 ? p.course + pi : p.course)), p.curvature};
  };
  return std::visit(
      [&](const auto& curve) -> PathPlace {
        using C = std::decay_t<decltype(curve)>;
        if constexpr (std::is_same_v<C, Turn>) {
          return {};
        } else if constexpr (std::is_same_v<C, PoseSequence>) {
          const auto [i, before] = part_at(prepared.ends, s);
          const Pose& a = curve.poses[i];
          const Pose& b = curve.poses[i + 1];
          const double step = prepared.ends[i] - before;
          const double t = step > 0.0 ? std::clamp((s - before) / step, 0.0, 1.0) : 0.0;
          const double turn = shorter_turn(a.heading, b.heading);
          return {make_pose(a.position() + t * (b.position() - a.position()), wrap(a.heading + t * turn)), step > 0.0 ? turn / step : 0.0};
        } else if constexpr (std::is_same_v<C, Spline>) {
          const auto [i, before] = part_at(prepared.ends, s);
          return place(evaluate(curve.spans[i], prepared.spans[i].parameter(s - before)));
        } else {
          return place(evaluate(curve, s));
        }
      },
      prepared.piece.curve);
}

}  // namespace waywright
