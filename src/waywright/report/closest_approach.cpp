#include "waywright/report/closest_approach.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/proof/moving_clearance.hpp"
#include "waywright/report/scene_parts.hpp"

namespace waywright {
namespace {

constexpr double finest = 0.01;   // s
constexpr double most = 100'000.0;  // times, of all movers

/// m/s that no point of the footprint is faster than between any two samples.
double fastest_of(const std::vector<Sample>& samples, double radius) {
  double fastest = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Sample &a = samples[i - 1], &b = samples[i];
    if (!(b.t > a.t)) continue;
    const double way = distance(a.pose().position(), b.pose().position()) + radius * std::abs(wrap(b.heading - a.heading));
    fastest = std::max(fastest, way / (b.t - a.t));
  }
  return fastest;
}

/// Of two outlines that do not touch, the points nearest to each other; of those that do, one of both.
std::pair<Vec2, Vec2> nearest_points(const Ring& a, const Ring& b) {
  std::pair<Vec2, Vec2> best{a.front(), b.front()};
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](const Ring& corners, const Ring& area, bool is_other_way) {
    for (const Vec2 corner : corners) {
      const Vec2 near = nearest_in(area, corner);
      if (distance(corner, near) >= least) continue;
      least = distance(corner, near);
      best = is_other_way ? std::pair{near, corner} : std::pair{corner, near};
    }
  };
  look(a, b, false);
  look(b, a, true);
  return best;
}

}  // namespace

Pose pose_at(const std::vector<Sample>& samples, double t) {
  const auto after = std::upper_bound(samples.begin(), samples.end(), t, [](double at, const Sample& s) { return at < s.t; });
  if (after == samples.begin()) return samples.front().pose();
  if (after == samples.end()) return samples.back().pose();
  const Sample &a = *(after - 1), &b = *after;
  const double share = b.t > a.t ? (t - a.t) / (b.t - a.t) : 0.0;
  return make_pose(a.pose().position() + share * (b.pose().position() - a.pose().position()), a.heading + share * wrap(b.heading - a.heading));
}

std::vector<ClosestApproach> closest_approaches(const Problem& problem, const std::vector<Sample>& samples) {
  const std::vector<MovingObstacle>& moving = problem.scenario().moving;
  std::vector<ClosestApproach> all;
  if (samples.empty() || moving.empty()) return all;
  const MovingClearance clearance{problem, 0.0, 0.0};
  const double end = samples.back().t, step = std::max(finest, end * static_cast<double>(moving.size()) / most), own = fastest_of(samples, problem.footprint().radius());
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const double speed = own + MovingPlaces{moving[i]}.fastest();
    ClosestApproach closest{i, 0.0, closest_cap, {}, {}, {}, {}};
    for (double t = 0.0;; ) {
      const double d = clearance.distance_at(pose_at(samples, t), i, t, closest_cap);
      if (d < closest.distance) closest.t = t, closest.distance = d;
      if (t >= end || closest.distance <= 0.0) break;
      // Not before it has gone the way that is between can it be nearer than it has been.
      t = std::min(end, t + std::max(step, speed > 0.0 ? (d - closest.distance) / speed : end));
    }
    closest.vehicle = pose_at(samples, closest.t);
    closest.other = moving[i].at(closest.t);
    std::tie(closest.on_vehicle, closest.on_other) = nearest_points(outline_at(problem.footprint(), closest.vehicle), outline_at(moving[i].footprint, closest.other));
    all.push_back(closest);
  }
  std::stable_sort(all.begin(), all.end(), [](const ClosestApproach& a, const ClosestApproach& b) { return a.distance < b.distance; });
  return all;
}

}  // namespace waywright
