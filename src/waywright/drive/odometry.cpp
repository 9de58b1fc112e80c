#include "waywright/drive/odometry.hpp"

#include <cmath>

#include "waywright/curve/arc.hpp"

namespace waywright {

Pose midpoint_step(const Pose& pose, double distance, double turn) {
  return make_pose(pose.position() + distance * unit(pose.heading + 0.5 * turn), wrap(pose.heading + turn));
}

Pose arc_step(const Pose& pose, double distance, double turn) { return midpoint_step(pose, distance * sinc(0.5 * turn), turn); }

Pose arc_step(const Pose& pose, const Twist& twist, double time) {
  const double turn = twist.turn * time;
  const Vec2 ahead = unit(pose.heading + 0.5 * turn);
  const double along = time * sinc(0.5 * turn);
  return make_pose(pose.position() + (along * twist.forward) * ahead + (along * twist.left) * left_of(ahead), wrap(pose.heading + turn));
}

Twist twist_between(const Pose& from, const Pose& to, double time) {
  const double turn = shorter_turn(from.heading, to.heading);
  const Vec2 ahead = unit(from.heading + 0.5 * turn);
  const Vec2 way = to.position() - from.position();
  const double share = 1.0 / (time * sinc(0.5 * turn));  // the turn is at most π: sinc is at least 2/π
  return {share * dot(way, ahead), share * cross(ahead, way), turn / time};
}

DifferentialWheels wheels_of(const Differential& drive, double v, double turn) { return {v + 0.5 * drive.track * turn, v - 0.5 * drive.track * turn}; }

Twist twist_of(const Differential& drive, const DifferentialWheels& wheels) {
  return {0.5 * (wheels.right + wheels.left), 0.0, (wheels.right - wheels.left) / drive.track};
}

SteeredWheel wheel_of(const Tricycle& drive, double v, double turn, double standing) {
  // The steered wheel's centre moves by (v, ±wheelbase · turn): before the fixed axle to the left of it, behind it to the right.
  const double across = (drive.steered_axle == SteeredAxle::rear ? -1.0 : 1.0) * drive.wheelbase * turn;
  if (v == 0.0 && across == 0.0) return {standing, 0.0};
  const double way = v < 0.0 ? -1.0 : 1.0;  // backwards the wheel rolls back, it is not turned round
  return {arc_tangent(way * across, way * v), way * std::sqrt(v * v + across * across)};
}

Twist twist_of(const Tricycle& drive, const SteeredWheel& wheel) {
  const SinCos a = sin_cos(wheel.angle);
  const double across = wheel.speed * a.sin;
  return {wheel.speed * a.cos, 0.0, (drive.steered_axle == SteeredAxle::rear ? -across : across) / drive.wheelbase};
}

MecanumWheels wheels_of(const Mecanum& drive, const Twist& twist) {
  const double turning = (drive.half_length + drive.half_width) * twist.turn;
  const double r = drive.wheel_radius;
  return {(twist.forward - twist.left - turning) / r, (twist.forward + twist.left + turning) / r, (twist.forward + twist.left - turning) / r,
          (twist.forward - twist.left + turning) / r};
}

Twist twist_of(const Mecanum& drive, const MecanumWheels& w) {
  const double quarter = 0.25 * drive.wheel_radius;
  return {quarter * (w.front_left + w.front_right + w.rear_left + w.rear_right), quarter * (-w.front_left + w.front_right + w.rear_left - w.rear_right),
          quarter / (drive.half_length + drive.half_width) * (-w.front_left + w.front_right - w.rear_left + w.rear_right)};
}

double slip_residual(const MecanumWheels& w) { return w.front_left + w.front_right - w.rear_left - w.rear_right; }

}  // namespace waywright
