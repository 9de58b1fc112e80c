#include "waywright/drive/wheel_torques.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace waywright {
namespace {

constexpr double slowest = 100.0, most_commands = 1e6;

/// The legs' loads, in order, and the first sample of each leg. Of a plan without legs: the one that is carried.
struct Carried {
  std::size_t first_sample = 0;
  std::string load;
};
std::vector<Carried> carried_along(const Plan& plan) {
  if (plan.legs.empty()) return {{0, plan.scenario.carried_load}};
  std::vector<Carried> carried;
  std::size_t sample = 0;
  for (const LegResult& leg : plan.legs) {
    carried.push_back({sample, leg.load});
    sample += leg.samples;
  }
  return carried;
}

MecanumBody body_of(const Vehicle& vehicle, const WheelMotors& motors, const std::string& load) {
  MecanumBody body{vehicle.mass, motors.inertia > 0.0 ? motors.inertia : even_inertia(vehicle.footprint, vehicle.mass), motors.wheel_inertia, motors.rolling_arm};
  if (!(body.inertia > 0.0)) body.inertia = 1e-9 * vehicle.mass;  // a point turns for nothing
  const auto known = vehicle.loads.find(load);
  if (known == vehicle.loads.end() || !(known->second.mass > 0.0)) return body;
  // Both about the origin already: even_inertia has the load's place in it.
  body.mass += known->second.mass;
  body.inertia += even_inertia(known->second.footprint, known->second.mass);
  return body;
}

Twist mean(const Twist& a, const Twist& b) { return {0.5 * (a.forward + b.forward), 0.5 * (a.left + b.left), 0.5 * (a.turn + b.turn)}; }

/// Keeps the greatest size of any wheel's, whose and when it was.
template <class Wheels>
void keep_greatest(const Wheels& w, double t, double& most, double& at, std::string_view& wheel) {
  for (const auto& [value, name] : {std::pair<double, std::string_view>{w.front_left, "front left"}, {w.front_right, "front right"}, {w.rear_left, "rear left"}, {w.rear_right, "rear right"}}) {
    if (std::abs(value) > most) most = std::abs(value), at = t, wheel = name;
  }
}

}  // namespace

WheelTorques wheel_torques(const Plan& plan, const ExactControls& controls, const WheelMotors& motors) {
  const Vehicle& vehicle = plan.scenario.vehicle;
  const Mecanum& drive = std::get<Mecanum>(vehicle.drive);
  const std::vector<Carried> carried = carried_along(plan);
  WheelTorques all;
  all.motors = motors;
  all.rows.resize(controls.rows.size());
  std::size_t leg = 0;
  for (std::size_t k = 0; k < controls.stretches.size(); ++k) {
    const StretchRows& stretch = controls.stretches[k];
    const std::size_t end = k + 1 < controls.stretches.size() ? controls.stretches[k + 1].first_row : controls.rows.size() - 1;
    while (leg + 1 < carried.size() && carried[leg + 1].first_sample <= stretch.first_sample) ++leg;
    const MecanumDynamics dynamics{drive, body_of(vehicle, motors, carried[leg].load)};
    // A plan may begin in motion.
    Twist from = k == 0 && plan.samples.front().speed > 0.0 ? controls.rows[stretch.first_row].twist : Twist{};
    const double before = dynamics.kinetic_energy(from);
    for (std::size_t i = stretch.first_row; i < end; ++i) {
      const Twist to = i + 1 < end ? mean(controls.rows[i].twist, controls.rows[i + 1].twist) : Twist{};
      const Twist middle = mean(from, to);
      const Twist rate{(to.forward - from.forward) / controls.period, (to.left - from.left) / controls.period, (to.turn - from.turn) / controls.period};
      const MecanumTorques torques = all.rows[i] = dynamics.torques(middle, rate);
      const MecanumWheels turning = wheels_of(drive, middle);
      for (const double power : {torques.front_left * turning.front_left, torques.front_right * turning.front_right, torques.rear_left * turning.rear_left,
                                 torques.rear_right * turning.rear_right}) {
        (power > 0.0 ? all.driving : all.braking) += controls.period * std::abs(power);
      }
      all.rolling_losses += controls.period * dynamics.power_lost(middle);
      keep_greatest(torques, controls.rows[i].t, all.greatest_torque, all.greatest_torque_at, all.greatest_torque_wheel);
      keep_greatest(wheels_of(drive, controls.rows[i].twist), controls.rows[i].t, all.greatest_speed, all.greatest_speed_at, all.greatest_speed_wheel);
      from = to;
    }
    all.kinetic_change += dynamics.kinetic_energy(from) - before;
  }
  all.work = all.driving - all.braking;
  return all;
}

Plan slowed(const Plan& plan, double factor) {
  Plan slow = plan;
  for (Sample& sample : slow.samples) {
    sample.t *= factor;
    sample.speed /= factor;
  }
  return slow;
}

double most_slowing(const Plan& plan, double period) { return std::max(1.0, std::min(slowest, most_commands * period / plan.samples.back().t)); }

std::optional<double> slowing_within(const Plan& plan, double period, const WheelMotors& motors) {
  if (motors.most_torque <= 0.0 && motors.most_speed <= 0.0) return 1.0;
  const auto is_within = [&](double factor) {
    const double share = factor > 1.0 ? 1.0 : 1.0 + of_profile;
    const Plan slow = slowed(plan, factor);
    const WheelTorques torques = wheel_torques(slow, exact_controls(slow, period), motors);
    return (motors.most_torque <= 0.0 || torques.greatest_torque <= share * motors.most_torque) && (motors.most_speed <= 0.0 || torques.greatest_speed <= share * motors.most_speed);
  };
  if (is_within(1.0)) return 1.0;
  const double most = most_slowing(plan, period);
  double low = 1.0, high = std::min(2.0, most);
  while (!is_within(high)) {
    if (high >= most) return std::nullopt;
    low = high;
    high = std::min(2.0 * high, most);
  }
  while (high - low > 1e-3) {
    const double middle = 0.5 * (low + high);
    (is_within(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace waywright
