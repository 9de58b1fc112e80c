#include "waywright/planner/field/free_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double any = std::numeric_limits<double>::infinity();
constexpr double least_speed = 0.02;      // m/s: who is wanted to be slower stands
constexpr double straight_under = 2e-3;   // rad, that a course may be off
constexpr double turns_over = 0.4;        // rad, from which on a vehicle that stands turns before it drives
constexpr double brakes_over = 1.4;       // rad, from which on one that drives stops before it turns
constexpr double steers_within = 0.25;    // s
constexpr double smooth_within = 0.5;     // s, of one whose curvature cannot jump
constexpr double smooth_over = 0.15;      // m, at least: right after rest its steps are millimetres, and would be bent as sharply
constexpr double changes_over = 0.05;     // m, at least, that a change of its curvature is spread over
constexpr double share_of_steering = 0.6; // of the angular acceleration; the rest is for speeding up and braking
constexpr double tightest = 10.0;         // 1/m, that a way is bent while it is driven, also by vehicles without a limit
constexpr double default_angular = 1.0;   // rad/s and rad/s², of turns on the spot, as the speed profile has it

}  // namespace

FreeMotion::FreeMotion(const Problem& problem, double turn, double least) {
  const Vehicle& vehicle = problem.vehicle();
  const Limits& limits = vehicle.limits;
  any_way_ = vehicle.moves_any_way();
  is_smooth_ = !any_way_ && vehicle.stands_at_curvature_jumps();
  speed_ = limits.speed;
  acceleration_ = limits.acceleration;
  deceleration_ = limits.deceleration;
  lateral_ = limits.lateral_acceleration.value_or(limits.acceleration);
  angular_ = limits.angular_speed.value_or(any);
  angular_acceleration_ = limits.angular_acceleration.value_or(any);
  curvature_ = vehicle.max_curvature();
  curvature_rate_ = limits.curvature_rate.value_or(any);
  if (any_way_) {
    const double rate = least > 0.0 ? std::abs(turn) / least : 0.0;
    if (rate > 0.0) {
      speed_ = std::min(speed_, angular_ / rate);
      acceleration_ = std::min(acceleration_, angular_acceleration_ / rate);
      deceleration_ = std::min(deceleration_, angular_acceleration_ / rate);
    }
    // The wheels' greatest speed, whichever way it goes: slowest askew, at an eighth of a turn.
    if (const auto* mecanum = std::get_if<Mecanum>(&vehicle.drive)) speed_ = std::min(speed_, mecanum->max_speed(0.25 * pi, 0.0, rate));
    if (limits.reverse_speed < limits.speed) speed_ = std::min(speed_, std::max(limits.reverse_speed, 0.0));  // whichever way it looks
    angular_ = angular_acceleration_ = any;  // courses are no headings
  }
}

double FreeMotion::turning_time(double angle) const {
  const double speed = std::isfinite(angular_) ? angular_ : default_angular, acceleration = std::isfinite(angular_acceleration_) ? angular_acceleration_ : default_angular;
  const double ramps = speed * speed / acceleration;
  return angle <= ramps ? 2.0 * std::sqrt(angle / acceleration) : 2.0 * speed / acceleration + (angle - ramps) / speed;
}

Curve FreeMotion::curve(const FreeState& from, const FreeStep& step) const {
  const Pose start = make_pose(from.at, step.begins);
  if (step.curvature_rate != 0.0) return Clothoid{start, step.curvature, step.curvature_rate, step.length};
  if (step.curvature != 0.0) return Arc{start, step.curvature, step.length};
  return Line{from.at, from.at + step.length * unit(step.begins)};
}

void FreeMotion::finish(const FreeState& from, FreeStep& step, double speed, double period, bool exact) const {
  FreeState& after = step.after;
  const double turned = (step.curvature + 0.5 * step.curvature_rate * step.length) * step.length;
  after.course = wrap(step.begins + turned);
  after.curvature = step.curvature + step.curvature_rate * step.length;
  after.speed = speed;
  after.t = from.t + period;
  if (!(step.length > 0.0)) after.at = from.at;
  else if (exact) after.at = end_pose(Piece{curve(from, step), 1, {}}).position();
  else after.at = from.at + step.length * unit(step.begins + 0.5 * turned);
}

FreeStep FreeMotion::turn(const FreeState& from, double angle) const {
  FreeStep step;
  step.kind = FreeStep::Kind::turn;
  step.begins = from.course;
  step.turn = angle;
  step.after = from;
  step.after.course = wrap(from.course + angle);
  step.after.curvature = 0.0;
  step.after.t = from.t + turning_time(std::abs(angle));
  return step;
}

FreeStep FreeMotion::towards(const FreeState& from, Vec2 wanted, double top, double period, bool exact) const {
  FreeStep step;
  step.begins = from.course;
  double goal = std::min({norm(wanted), top, speed_});
  double off = goal > 0.0 ? shorter_turn(from.course, angle_of(wanted)) : 0.0;
  const bool stood = from.speed <= 0.0;
  if (stood) {
    if (goal < least_speed) {
      step.after = from;
      step.after.curvature = 0.0;
      step.after.t = from.t + period;
      return step;
    }
    if (any_way_) {
      step.begins = wrap(from.course + off);
      off = 0.0;
    } else if (std::abs(off) > turns_over) {
      return turn(from, off);
    }
  }
  step.kind = FreeStep::Kind::drive;
  if (std::abs(off) > brakes_over || goal < least_speed) goal = 0.0;
  else goal *= std::max(0.2, sin_cos(off).cos);
  const double curved = stood ? 0.0 : from.curvature;
  double up = acceleration_, down = deceleration_;
  if (is_smooth_ && std::isfinite(angular_acceleration_) && curved != 0.0) {
    const double left = (1.0 - share_of_steering) * angular_acceleration_ / std::abs(curved);
    up = std::min(up, left);
    down = std::min(down, left);
  }
  double speed = std::clamp(goal, std::max(0.0, from.speed - down * period), from.speed + up * period);
  if (is_smooth_ && curved != 0.0) speed = std::max(std::min({speed, std::sqrt(lateral_ / std::abs(curved)), angular_ / std::abs(curved)}), std::max(0.0, from.speed - down * period));
  step.length = 0.5 * (from.speed + speed) * period;
  const double fastest = std::max(from.speed, speed);
  if (!(step.length > 0.0)) {
    step.kind = FreeStep::Kind::stand;
    step.after = from;
    step.after.speed = 0.0;
    step.after.t = from.t + period;
    return step;
  }
  const double most = std::min({tightest, curvature_, lateral_ / (fastest * fastest), angular_ / fastest});
  if (std::abs(off) < straight_under || goal == 0.0) off = 0.0;
  const double mean = step.length / period;
  if (!is_smooth_) {
    step.curvature = std::clamp(off / (mean * std::max(steers_within, period)), -most, most);
  } else {
    // As fast a turning as can be unwound within what is left of the turn.
    const double turning = share_of_steering * angular_acceleration_;
    double wish = off / std::max(mean * smooth_within, smooth_over);
    if (std::isfinite(turning)) wish = std::clamp(wish, -0.7 * std::sqrt(2.0 * turning * std::abs(off)) / std::max(mean, 0.05), 0.7 * std::sqrt(2.0 * turning * std::abs(off)) / std::max(mean, 0.05));
    wish = std::clamp(wish, -most, most);
    const double rate = std::min({curvature_rate_, turning / (fastest * fastest), std::abs(wish - curved) / changes_over});
    const double change = std::clamp(wish - curved, -rate * step.length, rate * step.length);
    step.curvature = curved;
    step.curvature_rate = std::abs(change) > 1e-9 ? change / step.length : 0.0;
  }
  finish(from, step, speed, period, exact);
  return step;
}

FreeStep FreeMotion::onto(const FreeState& from, Vec2 goal, double top, double period) const {
  FreeStep step;
  step.after = from;
  const double away = distance(from.at, goal);
  const double off = shorter_turn(from.course, angle_of(goal - from.at));
  const bool stood = from.speed <= 0.0;
  if (std::abs(off) > 0.5 && !stood) return step;
  if (is_smooth_ && !stood && (std::abs(off) > 1e-7 || from.curvature != 0.0)) return step;
  if (stood && !any_way_ && std::abs(off) > 1e-7) {
    return turn(from, off);
  }
  step.begins = from.course;
  double bend = 0.0, left = away;
  if (stood) step.begins = angle_of(goal - from.at);
  else if (std::abs(off) > 1e-7) {
    bend = 2.0 * sin_cos(off).sin / away;
    left = off / sin_cos(off).sin * away;
  }
  // As fast as still comes to rest there.
  const double room = deceleration_ * period;
  const double brake = std::max(0.0, std::sqrt(0.25 * room * room + std::max(0.0, 2.0 * deceleration_ * left - room * from.speed)) - 0.5 * room);
  double speed = std::clamp(std::min({top, speed_, brake}), std::max(0.0, from.speed - deceleration_ * period), from.speed + acceleration_ * period);
  double time = period;
  step.length = 0.5 * (from.speed + speed) * period;
  if (step.length >= left || (from.speed > 0.0 && braking(from.speed) >= left - 0.5 * from.speed * period) || left < 1e-3) {
    // To its end, evenly.
    step.length = left;
    if (from.speed > 0.0) {
      if (braking(from.speed) > left * (1.0 + 1e-6)) {
        step.kind = FreeStep::Kind::stand;
        return step;
      }
      speed = 0.0;
      time = 2.0 * left / from.speed;
    } else {
      const double peak = std::sqrt(2.0 * left * acceleration_ * deceleration_ / (acceleration_ + deceleration_));
      speed = 0.0;
      time = peak / acceleration_ + peak / deceleration_;
    }
  }
  const double fastest = std::max(from.speed, speed);
  if (std::abs(bend) > std::min({curvature_, lateral_ / (fastest * fastest), angular_ / fastest})) return FreeStep{.after = from};
  step.kind = FreeStep::Kind::drive;
  step.curvature = bend;
  step.curvature_rate = 0.0;
  finish(from, step, speed, time, true);
  if (step.length == left) {
    step.after.at = goal;
    step.after.curvature = 0.0;
  }
  return step;
}

}  // namespace waywright
