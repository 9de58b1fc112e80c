#include "waywright/proof/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "waywright/proof/pose_limits.hpp"

namespace waywright {
namespace {

constexpr double relative_slack = 1e-6;      // of a limit
constexpr double curvature_tolerance = 1e-6;  // 1/m, of a curvature that goes on
constexpr std::size_t most_intervals = 400000;
constexpr int deepest = 48;                  // halvings
constexpr double most_turning = 1e3;         // rad, of one arc: its heading loses digits with every turn

bool finite_curve(const Curve& curve) {
  return std::visit(
      [](const auto& c) {
        using C = std::decay_t<decltype(c)>;
        if constexpr (std::is_same_v<C, Line>) {
          return is_finite(c.from) && is_finite(c.to) && c.from != c.to;
        } else if constexpr (std::is_same_v<C, Arc>) {
          return is_finite(c.start) && std::isfinite(c.curvature) && std::isfinite(c.length) && c.length > 0.0;
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

/// Branch and bound: is `bound` within `limit` everywhere? Fills where and how much where it is not.
template <class Bound, class Value>
std::optional<Violation> exceeds(const std::vector<MotionInterval>& intervals, double limit, const char* what,
                                 const char* unit_name, Bound bound, Value value) {
  const double allowed = limit * (1.0 + relative_slack);
  std::vector<MotionInterval> stack(intervals.rbegin(), intervals.rend());
  std::size_t visited = 0;
  std::optional<Violation> worst;
  double greatest = allowed;
  while (!stack.empty()) {
    const MotionInterval interval = stack.back();
    stack.pop_back();
    if (bound(interval) <= greatest) continue;
    if (const double found = std::abs(value(interval)); found > greatest) {
      greatest = found;
      worst = Violation{fmt::format("the {} is {:.4f} {} at ({:.3f}, {:.3f}), over the limit of {:.4f} {}", what, found,
                                    unit_name, interval.begin().x, interval.begin().y, limit, unit_name),
                        interval.begin()};
      if (found > 1e3 * allowed) return worst;
      continue;
    }
    // Halving a found excess only sharpens a figure that is already over the limit.
    if (++visited > most_intervals || interval.depth() > deepest || (worst && visited > 4000)) {
      if (worst) return worst;
      return Violation{fmt::format("the {} could not be shown to keep the limit of {:.4f} {} near ({:.3f}, {:.3f})", what,
                                   limit, unit_name, interval.begin().x, interval.begin().y),
                       interval.begin()};
    }
    auto [left, right] = interval.halve();
    stack.push_back(right);
    stack.push_back(left);
  }
  return worst;
}

/// A vehicle that moves goes on in its direction and, where that is known and steering takes time, with its curvature.
std::optional<Violation> check_entry_motion(const Problem& problem, const Piece& first) {
  const auto& motion = problem.motion();
  if (!motion) return std::nullopt;
  const auto name = [](int direction) { return direction < 0 ? "backwards" : direction > 0 ? "forwards" : "on the spot"; };
  if (first.direction != motion->direction) {
    return Violation{fmt::format("the vehicle moves {} when the plan begins, and the path begins {}", name(motion->direction), name(first.direction)),
                     problem.first_pose()};
  }
  if (std::holds_alternative<PoseSequence>(first.curve) || !problem.vehicle().steering_takes_time()) return std::nullopt;
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
    if (const auto* arc = std::get_if<Arc>(&piece.curve); arc != nullptr && std::abs(arc->curvature * arc->length) > most_turning) {
      violations.push_back({fmt::format("piece {} is an arc that turns by {:.0f} rad; at most {:.0f} rad can be proven", i,
                                        std::abs(arc->curvature * arc->length), most_turning),
                            std::nullopt});
    }
    const bool turn = std::holds_alternative<Turn>(piece.curve);
    if (turn != (piece.direction == 0) || std::abs(piece.direction) > 1) {
      violations.push_back({fmt::format("piece {} has direction {}, which does not fit its kind", i, piece.direction),
                            std::nullopt});
    }
  }
  return violations;
}

std::vector<Violation> check_continuity(const Problem& problem, const Path& path, const ProofOptions& options) {
  std::vector<Violation> violations;
  const auto compare = [&](const Pose& is, const Pose& should, const std::string& what) {
    const double off = distance(is.position(), should.position());
    const double turned = std::abs(shorter_turn(is.heading, should.heading));
    if (off <= options.position_tolerance && turned <= options.heading_tolerance) return;
    violations.push_back({fmt::format("{} by {:.6f} m and {:.6f} rad ({:.2f} degrees)", what, off, turned,
                                      turned * 180.0 / pi),
                          is});
  };
  compare(start_pose(path), problem.first_pose(), "the path misses the start pose");
  if (auto violation = check_entry_motion(problem, path.pieces.front())) violations.push_back(*violation);
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    const std::vector<MotionInterval> intervals = MotionInterval::of(path.pieces[i]);
    for (std::size_t k = 0; k + 1 < intervals.size(); ++k) {
      compare(intervals[k + 1].begin(), intervals[k].end(), fmt::format("piece {} jumps inside", i));
    }
    if (i + 1 < path.pieces.size()) {
      compare(start_pose(path.pieces[i + 1]), end_pose(path.pieces[i]), fmt::format("the path jumps after piece {}", i));
    }
  }
  compare(end_pose(path), problem.last_pose(), "the path misses the goal pose");
  return violations;
}

std::vector<Violation> check_limits(const Vehicle& vehicle, const Path& path) {
  std::vector<Violation> violations = check_pose_sequences(vehicle, path);
  std::vector<MotionInterval> smooth;
  bool turns = false;
  for (const Piece& piece : path.pieces) {
    if (std::holds_alternative<PoseSequence>(piece.curve)) continue;
    if (std::holds_alternative<Turn>(piece.curve)) {
      turns = true;
      continue;
    }
    std::vector<MotionInterval> intervals = MotionInterval::of(piece);
    if (vehicle.steering_takes_time()) {
      for (std::size_t i = 0; i + 1 < intervals.size(); ++i) {
        const double before = intervals[i].curvature_at_end();
        const double after = intervals[i + 1].curvature_at_begin();
        if (std::abs(after - before) > curvature_tolerance) {
          violations.push_back({fmt::format("the curvature jumps by {:.6f} 1/m inside a piece, where the vehicle does not stand",
                                            std::abs(after - before)),
                                intervals[i + 1].begin()});
        }
      }
    }
    smooth.insert(smooth.end(), std::make_move_iterator(intervals.begin()), std::make_move_iterator(intervals.end()));
  }
  if (turns && !vehicle.can_turn_on_the_spot()) {
    violations.push_back({"the path turns on the spot, which a tricycle drive cannot do", std::nullopt});
  }
  if (const double limit = vehicle.max_curvature(); std::isfinite(limit)) {
    if (auto v = exceeds(smooth, limit, "curvature", "1/m", [](const MotionInterval& m) { return m.curvature_bound(); },
                         [](const MotionInterval& m) { return m.curvature_at_begin(); })) {
      violations.push_back(*v);
    }
  }
  if (vehicle.limits.curvature_rate) {
    if (auto v = exceeds(smooth, *vehicle.limits.curvature_rate, "curvature rate", "1/m²",
                         [](const MotionInterval& m) { return m.curvature_rate_bound(); },
                         [](const MotionInterval& m) { return m.curvature_rate_at_begin(); })) {
      violations.push_back(*v);
    }
  }
  return violations;
}

}  // namespace waywright
