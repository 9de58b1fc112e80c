#include "waywright/proof/directions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "waywright/geometry/stretches.hpp"
#include "waywright/proof/pose_limits.hpp"

namespace waywright {
namespace {

constexpr int deepest = 48;                   // halvings
constexpr std::int64_t most_looks = 500'000;  // of a path at one zone

double degrees(double radians) { return radians * 180.0 / pi; }

/// One zone and one path.
class Direction {
 public:
  Direction(const ZoneRules::Directed& zone, const ProofOptions& options) : zone_{zone}, options_{options} {}

  std::optional<Violation> check(const Path& path, const Motion& motion) {
    bool was_inside = false;  // where the last of a run of poses from outside ended
    double farthest = 0.0;    // m along the direction, that they had come
    for (std::size_t i = 0; i < path.pieces.size(); ++i) {
      const Piece& piece = path.pieces[i];
      if (piece.direction == 0) continue;
      const bool is_from_outside = std::holds_alternative<PoseSequence>(piece.curve);
      if (!is_from_outside) was_inside = false;
      for (const MotionInterval& interval : motion.of_piece(i)) {
        std::optional<Violation> found;
        if (is_from_outside) found = check_step(interval, was_inside, farthest);
        else found = std::holds_alternative<Line>(piece.curve) ? check_straight(interval) : check_curve(interval);
        if (found) return found;
      }
    }
    return std::nullopt;
  }

 private:
  bool is_near(const MotionInterval& interval, double more) const {
    const Vec2 a = interval.begin().position(), b = interval.end().position();
    return meet(Box{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}}, zone_.box, more);
  }

  Violation against(Vec2 at, double course) const {
    return {fmt::format("in {} at ({:.3f}, {:.3f}) the vehicle drives {:.1f}° off the zone's direction, and at most 90° are allowed", zone_.title, at.x, at.y,
                        degrees(std::abs(shorter_turn(zone_.direction, course)))),
            make_pose(at, course)};
  }

  std::optional<Violation> check_straight(const MotionInterval& interval) const {
    const Vec2 from = interval.begin().position(), way = interval.end().position() - from;
    if (!is_near(interval, 0.0) || !zone_.is_against(way, zone_course)) return std::nullopt;
    const auto inside = stretches_deeper_than(zone_.area, zone_depth, from, from + way);
    if (inside.empty()) return std::nullopt;
    return against(from + inside.front().begin * way, angle_of(way));
  }

  std::optional<Violation> check_step(const MotionInterval& interval, bool& was_inside, double& farthest) const {
    const Vec2 from = interval.begin().position(), way = interval.end().position() - from;
    const auto progress = [&](double share) { return dot(from + share * way - zone_.area.front(), zone_.along); };
    if (!is_near(interval, 0.0)) {
      was_inside = false;
      return std::nullopt;
    }
    bool goes_on = was_inside;
    was_inside = false;
    for (const WayPart& stretch : stretches_deeper_than(zone_.area, zone_depth, from, from + way)) {
      if (stretch.begin > 0.0 || !goes_on) farthest = progress(stretch.begin);
      farthest = std::max(farthest, progress(stretch.begin));
      if (const double back = farthest - progress(stretch.end); back > retreat_allowed) {
        const Vec2 at = from + stretch.end * way;
        return Violation{fmt::format("in {} at ({:.3f}, {:.3f}) the poses have come {:.3f} m back against the zone's direction, and at most {} m are allowed for noise", zone_.title, at.x, at.y,
                                     back, retreat_allowed),
                         make_pose(at, interval.end().heading)};
      }
      farthest = std::max(farthest, progress(stretch.end));
      goes_on = false;
      was_inside = stretch.end == 1.0;
    }
    return std::nullopt;
  }

  std::optional<Violation> check_curve(const MotionInterval& interval) {
    const auto look = [&](const Pose& pose, double course) -> std::optional<Violation> {
      ++looks_;
      if (std::abs(shorter_turn(zone_.direction, course)) <= 0.5 * pi + zone_course) return std::nullopt;
      if (depth_in(zone_.area, pose.position()) <= zone_depth) return std::nullopt;
      return against(pose.position(), course);
    };
    if (auto found = look(interval.begin(), interval.course_at_begin())) return found;
    if (auto found = look(interval.end(), interval.course_at_end())) return found;
    const double bow = interval.deviation(0.0) + interval.rounding(0.0);
    if (std::isfinite(bow)) {
      if (!is_near(interval, bow)) return std::nullopt;
      // A point at 1 m leaves its chord by what the origin does, by what turning evenly does, and by what the heading does.
      // (Of an arc that is not faced along, the course is the even turning itself.)
      const double off = interval.deviation(1.0) - interval.deviation(0.0) + interval.rounding(1.0);
      const double half = 0.5 * std::abs(interval.course_at_end() - interval.course_at_begin()) + off;
      const double middle = 0.5 * (interval.course_at_begin() + interval.course_at_end());
      if (std::abs(shorter_turn(zone_.direction, middle)) + half <= 0.5 * pi + zone_course) return std::nullopt;
      if (bow < zone_depth && stretches_deeper_than(zone_.area, zone_depth - bow, interval.begin().position(), interval.end().position()).empty()) return std::nullopt;
    }
    if (interval.depth() >= deepest || looks_ > most_looks || (options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed))) {
      const Vec2 at = interval.begin().position();
      return Violation{fmt::format("whether the vehicle keeps to the direction of {} at ({:.3f}, {:.3f}) was not decided", zone_.title, at.x, at.y), interval.begin()};
    }
    const MotionHalves halves{interval};
    if (auto found = check_curve(halves.left)) return found;
    return check_curve(halves.right);
  }

  const ZoneRules::Directed& zone_;
  const ProofOptions& options_;
  std::int64_t looks_ = 0;
};

}  // namespace

std::vector<Violation> check_directions(const Problem& problem, const Path& path, const Motion& motion, const ProofOptions& options) {
  std::vector<Violation> violations;
  for (const ZoneRules::Directed& zone : problem.zones().directed()) {
    if (auto violation = Direction{zone, options}.check(path, motion)) violations.push_back(std::move(*violation));
  }
  return violations;
}

}  // namespace waywright
