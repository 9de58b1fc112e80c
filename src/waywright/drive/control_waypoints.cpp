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
  // Stretches of one direction between turns, by samples.
  for (std::size_t i = 0; i + 1 < samples.size();) {
    const auto moves = [&](std::size_t k) { return samples[k + 1].s - samples[k].s > 1e-9; };
    const auto turns = [&](std::size_t k) { return !moves(k) && std::abs(shorter_turn(samples[k].heading, samples[k + 1].heading)) > 1e-4; };
    if (!moves(i)) {
      if (turns(i)) {
        if (waypoints.empty()) waypoints.push_back({samples[i].pose(), 0, true, infinity});
        waypoints.back().pose.heading = samples[i + 1].heading;
      }
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    const int direction = samples[end].direction;
    while (end + 1 < samples.size() && !turns(end) && (!moves(end) || samples[end + 1].direction == direction)) ++end;
    // What follows goes the other way, or this one again after a turn.
    if (!waypoints.empty() && waypoints.back().direction == -direction) waypoints.back().is_stand = true;
    const double begin = samples[i].s, length = samples[end].s - begin;
    const double parts = std::max(1.0, std::ceil(length / spacing - 1e-9));
    for (double part = 1.0; part <= parts; ++part) {
      const double s = part == parts ? samples[end].s : begin + length * part / parts;
      const Pose pose = part == parts ? samples[end].pose() : places.at(s).pose;
      waypoints.push_back({pose, direction, false, top_between(begin + length * (part - 1.0) / parts, s)});
    }
    i = end;
  }
  if (!waypoints.empty()) waypoints.back().is_stand = true;
  return waypoints;
}

}  // namespace waywright
