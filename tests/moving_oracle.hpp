// Slow and plain: where vehicle and obstacles of a plan are at single times, and how far apart. Shares nothing with what it is an oracle for but plain data.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/oracle/brute_force.hpp"
#include "waywright/judge/plan.hpp"

namespace waywright::oracle {

struct Driven {
  Pose pose{};
  double s = 0.0;
  bool moves = false;
};

/// By the plan's own samples: evenly accelerated on each step; on the spot evenly in time.
inline Driven driven_at(const std::vector<Sample>& samples, double t) {
  const auto after = std::upper_bound(samples.begin(), samples.end(), t, [](double time, const Sample& s) { return time < s.t; });
  if (after == samples.end()) return {samples.back().pose(), samples.back().s, false};
  const Sample &a = *(after - 1), &b = *after;
  const double time = t - a.t, way = b.s - a.s, sum = a.speed + b.speed;
  double share = b.t > a.t ? time / (b.t - a.t) : 0.0;
  if (way > 0.0 && sum > 0.0) {
    const double acceleration = 0.5 * (b.speed - a.speed) * sum / way;
    share = std::clamp((a.speed * time + 0.5 * acceleration * time * time) / way, 0.0, 1.0);
  }
  double turn = std::remainder(b.heading - a.heading, 2.0 * 3.14159265358979323846);
  return {{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.heading + share * turn}, a.s + share * way, !(a.x == b.x && a.y == b.y && a.heading == b.heading)};
}

inline Pose obstacle_at(const MovingObstacle& obstacle, double t) {
  const auto& track = obstacle.track;
  if (t <= track.front().t) return track.front().pose;
  for (std::size_t i = 0; i + 1 < track.size(); ++i) {
    if (t > track[i + 1].t) continue;
    const Pose &a = track[i].pose, &b = track[i + 1].pose;
    const double share = (t - track[i].t) / (track[i + 1].t - track[i].t);
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.heading + share * std::remainder(b.heading - a.heading, 2.0 * 3.14159265358979323846)};
  }
  const Pose& last = track.back().pose;
  return {last.x + (t - track.back().t) * obstacle.velocity.x, last.y + (t - track.back().t) * obstacle.velocity.y, last.heading};
}

inline double between(const Footprint& a, const Pose& at, const Footprint& b, const Pose& there) {
  const Body x = place(a, at.x, at.y, at.heading), y = place(b, there.x, there.y, there.heading);
  if (gap(x.box, y.box) > 5.0) return gap(x.box, y.box);
  const double distance = y.disc ? x.distance_to(y.centre) - y.radius : x.distance_to(y.area);
  return std::max(0.0, distance);
}

/// Least distance of the vehicle to any moving obstacle, every `step` seconds of the plan; of `spread` nothing is known here.
inline double least_in_time(const Plan& plan, const Footprint& footprint, double step) {
  double least = std::numeric_limits<double>::infinity();
  for (double t = 0.0; t <= plan.samples.back().t; t += step) {
    const Driven driven = driven_at(plan.samples, t);
    for (const MovingObstacle& obstacle : plan.scenario.moving) least = std::min(least, between(footprint, driven.pose, obstacle.footprint, obstacle_at(obstacle, t)));
  }
  return least;
}

}  // namespace waywright::oracle
