#include "waywright/planner/ompl/arc_motion.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/curve/arc.hpp"

namespace waywright {
namespace {

constexpr double reserve = 0.001;        // m beyond what is required, so that the proof never ends on a knife's edge
constexpr double least_interval = 0.004;  // m of path: shorter ones count as blocked
constexpr double far_enough = 2.0;       // m

}  // namespace

MotionTest::MotionTest(const Problem& problem)
    : problem_{problem},
      radius_{problem.vehicle().footprint.is_disc() ? 0.0 : problem.vehicle().footprint.radius()},
      required_{problem.required_clearance()} {}

double MotionTest::slack(const Pose& pose) {
  ++placements_;
  const Contact contact = problem_.world().clearance(problem_.vehicle().footprint, pose, required_ + far_enough);
  if (contact.clearance <= required_) ++blocked_[contact.source];
  return contact.clearance - required_;
}

bool MotionTest::pose_free(const Pose& pose) { return slack(pose) > -1e-9; }

bool MotionTest::interval_free(const Arc& arc, int direction, double begin, double end) {
  const double half = 0.5 * (end - begin);
  const CurvePoint point = evaluate(arc, begin + half);
  const double found = slack(make_pose(point.position, direction < 0 ? wrap(point.course + pi) : point.course));
  if (found <= 0.0) return false;
  if (found - reserve > half * (1.0 + radius_ * std::abs(arc.curvature))) return true;
  if (end - begin < least_interval) return found > 0.5 * half * (1.0 + radius_ * std::abs(arc.curvature));
  return interval_free(arc, direction, begin, begin + half) && interval_free(arc, direction, begin + half, end);
}

bool MotionTest::piece_free(const Piece& piece) {
  if (const auto* arc = std::get_if<Arc>(&piece.curve)) return interval_free(*arc, piece.direction, 0.0, arc->length);
  const auto& line = std::get<Line>(piece.curve);
  const Arc straight{make_pose(line.from, angle_of(line.to - line.from)), 0.0, arc_length(line)};
  return interval_free(straight, piece.direction, 0.0, straight.length);
}

std::pair<std::string, double> MotionTest::worst_obstacle() const {
  std::int64_t all = 0;
  std::pair<std::size_t, std::int64_t> worst{0, 0};
  for (const auto& [source, count] : blocked_) {
    all += count;
    if (count > worst.second) worst = {source, count};
  }
  if (all == 0) return {"", 0.0};
  return {problem_.world().source_name(worst.first), static_cast<double>(worst.second) / static_cast<double>(all)};
}

}  // namespace waywright
