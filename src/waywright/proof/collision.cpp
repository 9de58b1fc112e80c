#include "waywright/proof/collision.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/geometry/convex_parts.hpp"

namespace waywright {
namespace {

constexpr double cap = 10.0;                   // m; clearance beyond it is reported as this
constexpr std::int64_t most_queries = 4000000;  // bound on the work for one path
constexpr int deepest = 48;                    // halvings: only a cusp, where no bound on turning exists, gets there
constexpr double least_tolerance = 1e-7;       // m

constexpr double fine_tolerance = 5e-7;        // m, where the truth may just meet what is required
constexpr double least_slack = 1e-11;          // m, rounding of hulls and turned corners
constexpr double distance_rounding = 4e-15;    // of the coordinates: some units in the last place

class Search {
 public:
  Search(const World& world, const Footprint& footprint, const SweepOptions& options)
      : world_{world}, footprint_{footprint}, options_{options}, radius_{footprint.radius()} {
    // Obstacles far away are long ones, too: a point of a line is rounded like its ends.
    if (!world.empty()) {
      const Box box = world.bounds();
      extent_ = std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
    }
    if (footprint.is_disc()) {
      parts_ = {Ring{Vec2{}}};
      rotating_radius_ = 0.0;
      grown_ = footprint.disc;
    } else {
      parts_ = convex_parts(footprint.polygon);
      rotating_radius_ = radius_;
    }
    best_.upper = best_.lower = cap;
  }

  SweptClearance run(const std::vector<MotionInterval>& intervals) {
    for (const MotionInterval& interval : intervals) {
      if (is_canceled()) break;
      best_.length += interval.length();
      look_at(interval.begin());
      look_at(interval.end());
    }
    // Tightest stretches first would be best; the order of travel is good enough because the ends have been looked at.
    std::vector<MotionInterval> stack(intervals.rbegin(), intervals.rend());
    while (!stack.empty() && best_.upper > 0.0) {
      if (is_canceled() || best_.queries > most_queries || stack.back().depth() > deepest) {
        best_.complete = false;
        break;
      }
      const MotionInterval interval = std::move(stack.back());
      stack.pop_back();
      const Bound bound = lower_bound(interval);
      if (is_enough(bound)) {
        best_.lower = std::min(best_.lower, bound.clearance);
        continue;
      }
      auto [left, right] = interval.halve();
      look_at(right.begin());
      stack.push_back(std::move(right));
      stack.push_back(std::move(left));
    }
    if (best_.upper <= 0.0 || !best_.complete) best_.lower = 0.0;
    best_.lower = std::clamp(best_.lower, 0.0, best_.upper);
    return best_;
  }

 private:
  bool is_canceled() const { return options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed); }

  double effective_tolerance() const { return std::max(least_tolerance, std::min(options_.tolerance, 0.5 * best_.upper)); }

  void look_at(const Pose& pose) {
    ++best_.queries;
    const Contact contact = world_.clearance(footprint_, pose, best_.upper, options_.without);
    if (contact.clearance < best_.upper) {  // never where nothing is within the cap
      best_.upper = contact.clearance;
      best_.tightest = pose;
      best_.contact = contact;
    }
  }

  struct Bound {
    double clearance;
    double deviation;  // that was taken off
  };

  /// Within the tolerance of the least clearance found; and where that could pass, not short of what is required for want of sharpness.
  bool is_enough(const Bound& bound) const {
    if (bound.clearance < best_.upper - effective_tolerance()) return false;
    if (bound.clearance >= options_.required || best_.upper < options_.required - fine_tolerance) return true;
    return bound.clearance >= best_.upper - fine_tolerance && bound.deviation <= 0.5 * fine_tolerance;
  }

  Bound lower_bound(const MotionInterval& interval) {
    double deviation = interval.deviation(rotating_radius_);
    if (interval.is_translation()) {
      const Pose& p = interval.begin();
      const Pose& q = interval.end();
      deviation = distance_rounding * (std::max({extent_, std::abs(p.x), std::abs(p.y), std::abs(q.x), std::abs(q.y)}) + radius_);
      best_.rounding = std::max(best_.rounding, deviation);
    } else {
      deviation += least_slack + interval.rounding(radius_) + 1e-14 * extent_;
    }
    if (!(deviation < cap)) return {-1.0, deviation};
    const double enough = best_.upper + deviation;
    const Frame a{interval.begin()};
    const Frame b{interval.end()};
    double least = enough;
    for (const Ring& part : parts_) {
      corners_.clear();
      for (const Vec2 p : part) corners_.push_back(a.to_world(p));
      for (const Vec2 p : part) corners_.push_back(b.to_world(p));
      convex_hull(corners_, hull_);
      ++best_.queries;
      least = std::min(least, world_.clearance(hull_, grown_, enough, options_.without).clearance);
    }
    return {least - deviation, deviation};
  }

  const World& world_;
  const Footprint& footprint_;
  const SweepOptions& options_;
  double radius_;
  double extent_ = 0.0;  // greatest coordinate of the world
  double rotating_radius_ = 0.0;
  double grown_ = 0.0;
  std::vector<Ring> parts_;
  Ring corners_, hull_;
  SweptClearance best_;
};

}  // namespace

SweptClearance swept_clearance(const World& world, const Footprint& footprint, const std::vector<MotionInterval>& intervals,
                               const SweepOptions& options) {
  return Search{world, footprint, options}.run(intervals);
}

}  // namespace waywright
