#include "waywright/proof/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>

#include "waywright/curve/bezier.hpp"
#include "waywright/curve/clothoid.hpp"
#include "waywright/proof/pose_limits.hpp"

namespace waywright {
namespace {

constexpr double relative_slack = 1e-6;      // of a limit
constexpr double curvature_tolerance = 1e-6;  // 1/m, of a curvature that goes on
constexpr double course_tolerance = 1e-6;     // rad
constexpr double estimated_course = 0.1;      // rad, of poses from outside
constexpr std::size_t most_intervals = 400000;
constexpr int deepest = 48;                  // halvings
constexpr double most_turning = 1e3;         // rad, of one curve: its heading loses digits with every turn

bool finite_curve(const Curve& curve) {
  return std::visit(
      [](const auto& c) {
        using C = std::decay_t<decltype(c)>;
        if constexpr (std::is_same_v<C, Line>) {
          return is_finite(c.from) && is_finite(c.to) && c.from != c.to;
        } else if constexpr (std::is_same_v<C, Arc>) {
          return is_finite(c.start) && std::isfinite(c.curvature) && std::isfinite(c.length) && c.length > 0.0;
        } else if constexpr (std::is_same_v<C, Clothoid>) {
          return is_finite(c.start) && std::isfinite(c.curvature) && std::isfinite(end_curvature(c)) && std::isfinite(c.length) && c.length > 0.0;
        } else if constexpr (std::is_same_v<C, Turn>) {
          return is_finite(c.at) && std::isfinite(c.from) && std::isfinite(c.angle);
        } else if constexpr (std::is_same_v<C, PoseSequence>) {
          return c.poses.size() >= 2 &&
                 std::all_of(c.poses.begin(), c.poses.end(), [](const Pose& p) { return is_finite(p); });
        } else {
          return !c.spans.empty() && std::all_of(c.spans.begin(), c.spans.end(), [](const BezierSpan& s) {
            if (s.degree < 1 || s.degree > 5) return false;
            for (std::size_t i = 0; i <= static_cast<std::size_t>(s.degree); ++i) {
              if (!is_finite(s.control[i])) return false;
            }
            return true;
          });
        }
      },
      curve);
}

/// rad, by no less than an arc or clothoid turns.
double turning_of(const Curve& curve) {
  if (const auto* arc = std::get_if<Arc>(&curve)) return std::abs(arc->curvature * arc->length);
  if (const auto* clothoid = std::get_if<Clothoid>(&curve)) return greatest_curvature(*clothoid) * clothoid->length;
  return 0.0;
}

/// Branch and bound over a path's curves: does a quantity of curvature keep its limit everywhere? Tells where and by how much it does not.
template <class Bounds>
class LimitSearch {
 public:
  /// `value` of a curve's point is what the bounds bound. Where there are none, curvature changes evenly: it is greatest at an end.
  struct Quantity {
    const char* name;
    const char* unit;
    double (*value)(const CurvePoint& point);
  };
  LimitSearch(const Quantity& quantity, double limit) : quantity_{quantity}, limit_{limit}, greatest_{limit * (1.0 + relative_slack)} {}

  std::optional<Violation> run(const Motion& motion, const Path& path) {
    for (std::size_t i = 0; i < path.pieces.size(); ++i) {
      if (std::holds_alternative<PoseSequence>(path.pieces[i].curve)) continue;
      for (const MotionInterval& interval : motion.of_piece(i)) {
        if (!goes_on(interval)) return worst_;
      }
    }
    return worst_;
  }

 private:
  bool goes_on(const MotionInterval& interval) {
    if (interval.span() != nullptr) return goes_on(interval, Bounds{interval.span()->bounds}, 0.0, 1.0, 0);
    const double rate = interval.curvature_rate();
    const double at_begin = std::abs(quantity_.value({{}, 0.0, interval.curvature_at_begin(), rate}));
    const double at_end = std::abs(quantity_.value({{}, 0.0, interval.curvature_at_end(), rate}));
    if (std::max(at_begin, at_end) <= greatest_) return true;
    return at_end > at_begin ? found_excess(at_end, interval.end()) : found_excess(at_begin, interval.begin());
  }

  /// Of the part of the interval's span that begins at `u` and is `width` wide.
  bool goes_on(const MotionInterval& interval, const Bounds& bounds, double u, double width, int depth) {
    if (bounds.greatest() <= greatest_) return true;
    if (const double found = std::abs(quantity_.value(evaluate(interval.span()->span, u))); found > greatest_) {
      return found_excess(found, interval.pose_at(u));
    }
    // Halving a found excess only sharpens a figure that is already over the limit.
    if (++visited_ > most_intervals || depth > deepest || (worst_ && visited_ > 4000)) {
      if (worst_) return false;
      const Pose at = interval.pose_at(u);
      worst_ = Violation{fmt::format("the {} could not be shown to keep the limit of {:.4f} {} near ({:.3f}, {:.3f})", quantity_.name, limit_,
                                     quantity_.unit, at.x, at.y),
                         at};
      return false;
    }
    Bounds left, right;
    bounds.halve(left, right);
    return goes_on(interval, left, u, 0.5 * width, depth + 1) && goes_on(interval, right, u + 0.5 * width, 0.5 * width, depth + 1);
  }

  bool found_excess(double found, const Pose& at) {
    greatest_ = found;
    worst_ = Violation{fmt::format("the {} is {:.4f} {} at ({:.3f}, {:.3f}), over the limit of {:.4f} {}", quantity_.name, found, quantity_.unit, at.x,
                                   at.y, limit_, quantity_.unit),
                       at};
    return found <= 1e3 * limit_ * (1.0 + relative_slack);
  }

  Quantity quantity_;
  double limit_;
  double greatest_;
  std::size_t visited_ = 0;
  std::optional<Violation> worst_;
};

/// A vehicle that moves goes on in its direction and, where a change of it takes time, with its curvature.
std::optional<Violation> check_entry_motion(const Problem& problem, const Piece& first) {
  const auto& motion = problem.motion();
  if (!motion) return std::nullopt;
  const auto name = [](int direction) { return direction < 0 ? "backwards" : direction > 0 ? "forwards" : "on the spot"; };
  if (first.direction != motion->direction) {
    return Violation{fmt::format("the vehicle moves {} when the plan begins, and the path begins {}", name(motion->direction), name(first.direction)),
                     problem.first_pose()};
  }
  if (const auto* poses = std::get_if<PoseSequence>(&first.curve); poses != nullptr && motion->course) {
    for (std::size_t i = 1; i < poses->poses.size(); ++i) {
      const Vec2 way = poses->poses[i].position() - poses->poses[0].position();
      if (!(norm(way) > 0.0)) continue;
      if (const double off = shorter_turn(*motion->course, angle_of(way)); std::abs(off) <= estimated_course) break;
      return Violation{fmt::format("the vehicle's course is {:.3f} rad when the plan begins, and that of the poses about {:.3f} rad", *motion->course, angle_of(way)), problem.first_pose()};
    }
    return std::nullopt;
  }
  if (motion->course.has_value() != first.heading.has_value()) {
    return Violation{motion->course ? "the vehicle does not face along its way when the plan begins, and the path does not begin with a heading of its own"
                                    : "the vehicle moves along its heading when the plan begins, and the path begins with a heading of its own",
                     problem.first_pose()};
  }
  if (motion->course) {
    const double begins_on = start_pose(Piece{first.curve, first.direction, {}}).heading;
    if (const double off = shorter_turn(*motion->course, begins_on); std::abs(off) > course_tolerance) {
      return Violation{fmt::format("the vehicle's course is {:.6f} rad when the plan begins, and the path's {:.6f} rad", *motion->course, begins_on), problem.first_pose()};
    }
    const double whole = length(first), turning = whole > 0.0 ? first.heading->turn / whole : 0.0;
    if (problem.vehicle().limits.angular_acceleration && std::abs(turning - motion->turning) > curvature_tolerance) {
      return Violation{fmt::format("the vehicle turns by {:.6f} rad/m when the plan begins, and on the path by {:.6f} rad/m", motion->turning, turning), problem.first_pose()};
    }
    if (!problem.vehicle().steering_takes_time()) return std::nullopt;
  }
  if (std::holds_alternative<PoseSequence>(first.curve) || !problem.vehicle().stands_at_curvature_jumps()) return std::nullopt;  // of poses: judge/entry
  const double begins = start_curvature(first);
  if (std::abs(begins - motion->curvature) <= curvature_tolerance) return std::nullopt;
  return Violation{fmt::format("the vehicle's way has a curvature of {:.6f} 1/m when the plan begins, and the path begins with {:.6f} 1/m", motion->curvature, begins),
                   problem.first_pose()};
}

}  // namespace

std::vector<Violation> check_form(const Path& path) {
  std::vector<Violation> violations;
  if (path.pieces.empty()) violations.push_back({"the path has no pieces", std::nullopt});
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    const Piece& piece = path.pieces[i];
    if (!finite_curve(piece.curve)) {
      violations.push_back({fmt::format("piece {} is empty or has a number that is not finite", i), std::nullopt});
      continue;
    }
    if (const double turning = turning_of(piece.curve); turning > most_turning) {
      violations.push_back({fmt::format("piece {} turns by {:.0f} rad; at most {:.0f} rad can be proven", i, turning, most_turning), std::nullopt});
    }
    const bool turn = std::holds_alternative<Turn>(piece.curve);
    if (turn != (piece.direction == 0) || std::abs(piece.direction) > 1) {
      violations.push_back({fmt::format("piece {} has direction {}, which does not fit its kind", i, piece.direction),
                            std::nullopt});
    }
    if (!piece.heading) continue;
    if (!std::isfinite(piece.heading->from) || !std::isfinite(piece.heading->turn) || std::abs(piece.heading->turn) > most_turning) {
      violations.push_back({fmt::format("the heading along piece {} is not finite or turns by more than {:.0f} rad", i, most_turning), std::nullopt});
    }
    if (piece.direction != 1 || !(std::holds_alternative<Line>(piece.curve) || std::holds_alternative<Arc>(piece.curve))) {
      violations.push_back({fmt::format("piece {} has a heading of its own, which only lines and arcs in direction 1 can have", i), std::nullopt});
    }
  }
  return violations;
}

std::vector<Violation> check_continuity(const Problem& problem, const Path& path, const Motion& motion, const ProofOptions& options) {
  std::vector<Violation> violations;
  const auto compare = [&](const Pose& is, const Pose& should, const auto& what) {
    const double off = distance(is.position(), should.position());
    const double turned = std::abs(shorter_turn(is.heading, should.heading));
    if (off <= options.position_tolerance && turned <= options.heading_tolerance) return;
    violations.push_back({fmt::format("{} by {:.6f} m and {:.6f} rad ({:.2f} degrees)", what(), off, turned,
                                      turned * 180.0 / pi),
                          is});
  };
  compare(start_pose(path), problem.first_pose(), [] { return "the path misses the start pose"; });
  if (auto violation = check_entry_motion(problem, path.pieces.front())) violations.push_back(*violation);
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    const std::span<const MotionInterval> intervals = motion.of_piece(i);
    for (std::size_t k = 0; k + 1 < intervals.size(); ++k) {
      compare(intervals[k + 1].begin(), intervals[k].end(), [i] { return fmt::format("piece {} jumps inside", i); });
    }
    if (i + 1 < path.pieces.size()) {
      compare(start_pose(path.pieces[i + 1]), end_pose(path.pieces[i]), [i] { return fmt::format("the path jumps after piece {}", i); });
    }
  }
  if (problem.free_goal() == nullptr) {
    compare(end_pose(path), problem.last_pose(), [] { return "the path misses the goal pose"; });
  } else if (const Pose end = end_pose(path); !problem.is_goal(end, options.position_tolerance, options.heading_tolerance)) {
    const std::vector<Vec2>& area = problem.free_goal()->area;
    const Vec2 nearest = area.size() == 1 ? area.front() : nearest_in(area, end.position());
    violations.push_back({fmt::format("the path ends at ({:.6f}, {:.6f}), {:.6f} m from the goal", end.x, end.y, distance(end.position(), nearest)), end});
  }
  return violations;
}

std::vector<Violation> check_limits(const Vehicle& vehicle, const Path& path, const Motion& motion) {
  std::vector<Violation> violations = check_pose_sequences(vehicle, path);
  bool turns = false, slides = false;
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    slides = slides || path.pieces[i].heading;
    const auto* turn = std::get_if<Turn>(&path.pieces[i].curve);
    turns = turns || (turn != nullptr && turn->angle != 0.0);  // one by nothing is standing still
    if (!vehicle.steering_takes_time() || std::holds_alternative<PoseSequence>(path.pieces[i].curve)) continue;
    const std::span<const MotionInterval> intervals = motion.of_piece(i);
    for (std::size_t k = 0; k + 1 < intervals.size(); ++k) {
      const double before = intervals[k].curvature_at_end();
      const double after = intervals[k + 1].curvature_at_begin();
      if (std::abs(after - before) > curvature_tolerance) {
        violations.push_back({fmt::format("the curvature jumps by {:.6f} 1/m inside a piece, where the vehicle does not stand",
                                          std::abs(after - before)),
                              intervals[k + 1].begin()});
      }
    }
  }
  if (slides && !vehicle.moves_any_way()) {
    violations.push_back({fmt::format("the vehicle does not face along the path, as {} drive must", std::holds_alternative<Tricycle>(vehicle.drive) ? "a tricycle" : "a differential"), std::nullopt});
  }
  if (turns && !vehicle.can_turn_on_the_spot()) {
    violations.push_back({"the path turns on the spot, which a tricycle drive cannot do", std::nullopt});
  }
  if (const double limit = vehicle.max_curvature(); std::isfinite(limit)) {
    LimitSearch<CurvatureBounds> search{
        {"curvature", "1/m", [](const CurvePoint& p) { return p.curvature; }}, limit};
    if (auto violation = search.run(motion, path)) violations.push_back(std::move(*violation));
  }
  if (vehicle.limits.curvature_rate) {
    LimitSearch<CurvatureRateBounds> search{
        {"curvature rate", "1/m²", [](const CurvePoint& p) { return p.curvature_rate; }}, *vehicle.limits.curvature_rate};
    if (auto violation = search.run(motion, path)) violations.push_back(std::move(*violation));
  }
  return violations;
}

}  // namespace waywright
