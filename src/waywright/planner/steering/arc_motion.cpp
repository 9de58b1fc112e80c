#include "waywright/planner/steering/arc_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "waywright/curve/arc.hpp"

namespace waywright {
namespace {

// m beyond what is required: ten times what the proof's bound can be under the truth where it looks closely.
constexpr double reserve = 1e-4;
constexpr double rounding = 1e-9;  // m, of the distance at a pose whose clearance is just what is required

}  // namespace

struct MotionTest::Driven {
  Arc arc{};
  const Turn* turn = nullptr;  ///< of a piece that is one
  int direction = 1;
  double rate = 1.0;    ///< greatest way of any footprint point over the way
  double length = 0.0;  ///< m

  Pose pose(double way) const {
    if (turn != nullptr) return make_pose(turn->at, wrap(turn->from + (length > 0.0 ? way / length : 1.0) * turn->angle));
    const CurvePoint point = evaluate(arc, way);
    return make_pose(point.position, direction < 0 ? wrap(point.course + pi) : point.course);
  }
};

MotionTest::MotionTest(const Problem& problem, const MotionTestLimits& limits, Budget& budget, Footprint footprint)
    : problem_{problem}, limits_{limits}, budget_{budget}, footprint_{std::move(footprint)}, required_{problem.required_clearance()} {}

bool MotionTest::spent() {
  return placements_ >= limits_.placements || motions_ >= limits_.motions || budget_.exhausted();
}

Contact MotionTest::place(const Pose& pose, double wanted) {
  ++placements_;
  return problem_.world().clearance(footprint_, pose, required_ + wanted);
}

void MotionTest::note_blocked(const Contact& contact) {
  Blocked& blocked = blocked_[contact.source];
  if (blocked.count++ == 0) blocked.point = contact.point;
}

bool MotionTest::pose_free(const Pose& pose) {
  if (placements_ >= limits_.placements) return false;
  const Contact contact = place(pose, reserve);
  if (contact.clearance > 0.0 && contact.clearance >= required_ - rounding) return true;
  note_blocked(contact);
  return false;
}

bool MotionTest::pose_free_by(const Pose& pose, double beyond) {
  return placements_ < limits_.placements && place(pose, beyond + reserve).clearance - required_ > beyond;
}

/// Greatest speed of any footprint point where the origin's is 1: the body turns with the curvature, a disc
/// shows no turning. Speed is a convex function of the place on the body, so that the outline's corners
/// decide.
double MotionTest::rate(const Arc& arc, int direction) const {
  double greatest = 1.0;
  for (const Vec2 p : footprint_.polygon) {
    greatest = std::max(greatest, norm({direction - arc.curvature * p.y, arc.curvature * p.x}));
  }
  return greatest;
}

MotionTest::Driven MotionTest::driven(const Piece& piece) const {
  Driven driven;
  driven.direction = piece.direction;
  if (const auto* turn = std::get_if<Turn>(&piece.curve)) {
    driven.turn = turn;
    driven.length = footprint_.is_disc() ? 0.0 : footprint_.radius() * std::abs(turn->angle);
    return driven;
  }
  if (const auto* bent = std::get_if<Arc>(&piece.curve)) {
    driven.arc = *bent;
  } else {
    const auto& line = std::get<Line>(piece.curve);
    driven.arc = {make_pose(line.from, angle_of(line.to - line.from)), 0.0, arc_length(line)};
  }
  driven.rate = rate(driven.arc, piece.direction);
  driven.length = driven.arc.length;
  return driven;
}

bool MotionTest::near_an_end(const Driven& driven, const Pose& pose) const {
  const auto is_near = [&](const Pose& end) {
    return distance(pose.position(), end.position()) <= limits_.resolution &&
           (driven.turn == nullptr || footprint_.radius() * std::abs(shorter_turn(end.heading, pose.heading)) <= limits_.resolution);
  };
  return is_near(problem_.start()) || is_near(problem_.goal());
}

bool MotionTest::interval_free(const Driven& driven, double begin, double end) {
  if (placements_ >= limits_.placements || budget_.exhausted()) return false;
  const double half = 0.5 * (end - begin);
  const Pose pose = driven.pose(begin + half);
  const Contact contact = place(pose, 2.0 * reserve + half * driven.rate);
  double shown = (contact.clearance - required_ - reserve) /
                 driven.rate;  // metres to both sides that this placement shows to be free
  if (shown > half) return true;
  const double least = 0.5 * limits_.resolution;
  if (shown < least) {
    if (contact.clearance <= required_ || !near_an_end(driven, pose)) {
      stop_.share = driven.length > 0.0 ? begin / driven.length : 0.0;
      note_blocked(contact);
      return false;
    }
    shown = least;
    if (shown > half) return true;
  }
  return interval_free(driven, begin, begin + half - shown) && interval_free(driven, begin + half + shown, end);
}

bool MotionTest::motion_free(std::span<const Piece> pieces) {
  stop_ = {};
  if (motions_ >= limits_.motions) return false;
  ++motions_;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    stop_ = {i, 0.0};
    const Driven piece = driven(pieces[i]);
    if (!interval_free(piece, 0.0, piece.length)) return false;
  }
  return true;
}

Blocker MotionTest::worst_blocker() const {
  std::int64_t all = 0;
  const std::pair<const std::size_t, Blocked>* worst = nullptr;
  for (const auto& entry : blocked_) {
    all += entry.second.count;
    if (worst == nullptr || entry.second.count > worst->second.count) worst = &entry;
  }
  if (worst == nullptr) return {};
  return {problem_.world().source_name(worst->first),
          static_cast<double>(worst->second.count) / static_cast<double>(all), worst->second.point};
}

}  // namespace waywright
