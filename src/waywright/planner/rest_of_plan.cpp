#include "waywright/planner/rest_of_plan.hpp"

#include <algorithm>
#include <cmath>

#include "waywright/map/clearance_along.hpp"
#include "waywright/path/remainder.hpp"
#include "waywright/planner/docking/continuation.hpp"
#include "waywright/proof/collision.hpp"
#include "waywright/speed/speed.hpp"
#include "waywright/speed/zone_speed.hpp"

namespace waywright {
namespace {

constexpr double comparison_slack = 1e-6;  // m, as the proof has it
constexpr double least_turn = 1e-9;        // rad

/// A turn on the spot that has begun: what is left of it. @pre the rest begins with it
void cut_turn(const std::vector<Sample>& samples, double t, RestOfPlan& rest) {
  auto* turn = std::get_if<Turn>(&rest.path.pieces.front().curve);
  if (turn == nullptr) return;
  const auto after = std::upper_bound(samples.begin(), samples.end(), t, [](double time, const Sample& s) { return time < s.t; });
  const Sample &a = *(after - 1), &b = *after;
  const double share = b.t > a.t ? (t - a.t) / (b.t - a.t) : 0.0;
  double done = shorter_turn(turn->from, wrap(a.heading + share * shorter_turn(a.heading, b.heading)));
  if (done * turn->angle < 0.0 && std::abs(done) > least_turn) done += turn->angle < 0.0 ? -two_pi : two_pi;  // of more than half a turn
  if (std::abs(done) >= std::abs(turn->angle) - least_turn) return;
  turn->from = wrap(turn->from + done);
  turn->angle -= done;
  rest.pose.heading = turn->from;
}

}  // namespace

std::optional<RestOfPlan> rest_of(const Plan& plan, const Problem& problem, double t) {
  const Handover now = handover_at(plan.path, plan.samples, t);
  if (problem.pocket()) {
    const double in_shelf = length(problem.pocket_stretch()), whole = length(plan.path);
    const bool is_in = problem.is_driven_back() ? now.driven < in_shelf - 1e-6 : now.driven > whole - in_shelf + 1e-6;
    if (is_in) return std::nullopt;
  }
  RestOfPlan rest{remainder(plan.path, now.driven), now.pose, now.motion, now.driven};
  if (now.is_turning) cut_turn(plan.samples, t, rest);
  return rest;
}

double time_at(const std::vector<Sample>& samples, double s) {
  const auto after = std::lower_bound(samples.begin(), samples.end(), s, [](const Sample& a, double value) { return a.s < value; });
  if (after == samples.begin()) return samples.front().t;
  if (after == samples.end()) return samples.back().t;
  const Sample &a = *(after - 1), &b = *after;
  // Evenly accelerated on a step: v² is linear in s.
  const double way = s - a.s, square = a.speed * a.speed + (b.speed * b.speed - a.speed * a.speed) * way / (b.s - a.s), sum = a.speed + std::sqrt(std::max(0.0, square));
  return sum > 0.0 ? std::min(b.t, a.t + 2.0 * way / sum) : b.t;
}

HeldAgainst held_against(const Map& still, const Problem& problem, const Path& way, const std::atomic<bool>* cancel) {
  World world{still};
  world.build();
  const SweptBody body{problem.footprint()};
  const Motion motion{way};
  SweepMemory memory;
  SweepOptions options;
  options.required = problem.required_clearance();
  options.cancel = cancel;
  const SweptClearance swept = swept_clearance(world, body, motion.intervals(), options, memory);
  HeldAgainst held;
  held.clearance = std::max(0.0, swept.lower - problem.pose_error_margin());
  held.is_free = swept.complete && swept.lower > problem.pose_error_margin() && held.clearance >= problem.scenario().clearance - comparison_slack;
  held.queries = swept.queries;
  return held;
}

Blocked blocked_stretches(const Map& still, const Problem& problem, const std::vector<Sample>& way) {
  World world{still};
  world.build();
  Blocked blocked;
  const double needed = problem.required_clearance() + 2.0 * ProofOptions{}.tolerance;
  ClearanceAlong along{world, problem.footprint(), needed + 1.0};
  bool is_in = false;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const bool is_near = along.at(way[i].pose()) <= needed;
    if (is_near && !is_in) {
      blocked.stretches.push_back({i > 0 ? way[i - 1].s : 0.0, 0.0, way[i].s});
      if (blocked.stretches.size() == 1) {
        blocked.obstacle = world.clearance(problem.footprint(), way[i].pose(), needed + 1.0).source;
        blocked.name = world.source_name(blocked.obstacle);
      }
    }
    if (is_near) blocked.stretches.back().end = way[std::min(i + 1, way.size() - 1)].s;
    is_in = is_near;
  }
  blocked.ends_blocked = is_in;
  return blocked;
}

std::optional<double> braking_distance(const Problem& problem, const std::vector<Sample>& way) {
  const auto& motion = problem.motion();
  if (!motion) return 0.0;
  SpeedWorkspace workspace;
  const LimitsAlong along = zone_limits(problem, way, ProofOptions{}.tolerance);
  const auto stops = [&](std::size_t at) {
    const std::vector<Sample> part{way.begin(), way.begin() + static_cast<std::ptrdiff_t>(at) + 1};
    LimitsAlong limits;
    if (!along.steps.empty()) {
      limits.steps.assign(along.steps.begin(), along.steps.begin() + static_cast<std::ptrdiff_t>(at));
      limits.samples.assign(along.samples.begin(), along.samples.begin() + static_cast<std::ptrdiff_t>(at) + 1);
    }
    return can_start_with(part, problem.vehicle(), motion->speed, workspace, limits);
  };
  std::size_t low = 1, high = way.size() - 1;
  if (way.size() < 2 || !stops(high)) return std::nullopt;
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (stops(middle)) high = middle;
    else low = middle + 1;
  }
  return way[high].s;
}

}  // namespace waywright
