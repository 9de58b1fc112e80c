#include "waywright/planner/docking/carry.hpp"

#include <cmath>

#include "waywright/path/remainder.hpp"

namespace waywright {
namespace {

// An end that is off by less has not moved: half of what the proof allows.
constexpr double same_place = 5e-7;      // m
constexpr double same_heading = 5e-7;    // rad
constexpr double same_curvature = 1e-9;  // 1/m

bool is_same(const Pose& a, const Pose& b) {
  return distance(a.position(), b.position()) <= same_place && std::abs(shorter_turn(a.heading, b.heading)) <= same_heading;
}

/// What follows the last bend moves with the goal, and with it the end of the bend.
bool carry_end(Path& path, const Pose& to, double& farthest) {
  const Pose from = end_pose(path);
  if (is_same(from, to)) return true;
  auto* spline = std::get_if<Spline>(&path.pieces.back().curve);
  if (spline == nullptr) return false;
  const Shift shift{from, to};
  if (spline->spans.size() == 1 && spline->spans[0].degree == 1) {
    // A straight run alone can only be longer or shorter.
    const Vec2 along = Frame{from}.to_local(to.position());
    auto& control = spline->spans[0].control;
    if (std::abs(along.y) > same_place || std::abs(shorter_turn(from.heading, to.heading)) > same_heading) return false;
    if (dot(to.position() - control[0], control[1] - control[0]) <= 0.0) return false;
    shift.move(control[1], farthest);
    return true;
  }
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

std::optional<CarriedRest> pattern_left(const Problem& problem, const Path& old, double driven) {
  if (old.pieces.empty() || problem.is_driven_back()) return std::nullopt;
  CarriedRest rest;
  rest.before = remainder(old, driven);
  auto& pieces = rest.before.pieces;
  if (problem.pocket()) {
    // The way into the shelf is the problem's; the old one ends with its own.
    if (pieces.size() < 2 || !std::holds_alternative<Line>(pieces.back().curve)) return std::nullopt;
    pieces.pop_back();
  }
  const auto& motion = problem.motion();
  const double curvature = motion ? motion->curvature : start_curvature(pieces.front());
  rest.carried = rest.before;
  if (!carry_start(rest.carried, problem.first_pose(), curvature, rest.farthest)) return std::nullopt;
  if (!carry_end(rest.carried, problem.goal(), rest.farthest)) return std::nullopt;
  return rest;
}

}  // namespace waywright
