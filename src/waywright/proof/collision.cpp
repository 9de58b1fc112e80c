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

/// Rounding of coordinates, distances and hulls: some ulps of the largest coordinate. m
double rounding_slack(const MotionInterval& interval, double radius) {
  const Pose& p = interval.begin();
  const Pose& q = interval.end();
  return 1e-11 + 1e-14 * (std::max({std::abs(p.x), std::abs(p.y), std::abs(q.x), std::abs(q.y)}) + radius);
}

class Search {
 public:
  Search(const World& world, const Footprint& footprint, double tolerance, std::size_t without)
      : world_{world}, footprint_{footprint}, tolerance_{tolerance}, without_{without}, radius_{footprint.radius()} {
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
      best_.length += interval.length();
      look_at(interval.begin());
      look_at(interval.end());
    }
    // Tightest stretches first would be best; the order of travel is good enough because the ends have been looked at.
    std::vector<MotionInterval> stack(intervals.rbegin(), intervals.rend());
    while (!stack.empty() && best_.upper > 0.0) {
      if (best_.queries > most_queries || stack.back().depth() > deepest) {
        best_.complete = false;
        break;
      }
      const MotionInterval interval = std::move(stack.back());
      stack.pop_back();
      const double bound = lower_bound(interval);
      if (bound >= best_.upper - effective_tolerance()) {
        best_.lower = std::min(best_.lower, bound);
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
  double effective_tolerance() const { return std::max(least_tolerance, std::min(tolerance_, 0.5 * best_.upper)); }

  void look_at(const Pose& pose) {
    ++best_.queries;
    const Contact contact = world_.clearance(footprint_, pose, best_.upper, without_);
    if (contact.clearance < best_.upper) {
      best_.upper = contact.clearance;
      best_.tightest = pose;
      best_.contact = contact;
    }
  }

  double lower_bound(const MotionInterval& interval) {
    const double deviation = interval.deviation(rotating_radius_) + rounding_slack(interval, radius_);
    if (!(deviation < cap)) return -1.0;
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
      least = std::min(least, world_.clearance(hull_, grown_, enough, without_).clearance);
    }
    return least - deviation;
  }

  const World& world_;
  const Footprint& footprint_;
  double tolerance_;
  std::size_t without_;
  double radius_;
  double rotating_radius_ = 0.0;
  double grown_ = 0.0;
  std::vector<Ring> parts_;
  Ring corners_, hull_;
  SweptClearance best_;
};

}  // namespace

SweptClearance swept_clearance(const World& world, const Footprint& footprint,
                               const std::vector<MotionInterval>& intervals, double tolerance, std::size_t without) {
  return Search{world, footprint, tolerance, without}.run(intervals);
}

}  // namespace waywright
