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

double DriveModel::steered(const DriveState& state, double curvature, double v, double time) const {
  curvature = std::clamp(curvature, -most_curvature_, most_curvature_);
  if (has_wheel_ && wheel_.max_steering_rate) {
    const double from = arc_tangent(wheel_.wheelbase * state.curvature, 1.0), to = arc_tangent(wheel_.wheelbase * curvature, 1.0);
    const double angle = towards(from, to, *wheel_.max_steering_rate * time);
    if (angle != to) {
      const SinCos a = sin_cos(angle);
      curvature = a.sin / (a.cos * wheel_.wheelbase);
    }
  }
  if (limits_.curvature_rate) curvature = towards(state.curvature, curvature, *limits_.curvature_rate * std::abs(v) * time);
  return curvature;
}

DriveStep DriveModel::move(DriveState& state, double v, double turn, double time) const {
  const DriveStep step{0.5 * (state.v + v), 0.5 * (state.turn + turn)};
  state.pose = midpoint_step(state.pose, step.v * time, step.turn * time);
  state.v = v;
  state.turn = turn;
  return step;
}

DriveStep DriveModel::advance(DriveState& state, double v, double turn, double time) const {
  v = std::clamp(v, -limits_.reverse_speed, limits_.speed);
  turn = std::clamp(turn, -most_turn_, most_turn_);
  if (std::abs(v) < standing_share * most_speed(v < 0.0 ? -1 : 1)) v = 0.0;
  if (on_the_spot_) {
    if (limits_.lateral_acceleration && std::abs(v * turn) > *limits_.lateral_acceleration) v = std::copysign(*limits_.lateral_acceleration / std::abs(turn), v);
    const double speed = ramped_speed(state.v, v, time);
    if (std::abs(speed) > creeping) turn = std::clamp(turn, -most_curvature_ * std::abs(speed), most_curvature_ * std::abs(speed));
    const double most = limits_.angular_acceleration ? *limits_.angular_acceleration * time : std::numeric_limits<double>::infinity();
    return move(state, speed, towards(state.turn, turn, most), time);
  }
  const double curvature = v == 0.0 ? state.curvature : steered(state, turn / v, 0.5 * (state.v + v), time);
  double top = most_turn_ / std::max(1e-12, std::abs(curvature));
  if (limits_.lateral_acceleration) top = std::min(top, std::sqrt(*limits_.lateral_acceleration / std::max(1e-12, std::abs(curvature))));
  const double speed = ramped_speed(state.v, std::clamp(v, -top, top), time);
  const DriveStep step = move(state, speed, curvature * speed, time);
  state.curvature = curvature;
  return step;
}

DriveStep DriveModel::brake(DriveState& state, double time) const {
  const double speed = ramped_speed(state.v, 0.0, time);
  if (!on_the_spot_) return move(state, speed, state.curvature * speed, time);
  const double most = limits_.angular_acceleration ? *limits_.angular_acceleration * time : std::numeric_limits<double>::infinity();
  return move(state, speed, towards(state.turn, 0.0, most), time);
}

}  // namespace waywright
