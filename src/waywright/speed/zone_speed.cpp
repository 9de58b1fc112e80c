#include "waywright/speed/zone_speed.hpp"

#include <algorithm>
#include <limits>

#include "waywright/geometry/convex_parts.hpp"

namespace waywright {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Convex parts of what drives, and how much more than them it is.
struct Body {
  explicit Body(const Footprint& footprint) {
    if (footprint.is_disc()) {
      parts = {Ring{Vec2{}}};
      grown = footprint.disc;
    } else {
      parts = convex_parts(footprint.polygon);
    }
    radius = footprint.radius();
  }
  std::vector<Ring> parts;
  double grown = 0.0, radius = 0.0;
};

bool is_near(const Body& body, const Pose& a, const Pose& b, const Box& box, double more) {
  const Box between{{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
  return meet(between, box, body.radius + more);
}

}  // namespace

LimitsAlong zone_limits(const Problem& problem, const std::vector<Sample>& samples, double tolerance) {
  LimitsAlong limits;
  const std::vector<ZoneRules::SpeedLimit>& zones = problem.zones().limits();
  if (zones.empty() || samples.empty()) return limits;
  const Body body{problem.footprint()};
  const double more = problem.pose_error_margin() + tolerance;
  limits.steps.assign(samples.size() - 1, unlimited);
  limits.samples.assign(samples.size(), unlimited);
  Ring corners, hull;
  // Parts at one pose or two, in one hull.
  const auto touches = [&](const Pose& a, const Pose& b, const ZoneRules::SpeedLimit& zone) {
    if (!is_near(body, a, b, zone.box, more)) return false;
    return std::any_of(body.parts.begin(), body.parts.end(), [&](const Ring& part) {
      corners.clear();
      for (const Pose* pose : {&a, &b}) {
        const Frame frame{*pose};
        for (const Vec2 p : part) corners.push_back(frame.to_world(p));
      }
      convex_hull(corners, hull);
      return !zone.area.is_free(hull, body.grown + more);
    });
  };
  for (const ZoneRules::SpeedLimit& zone : zones) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      double& at = limits.samples[i];
      if (zone.speed < at && touches(samples[i].pose(), samples[i].pose(), zone)) at = zone.speed;
      if (i == 0) continue;
      double& step = limits.steps[i - 1];
      if (zone.speed < step && touches(samples[i - 1].pose(), samples[i].pose(), zone)) step = zone.speed;
    }
  }
  return limits;
}

const ZoneRules::SpeedLimit* slowest_zone_at(const Problem& problem, const Pose& pose) {
  const ZoneRules::SpeedLimit* slowest = nullptr;
  const double radius = problem.footprint().radius();
  for (const ZoneRules::SpeedLimit& zone : problem.zones().limits()) {
    if (slowest != nullptr && slowest->speed <= zone.speed) continue;
    if (!meet(Box{pose.position(), pose.position()}, zone.box, radius)) continue;
    if (!zone.area.is_free(problem.footprint(), pose, 0.0)) slowest = &zone;
  }
  return slowest;
}

}  // namespace waywright
