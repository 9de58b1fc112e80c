#include "waywright/planner/rest_of_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Turns on the spot at the beginning of the rest, of which `done` rad are over: what is left of them, something at least. @pre the rest begins with them
void cut_turns(double done, RestOfPlan& rest) {
  Pieces& pieces = rest.path.pieces;
  while (auto* turn = std::get_if<Turn>(&pieces.front().curve)) {
    const double left = std::abs(turn->angle) - done;
    const bool is_over = !(left > least_turn);
    if (is_over && pieces.size() > 1) {
      done = std::max(0.0, -left);
      pieces.erase(pieces.begin());
      continue;
    }
    const double by = std::copysign(is_over ? std::abs(turn->angle) - least_turn : done, turn->angle);
    turn->from = wrap(turn->from + by);
    turn->angle -= by;
    break;
  }
  rest.pose = start_pose(rest.path);
}

/// rad/s that the vehicle turns by at most at a time: as its samples do around it, and no faster than it can slow down from in what is left.
double turning_at(const std::vector<Sample>& samples, double t, double slows_down_by, double left) {
  const auto after = std::upper_bound(samples.begin(), samples.end(), t, [](double time, const Sample& s) { return time < s.t; });
  if (after == samples.begin() || after == samples.end()) return 0.0;
  const Sample &a = *(after - 1), &b = *after;
  const double time = b.t - a.t, turn = std::abs(shorter_turn(a.heading, b.heading));
  if (!(turn > 0.0) || !(time > 0.0)) return 0.0;
  return std::min(turn / time + 0.5 * slows_down_by * time, std::sqrt(2.0 * slows_down_by * left));
}

/// The beginning of the turns of one sense that a path begins with, by `angle` rad at least (all of them, if they are less).
Path first_turns(const Path& path, double angle) {
  Path first;
  for (const Piece& piece : path.pieces) {
    const auto* turn = std::get_if<Turn>(&piece.curve);
    if (turn == nullptr || !(angle > least_turn)) break;
    if (!first.pieces.empty() && std::get<Turn>(first.pieces.front().curve).angle * turn->angle < 0.0) break;
    first.pieces.push_back(piece);
    auto& cut = std::get<Turn>(first.pieces.back().curve);
    cut.angle = std::copysign(std::min(angle, std::abs(cut.angle)), cut.angle);
    angle -= std::abs(cut.angle);
  }
  return first;
}

double angle_of_turns(const Path& turns) {
  double angle = 0.0;
  for (const Piece& piece : turns.pieces) angle += std::abs(std::get<Turn>(piece.curve).angle);
  return angle;
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
  if (!now.is_turning) return rest;
  cut_turns(now.turned, rest);
  const double slows_down_by = problem.vehicle().limits.angular_acceleration.value_or(default_angular_acceleration);
  rest.turning = turning_at(plan.samples, t, slows_down_by, angle_of_turns(first_turns(rest.path, std::numeric_limits<double>::infinity())));
  rest.stopping = first_turns(rest.path, 0.5 * rest.turning * rest.turning / slows_down_by);
  return rest;
}

double time_at(const std::vector<Sample>& samples, double s) {
  const auto after = std::lower_bound(samples.begin(), samples.end(), s, [](const Sample& a, double value) { return a.s < value; });
  if (after == samples.begin()) return samples.front().t;
  if (after == samples.end()) return samples.back().t;
  const Sample &a = *(after - 1), &b = *after;
  // Where it is then is what within_step has; its inverse by halving the time.
  double low = 0.0, high = b.t - a.t;
  for (int i = 0; i < 60 && high > low; ++i) {
    const double middle = 0.5 * (low + high);
    (within_step(a, b, middle).way < s - a.s ? low : high) = middle;
  }
  return std::min(b.t, a.t + high);
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
