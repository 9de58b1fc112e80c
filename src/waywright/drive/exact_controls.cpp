#include <algorithm>
#include <cmath>

#include "waywright/drive/controls.hpp"
#include "waywright/drive/plan_motion.hpp"

namespace waywright {

namespace {

/// s, that the steered wheel needs for what it turns by in a stretch.
double time_to_steer(const PlanMotion& motion, const Stretch& stretch, const Tricycle* tricycle) {
  if (tricycle == nullptr || !tricycle->max_steering_rate) return 0.0;
  return std::abs(motion.at(stretch, stretch.duration).steering - motion.at(stretch, 0.0).steering) / *tricycle->max_steering_rate;
}

}  // namespace

EndError end_error(const Pose& end, const Pose& wanted) { return {distance(end.position(), wanted.position()), std::abs(shorter_turn(end.heading, wanted.heading))}; }

std::vector<WheelColumn> wheel_columns(const Drive& drive) {
  if (std::holds_alternative<Tricycle>(drive)) return {{"steering", "rad"}, {"wheel", "m/s"}};
  if (std::holds_alternative<Differential>(drive)) return {{"right", "m/s"}, {"left", "m/s"}};
  return {{"front_left", "rad/s"}, {"front_right", "rad/s"}, {"rear_left", "rad/s"}, {"rear_right", "rad/s"}};
}

std::array<double, 4> wheel_values(const Drive& drive, const ControlRow& row) {
  const Twist& twist = row.twist;
  if (const auto* tricycle = std::get_if<Tricycle>(&drive)) {
    const SteeredWheel wheel = wheel_of(*tricycle, twist.forward, twist.turn, row.steering);
    return {wheel.angle, wheel.speed, 0.0, 0.0};
  }
  if (const auto* differential = std::get_if<Differential>(&drive)) {
    const DifferentialWheels wheels = wheels_of(*differential, twist.forward, twist.turn);
    return {wheels.right, wheels.left, 0.0, 0.0};
  }
  const MecanumWheels wheels = wheels_of(std::get<Mecanum>(drive), twist);
  return {wheels.front_left, wheels.front_right, wheels.rear_left, wheels.rear_right};
}

ExactControls exact_controls(const Plan& plan, double period) {
  ExactControls controls;
  controls.period = period;
  if (plan.samples.size() < 2) return controls;
  const Vehicle& vehicle = plan.scenario.vehicle;
  const auto* tricycle = std::get_if<Tricycle>(&vehicle.drive);
  const bool any_way = std::holds_alternative<Mecanum>(vehicle.drive);
  const PlanMotion motion{plan.path, plan.samples, vehicle};
  controls.plan_time = plan.samples.back().t;
  Pose pose = plan.samples.front().pose(), midpoint = pose;
  std::size_t periods = 0;
  double planned = 0.0;  // s, when the plan has the stretch begin
  double steering = 0.0;
  for (const Stretch& stretch : motion.stretches()) {
    if (!controls.rows.empty()) ++controls.stands;
    // What stands before were rounded up by is taken off a wait, as far as the steered wheel has time to turn: waits end when the plan has them end, or less than a period later.
    double duration = stretch.duration;
    if (stretch.kind == Stretch::Kind::wait) {
      const double late = static_cast<double>(periods) * period - planned;
      duration = std::max(duration - late, std::min(duration, time_to_steer(motion, stretch, tricycle)));
    }
    planned += stretch.duration;
    // A multiple of the period but for rounding is that.
    const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(duration / period - 1e-9)));
    controls.stretches.push_back({controls.rows.size(), stretch.first});
    Moment from = motion.at(stretch, 0.0);
    for (std::size_t k = 0; k < count; ++k) {
      const double share = static_cast<double>(k + 1) / static_cast<double>(count);
      const double time = stretch.kind == Stretch::Kind::wait ? share * stretch.duration : static_cast<double>(k + 1) * period;
      const Moment to = motion.at(stretch, k + 1 == count ? stretch.duration : time);
      const double way = stretch.direction * (to.s - from.s), turn = to.heading - from.heading;
      ControlRow row{static_cast<double>(periods++) * period, {way / period, 0.0, turn / period}, from.steering, pose};
      if (any_way && stretch.kind == Stretch::Kind::drive) {
        row.twist = twist_between(from.pose, to.pose, period);
        pose = midpoint = arc_step(pose, row.twist, period);
      } else {
        pose = arc_step(pose, way, turn);
        midpoint = midpoint_step(midpoint, way, turn);
      }
      if (tricycle != nullptr) {
        row.steering = stretch.kind == Stretch::Kind::wait ? to.steering : wheel_of(*tricycle, row.twist.forward, row.twist.turn, from.steering).angle;
      }
      steering = to.steering;
      controls.deviation = std::max(controls.deviation, distance(pose.position(), to.pose.position()));
      controls.rows.push_back(row);
      from = to;
    }
  }
  controls.rows.push_back({static_cast<double>(periods) * period, {}, steering, pose});
  const Pose end = plan.samples.back().pose();
  controls.end = end_error(pose, end);
  controls.midpoint_end = end_error(midpoint, end);
  return controls;
}

}  // namespace waywright
