#include "waywright/drive/drive_model.hpp"

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

constexpr double standing_share = 0.02;  // of the greatest speed
constexpr double creeping = 0.01;        // m/s, under which a vehicle with two driven wheels is taken to turn on the spot

double towards(double from, double to, double most) { return std::abs(to - from) <= most ? to : from + std::copysign(most, to - from); }

}  // namespace

DriveModel::DriveModel(const Vehicle& vehicle, double turn_speed)
    : limits_{vehicle.limits},
      on_the_spot_{vehicle.can_turn_on_the_spot()},
      has_wheel_{std::holds_alternative<Tricycle>(vehicle.drive)},
      most_turn_{limits_.angular_speed.value_or(turn_speed)},
      most_curvature_{vehicle.max_curvature()} {
  if (has_wheel_) wheel_ = std::get<Tricycle>(vehicle.drive);
  if (!on_the_spot_) most_turn_ = std::min(most_turn_, most_curvature_ * std::max(limits_.speed, limits_.reverse_speed));
}

double DriveModel::ramped_speed(double from, double to, double time) const {
  const bool turns_back = from * to < 0.0;
  if (turns_back) to = 0.0;
  return towards(from, to, (std::abs(to) > std::abs(from) ? limits_.acceleration : limits_.deceleration) * time);
}

/// The curvature, between the one it has and the one it is told, that the steered wheel and the way driven allow.
double DriveModel::steered(const DriveState& state, double curvature, double way, double time) const {
  if (has_wheel_ && wheel_.max_steering_rate) {
    const double from = arc_tangent(wheel_.wheelbase * state.curvature, 1.0), to = arc_tangent(wheel_.wheelbase * curvature, 1.0);
    const double angle = towards(from, to, *wheel_.max_steering_rate * time);
    if (angle != to) {
      const SinCos a = sin_cos(angle);
      curvature = a.sin / (a.cos * wheel_.wheelbase);
    }
  }
  if (limits_.curvature_rate) curvature = towards(state.curvature, curvature, *limits_.curvature_rate * way);
  return curvature;
}

double DriveModel::top_speed(double curvature) const {
  const double bend = std::max(1e-12, std::abs(curvature));
  const double top = most_turn_ / bend;
  return limits_.lateral_acceleration ? std::min(top, std::sqrt(*limits_.lateral_acceleration / bend)) : top;
}

DriveStep DriveModel::move(DriveState& state, double v, double turn, double time) const {
  const DriveStep step{0.5 * (state.v + v), 0.5 * (state.turn + turn)};
  state.pose = arc_step(state.pose, step.v * time, step.turn * time);
  state.v = v;
  state.turn = turn;
  return step;
}

DriveStep DriveModel::advance(DriveState& state, double v, double turn, double time) const {
  v = std::clamp(v, -limits_.reverse_speed, limits_.speed);
  turn = std::clamp(turn, -most_turn_, most_turn_);
  if (std::abs(v) < standing_share * most_speed(v < 0.0 ? -1 : 1)) v = 0.0;
  return on_the_spot_ ? turned(state, v, turn, time) : bent(state, v, turn, time);
}

/// Of two driven wheels. What the limits hold for is the greater of both ends of the step, so that they hold for its mean too. Where the turning cannot fall as fast as
/// the speed should change, the speed waits for it: each is kept between where it was and where it should be, where the limits held.
DriveStep DriveModel::turned(DriveState& state, double v, double turn, double time) const {
  const bool bends = limits_.lateral_acceleration.has_value();
  const double bend = limits_.lateral_acceleration.value_or(0.0);
  if (bends && std::abs(v * turn) > bend) v = std::copysign(bend / std::abs(turn), v);
  double speed = ramped_speed(state.v, v, time);
  const double faster = std::max(std::abs(state.v), std::abs(speed));
  if (bends && faster * std::abs(turn) > bend) turn = std::copysign(bend / faster, turn);
  const bool drives = std::abs(state.v) > creeping || std::abs(speed) > creeping;
  if (const double most = most_curvature_ * std::max(creeping, std::abs(speed)); drives) turn = std::clamp(turn, -most, most);
  const double most = limits_.angular_acceleration ? *limits_.angular_acceleration * time : std::numeric_limits<double>::infinity();
  const double turning = towards(state.turn, turn, most);
  const double more = std::max(std::abs(state.turn), std::abs(turning));
  if (bends && std::abs(speed) > std::abs(state.v) && std::abs(speed) * more > bend) speed = std::copysign(std::max(std::abs(state.v), bend / more), speed);
  if (drives && std::abs(turning) > most_curvature_ * std::max(creeping, std::abs(speed))) {
    // From a turn on the spot it has to turn less first, braking it may brake no faster than it stops turning.
    speed = std::abs(state.v) > creeping ? std::copysign(std::min(std::abs(state.v), std::abs(turning) / most_curvature_), state.v) : std::copysign(creeping, speed);
  }
  return move(state, speed, turning, time);
}

/// Of a steered wheel. The speed first, by what both curvatures of the step allow, then as much curvature as the speed that is driven allows.
DriveStep DriveModel::bent(DriveState& state, double v, double turn, double time) const {
  double curvature = state.curvature;
  if (v != 0.0) {
    const double wanted = std::clamp(turn / v, -most_curvature_, most_curvature_);
    const auto way = [&](double speed) { return 0.5 * std::abs(state.v + speed) * time; };
    const double reached = steered(state, wanted, way(ramped_speed(state.v, v, time)), time);
    const double top = std::min(top_speed(state.curvature), top_speed(reached));
    v = std::clamp(v, -top, top);
    const double speed = ramped_speed(state.v, v, time), faster = std::max({std::abs(state.v), std::abs(speed), 1e-12});
    double most = most_turn_ / faster;
    if (limits_.lateral_acceleration) most = std::min(most, *limits_.lateral_acceleration / (faster * faster));
    most = std::max(most, std::abs(state.curvature));  // but for rounding it is
    curvature = std::clamp(steered(state, wanted, way(speed), time), -most, most);
  }
  const double speed = ramped_speed(state.v, v, time);
  const DriveStep step = move(state, speed, curvature * speed, time);
  state.curvature = curvature;
  return step;
}

DriveStep DriveModel::brake(DriveState& state, double time) const {
  if (on_the_spot_) return turned(state, 0.0, 0.0, time);
  const double speed = ramped_speed(state.v, 0.0, time);
  return move(state, speed, state.curvature * speed, time);
}

}  // namespace waywright
