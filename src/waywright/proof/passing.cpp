#include "waywright/proof/passing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>

#include "waywright/geometry/obstacle_index.hpp"

namespace waywright {
namespace {

constexpr int deepest = 48;  // halvings
constexpr std::int64_t most_looks = 2'000'000;  // of a path

/// How much may be looked at, for all waypoints together.
struct Looks {
  std::int64_t done = 0;
  const std::atomic<bool>* cancel = nullptr;
  bool is_over() const { return done > most_looks || (cancel != nullptr && cancel->load(std::memory_order_relaxed)); }
};

/// The first place of a motion, from a place on, that is within a radius of a point.
class Passing {
 public:
  Passing(Vec2 point, double radius, Looks& looks) : point_{point}, radius_{radius}, looks_{looks} {}

  /// Of one interval, from the share `from` of it (by halving) on; where on it.
  std::optional<double> first_of(const MotionInterval& interval, double from) { return first(interval, 0.0, 1.0, from, 0); }
  /// m, about: where the path is far, the chords of its curves are looked at.
  double nearest() const { return nearest_; }

 private:
  std::optional<double> first(const MotionInterval& part, double low, double high, double from, int depth) {
    if (high < from || looks_.is_over()) return std::nullopt;
    if (low >= from && look(part.begin())) return low;
    const double apart = point_segment_distance(point_, part.begin().position(), part.end().position());
    if (apart > radius_ + part.deviation(0.0) + part.rounding(0.0) || depth >= deepest) {
      nearest_ = std::min(nearest_, apart);
      if (look(part.end())) return high;
      return std::nullopt;
    }
    const double middle = 0.5 * (low + high);
    const MotionHalves halves{part};
    if (const auto found = first(halves.left, low, middle, from, depth + 1)) return found;
    return first(halves.right, middle, high, from, depth + 1);
  }

  bool look(const Pose& pose) {
    ++looks_.done;
    const double d = distance(pose.position(), point_);
    nearest_ = std::min(nearest_, d);
    return d <= radius_;
  }

  Vec2 point_;
  double radius_;
  double nearest_ = std::numeric_limits<double>::infinity();
  Looks& looks_;
};

}  // namespace

std::vector<Violation> check_waypoints(const Problem& problem, const Motion& motion, const ProofOptions& options) {
  std::vector<Violation> violations;
  const std::vector<Vec2>& waypoints = problem.scenario().waypoints;
  const double radius = problem.scenario().waypoint_radius;
  std::size_t interval = 0;
  double from = 0.0;
  Looks looks{0, options.cancel};
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    Passing passing{waypoints[i], radius + options.position_tolerance, looks};
    std::optional<double> found;
    std::size_t k = interval;
    for (; k < motion.intervals().size() && !found; ++k) found = passing.first_of(motion.intervals()[k], k == interval ? from : 0.0);
    if (found) {
      interval = k - 1;
      from = *found;
      continue;
    }
    if (looks.is_over()) {
      violations.push_back({fmt::format("whether the path passes waypoint {} at ({:.3f}, {:.3f}) was not decided", i + 1, waypoints[i].x, waypoints[i].y), make_pose(waypoints[i], 0.0)});
      return violations;
    }
    violations.push_back({fmt::format("the path does not pass waypoint {} at ({:.3f}, {:.3f}){}: it comes as near as about {:.3f} m, and {:.3f} m are allowed", i + 1,
                                      waypoints[i].x, waypoints[i].y, i > 0 ? " after those before it" : "", passing.nearest(), radius),
                          make_pose(waypoints[i], 0.0)});
  }
  return violations;
}

}  // namespace waywright
