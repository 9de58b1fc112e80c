#include "waywright/planner/steering/arc_motion.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/curve/arc.hpp"

namespace waywright {
namespace {

// m beyond what is required: ten times what the proof's bound can be under the truth where it looks closely.
constexpr double reserve = 1e-4;
constexpr double rounding = 1e-9;  // m, of the distance at a pose whose clearance is just what is required

}  // namespace

MotionTest::MotionTest(const Problem& problem, const MotionTestLimits& limits, Budget& budget)
    : problem_{problem}, limits_{limits}, budget_{budget}, required_{problem.required_clearance()} {}

bool MotionTest::spent() {
  return placements_ >= limits_.placements || motions_ >= limits_.motions || budget_.exhausted();
}

Contact MotionTest::place(const Pose& pose, double wanted) {
  ++placements_;
  return problem_.world().clearance(problem_.footprint(), pose, required_ + wanted);
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
  for (const Vec2 p : problem_.footprint().polygon) {
    greatest = std::max(greatest, norm({direction - arc.curvature * p.y, arc.curvature * p.x}));
  }
  return greatest;
}

bool MotionTest::near_an_end(Vec2 point) const {
  return std::min(distance(point, problem_.start().position()),
                  distance(point, problem_.goal().position())) <= limits_.resolution;
}

bool MotionTest::interval_free(const Arc& arc, int direction, double rate, double begin, double end) {
  if (placements_ >= limits_.placements || budget_.exhausted()) return false;
  const double half = 0.5 * (end - begin);
  const CurvePoint point = evaluate(arc, begin + half);
  const Contact contact =
      place(make_pose(point.position, direction < 0 ? wrap(point.course + pi) : point.course),
            2.0 * reserve + half * rate);
  double shown = (contact.clearance - required_ - reserve) /
                 rate;  // metres to both sides that this placement shows to be free
  if (shown > half) return true;
  const double least = 0.5 * limits_.resolution;
  if (shown < least) {
    if (contact.clearance <= required_ || !near_an_end(point.position)) {
      note_blocked(contact);
      return false;
    }
    shown = least;
    if (shown > half) return true;
  }
  return interval_free(arc, direction, rate, begin, begin + half - shown) &&
         interval_free(arc, direction, rate, begin + half + shown, end);
}

bool MotionTest::motion_free(std::span<const Piece> pieces) {
  if (motions_ >= limits_.motions) return false;
  ++motions_;
  return std::all_of(pieces.begin(), pieces.end(), [this](const Piece& piece) {
    Arc arc;
    if (const auto* bent = std::get_if<Arc>(&piece.curve)) {
      arc = *bent;
    } else {
      const auto& line = std::get<Line>(piece.curve);
      arc = {make_pose(line.from, angle_of(line.to - line.from)), 0.0, arc_length(line)};
    }
    return interval_free(arc, piece.direction, rate(arc, piece.direction), 0.0, arc.length);
  });
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
