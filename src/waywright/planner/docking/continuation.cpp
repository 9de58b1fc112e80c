#include "waywright/planner/docking/continuation.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/path/remainder.hpp"

namespace waywright {
namespace {

constexpr double same_place = 1e-9;      // m: an end that is off by less has not moved
constexpr double same_heading = 1e-9;    // rad
constexpr double same_curvature = 1e-9;  // 1/m

bool is_same(const Pose& a, const Pose& b) {
  return distance(a.position(), b.position()) <= same_place && std::abs(shorter_turn(a.heading, b.heading)) <= same_heading;
}

/// The motion that takes one pose to another.
class Shift {
 public:
  Shift(const Pose& from, const Pose& to) : from_{from}, to_{to} {}
  /// Moves a point; keeps by how far in `farthest`.
  void move(Vec2& p, double& farthest) const {
    const Vec2 moved = to_.to_world(from_.to_local(p));
    farthest = std::max(farthest, distance(p, moved));
    p = moved;
  }

 private:
  Frame from_, to_;
};

/// What follows the last bend moves with the goal, and with it the end of the bend.
bool carry_end(Path& path, const Pose& to, double& farthest) {
  const Pose from = end_pose(path);
  if (is_same(from, to)) return true;
  auto* spline = std::get_if<Spline>(&path.pieces.back().curve);
  if (spline == nullptr) return false;
  const Shift shift{from, to};
  for (std::size_t i = spline->spans.size(); i-- > 0;) {
    BezierSpan& span = spline->spans[i];
    if (span.degree == 5) {
      for (std::size_t k = 3; k < 6; ++k) shift.move(span.control[k], farthest);
      return true;
    }
    if (span.degree != 1 || i == 0) return false;
    // The straight run into the goal; where the bend before it ends it begins, too.
    for (std::size_t k = 0; k < 2; ++k) shift.move(span.control[k], farthest);
  }
  return false;
}

/// The beginning of the first bend moves with the start, and takes its curvature.
bool carry_start(Path& path, const Pose& to, double curvature, double& farthest) {
  Piece& first = path.pieces.front();
  const Pose from = start_pose(path);
  const double more = curvature - start_curvature(first);
  if (is_same(from, to) && std::abs(more) <= same_curvature) return true;
  auto* spline = std::get_if<Spline>(&first.curve);
  if (spline == nullptr || spline->spans.front().degree != 5) return false;
  auto& control = spline->spans.front().control;
  const Shift shift{from, to};
  for (std::size_t k = 0; k < 3; ++k) shift.move(control[k], farthest);
  // κ = p″·n / |p′|², p″ = 20 × the second difference, p′ = 5 × the first one.
  const Vec2 tangent = control[1] - control[0];
  const Vec2 bend = (1.25 * more * norm(tangent)) * left_of(tangent);
  control[2] = control[2] + bend;
  farthest += norm(bend);
  return true;
}

}  // namespace

Handover handover_at(const Path& path, const std::vector<Sample>& samples, double t) {
  Handover handover;
  if (samples.empty()) return handover;
  const auto after = std::upper_bound(samples.begin(), samples.end(), t, [](double time, const Sample& s) { return time < s.t; });
  if (after == samples.begin() || after == samples.end()) {
    const Sample& end = after == samples.begin() ? samples.front() : samples.back();
    handover.driven = end.s;
    handover.motion.speed = end.speed;
  } else {
    const Sample& a = *std::prev(after);
    const Sample& b = *after;
    const double way = b.s - a.s, time = t - a.t;
    const double sum = a.speed + b.speed;
    if (way > 0.0 && sum > 0.0) {  // evenly accelerated
      const double acceleration = 0.5 * (b.speed - a.speed) * sum / way;
      handover.driven = a.s + std::clamp(a.speed * time + 0.5 * acceleration * time * time, 0.0, way);
      handover.motion.speed = std::max(0.0, a.speed + acceleration * time);
    } else {  // it stands, or goes through a step from rest to rest, where it is taken to stand at the end of
      handover.driven = way > 0.0 ? b.s : a.s;
    }
  }
  const Path rest = remainder(path, handover.driven);
  const Piece& first = rest.pieces.front();
  handover.pose = start_pose(first);
  if (handover.motion.speed > 0.0) {
    handover.motion.curvature = start_curvature(first);
    if (first.direction < 0) handover.motion.speed = -handover.motion.speed;
  }
  return handover;
}

std::optional<Continuation> continuation(const Problem& problem, const Path& old, double driven) {
  if (old.pieces.empty() || problem.is_driven_back()) return std::nullopt;
  Continuation found;
  found.path = remainder(old, driven);
  auto& pieces = found.path.pieces;
  if (problem.pocket()) {
    // The way into the shelf is the problem's; the old one ends with its own.
    if (pieces.size() < 2 || !std::holds_alternative<Line>(pieces.back().curve)) return std::nullopt;
    pieces.pop_back();
  }
  const auto& motion = problem.motion();
  const double curvature = motion ? motion->curvature : start_curvature(pieces.front());
  if (!carry_start(found.path, problem.first_pose(), curvature, found.farthest)) return std::nullopt;
  if (!carry_end(found.path, problem.goal(), found.farthest)) return std::nullopt;
  found.path = problem.whole_path(std::move(found.path), true);
  return found;
}

}  // namespace waywright
