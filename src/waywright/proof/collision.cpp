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
  Search(const World& world, const SweptBody& body, const SweepOptions& options, SweepMemory& memory)
      : world_{world}, body_{body}, options_{options}, memory_{memory} {
    // Obstacles far away are long ones, too: a point of a line is rounded like its ends.
    if (!world.empty()) {
      const Box box = world.bounds();
      extent_ = std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
    }
    best_.upper = best_.lower = cap;
  }

  SweptClearance run(std::span<const MotionInterval> motion) {
    const MotionInterval* before = nullptr;
    for (const MotionInterval& interval : motion) {
      if (is_canceled()) break;
      best_.length += interval.length();
      if (before == nullptr || before->end() != interval.begin()) look_at(interval.begin(), Frame{interval.begin()});
      look_at(interval.end(), Frame{interval.end()});
      before = &interval;
    }
    // Tightest stretches first would be best; the order of travel is good enough because the ends have been looked at.
    for (const MotionInterval& interval : motion) {
      if (!goes_on(interval, Frame{interval.begin()}, Frame{interval.end()})) break;
    }
    if (best_.upper <= 0.0 || !best_.complete) best_.lower = 0.0;
    best_.lower = std::clamp(best_.lower, 0.0, best_.upper);
    return best_;
  }

 private:
  bool is_canceled() const { return options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed); }

  double effective_tolerance() const { return std::max(least_tolerance, std::min(options_.tolerance, 0.5 * best_.upper)); }

  /// Bounds an interval whose ends are placed so; false where the search ends.
  bool goes_on(const MotionInterval& interval, const Frame& begin, const Frame& end) {
    if (best_.upper <= 0.0) return false;
    if (is_canceled() || best_.queries > most_queries || interval.depth() > deepest) {
      best_.complete = false;
      return false;
    }
    const Bound bound = lower_bound(interval, begin, end);
    if (is_enough(bound)) {
      best_.lower = std::min(best_.lower, bound.clearance);
      return true;
    }
    const MotionHalves halves{interval};
    const Frame middle{halves.right.begin()};
    look_at(halves.right.begin(), middle);
    return goes_on(halves.left, begin, middle) && goes_on(halves.right, middle, end);
  }

  void look_at(const Pose& pose, const Frame& frame) {
    ++best_.queries;
    Ring& ring = memory_.corners;
    ring.clear();
    if (body_.footprint.is_disc()) ring.push_back(pose.position());
    for (const Vec2 p : body_.footprint.polygon) ring.push_back(frame.to_world(p));
    const Contact contact = world_.clearance(ring, body_.grown, best_.upper, options_.without);
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

  Bound lower_bound(const MotionInterval& interval, const Frame& begin, const Frame& end) {
    double deviation = interval.deviation(body_.rotating_radius);
    if (interval.is_translation()) {
      const Pose& p = interval.begin();
      const Pose& q = interval.end();
      deviation = distance_rounding * (std::max({extent_, std::abs(p.x), std::abs(p.y), std::abs(q.x), std::abs(q.y)}) + body_.radius);
      best_.rounding = std::max(best_.rounding, deviation);
    } else {
      deviation += least_slack + interval.rounding(body_.radius) + 1e-14 * extent_;
    }
    if (!(deviation < cap)) return {-1.0, deviation};
    double least = best_.upper + deviation;
    for (const Ring& part : body_.parts) {
      Ring& corners = memory_.corners;
      corners.clear();
      for (const Vec2 p : part) corners.push_back(begin.to_world(p));
      for (const Vec2 p : part) corners.push_back(end.to_world(p));
      convex_hull(corners, memory_.hull);
      ++best_.queries;
      least = std::min(least, world_.least_clearance(memory_.hull, body_.grown, least, options_.without));
    }
    return {least - deviation, deviation};
  }

  const World& world_;
  const SweptBody& body_;
  const SweepOptions& options_;
  SweepMemory& memory_;
  double extent_ = 0.0;  // greatest coordinate of the world
  SweptClearance best_;
};

}  // namespace

SweptBody::SweptBody(Footprint of) : footprint{std::move(of)}, radius{footprint.radius()} {
  if (footprint.is_disc()) {
    parts = {Ring{Vec2{}}};
    grown = footprint.disc;
  } else {
    parts = convex_parts(footprint.polygon);
    rotating_radius = radius;
  }
}

void SweepMemory::reserve(const SweptBody& body) {
  std::size_t greatest = 1;
  for (const Ring& part : body.parts) greatest = std::max(greatest, part.size());
  corners.reserve(std::max(body.footprint.polygon.size(), 2 * greatest));
  hull.reserve(4 * greatest);
}

SweptClearance swept_clearance(const World& world, const SweptBody& body, std::span<const MotionInterval> motion, const SweepOptions& options,
                               SweepMemory& memory) {
  return Search{world, body, options, memory}.run(motion);
}

}  // namespace waywright
