#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/drive/plan_motion.hpp"
#include "waywright/drive/whale_controls.hpp"
#include "waywright/speed/zone_speed.hpp"

namespace waywright {

std::vector<ControlWaypoint> control_waypoints(const Problem& problem, const Plan& plan, double spacing) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<ControlWaypoint> waypoints;
  const std::vector<Sample>& samples = plan.samples;
  if (samples.size() < 2) return waypoints;
  const PathPlaces places{plan.path};
  const LimitsAlong zones = zone_limits(problem, samples, plan.certificate.tolerance);
  const auto top_between = [&](double from, double to) {
    double top = infinity;
    for (std::size_t i = 0; i < zones.steps.size() && i + 1 < samples.size(); ++i) {
      if (samples[i + 1].s >= from && samples[i].s <= to) top = std::min(top, zones.steps[i]);
    }
    return top;
  };
  // Of the plan, between samples by straight interpolation: these are guesses and wishes.
  const auto share_at = [&](double s, auto value) {
    const auto after = std::upper_bound(samples.begin() + 1, samples.end() - 1, s, [](double at, const Sample& sample) { return at < sample.s; });
    const Sample& a = *std::prev(after);
    const double way = after->s - a.s;
    return way > 0.0 ? value(a) + (value(*after) - value(a)) * std::clamp((s - a.s) / way, 0.0, 1.0) : value(a);
  };
  // Stretches of one direction between turns, by samples.
  for (std::size_t i = 0; i + 1 < samples.size();) {
    const auto moves = [&](std::size_t k) { return samples[k + 1].s - samples[k].s > 1e-9; };
    const auto turns = [&](std::size_t k) { return !moves(k) && std::abs(shorter_turn(samples[k].heading, samples[k + 1].heading)) > 1e-4; };
    if (!moves(i)) {
      if (turns(i)) {
        if (waypoints.empty()) waypoints.push_back({samples[i].pose(), 0, true, infinity});
        ControlWaypoint& at = waypoints.back();
        at.pose.heading = samples[i + 1].heading;
        at.speed = at.turn_rate = 0.0;
        at.turn += shorter_turn(samples[i].heading, samples[i + 1].heading);
        at.turn_time += samples[i + 1].t - samples[i].t;
      }
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    const int direction = samples[end].direction;
    const auto stands = [&](std::size_t k) { return !moves(k) && must_stand(samples[k], samples[k + 1], problem.vehicle()); };
    while (end + 1 < samples.size() && !turns(end) && !stands(end) && (!moves(end) || samples[end + 1].direction == direction)) ++end;
    const double begin = samples[i].s, length = samples[end].s - begin;
    const double parts = std::max(1.0, std::ceil(length / spacing - 1e-9));
    double last_heading = samples[i].heading, last_time = samples[i].t;
    for (double part = 1.0; part <= parts; ++part) {
      const double s = part == parts ? samples[end].s : begin + length * part / parts;
      const Pose pose = part == parts ? samples[end].pose() : places.at(s).pose;
      waypoints.push_back({pose, direction, false, top_between(begin + length * (part - 1.0) / parts, s)});
      ControlWaypoint& at = waypoints.back();
      const double time = part == parts ? samples[end].t : share_at(s, [](const Sample& sample) { return sample.t; });
      at.speed = part == parts ? samples[end].speed : share_at(s, [](const Sample& sample) { return sample.speed; });
      at.turn_rate = at.speed * (part == parts ? samples[end].curvature : places.at(s).curvature);
      at.way = direction * length / parts;
      at.bend = shorter_turn(last_heading, pose.heading);
      at.way_time = time - last_time;
      last_heading = pose.heading;
      last_time = time;
      // Turns on the spot may be part of the way to their waypoint; what follows after another stand waits for it.
      at.is_stand = part == parts && end + 1 < samples.size() && stands(end) && !turns(end) && samples[end + 1].direction != 0;
    }
    i = end;
  }
  if (!waypoints.empty()) waypoints.back().is_stand = true;
  return waypoints;
}

}  // namespace waywright
