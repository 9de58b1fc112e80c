// What a plan takes of the motors at a mecanum base's wheels, and how much slower it has to be driven where they cannot.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "waywright/drive/controls.hpp"
#include "waywright/drive/mecanum_dynamics.hpp"

namespace waywright {

/// Share by which a plan whose profile keeps to its wheels' speed may be over it between samples, by rounding.
inline constexpr double of_profile = 1e-5;

struct WheelMotors {
  double inertia = 0.0;        ///< kg·m², of yaw about the origin, wheels included, without a load; 0: the mass spread evenly over the footprint
  double wheel_inertia = 0.0;  ///< kg·m², of one wheel's spin with its motor's
  double rolling_arm = 0.0;    ///< m: a wheel's rolling resistance is its load times this
  double most_torque = 0.0;    ///< N·m at a wheel; 0: no limit
  double most_speed = 0.0;     ///< rad/s of a wheel; 0: no limit
};

/// In time, along the commands of a plan.
struct WheelTorques {
  WheelMotors motors;                ///< as asked
  std::vector<MecanumTorques> rows;  ///< each holds as long as the command of this row; the last one stands: 0
  double greatest_torque = 0.0;      ///< N·m, of any wheel
  double greatest_torque_at = 0.0;   ///< s
  std::string_view greatest_torque_wheel = "front left";  ///< whose it is: front left, front right, rear left, rear right
  double greatest_speed = 0.0;       ///< rad/s, of any wheel
  double greatest_speed_at = 0.0;    ///< s
  std::string_view greatest_speed_wheel = "front left";
  double driving = 0.0;              ///< J, that motors do where they drive their wheels
  double braking = 0.0;              ///< J, that they take out where they brake them, ≥ 0
  double work = 0.0;                 ///< J, driving − braking
  double rolling_losses = 0.0;       ///< J
  double kinetic_change = 0.0;       ///< J, from the first command to the last. Law: work = kinetic_change + rolling_losses, up to rounding
};

/// Names of the torques' columns, in order of the wheels.
struct TorqueColumn {
  const char* name;
  double MecanumTorques::*torque;
};
inline constexpr std::array torque_columns{TorqueColumn{"torque_front_left", &MecanumTorques::front_left}, TorqueColumn{"torque_front_right", &MecanumTorques::front_right},
                                           TorqueColumn{"torque_rear_left", &MecanumTorques::rear_left}, TorqueColumn{"torque_rear_right", &MecanumTorques::rear_right}};

/// The twist goes straight from one command's begin to the next's, where it is the mean of the two commands' (nothing where the vehicle stands); each torque is
/// what that change takes at the twist in its middle. The load of each leg counts, its mass spread evenly over its footprint.
/// @pre a mecanum base with a mass, and `controls` are those of the plan
WheelTorques wheel_torques(const Plan& plan, const ExactControls& controls, const WheelMotors& motors);

/// The plan driven so many times slower: the same way, every time stretched evenly. @pre factor ≥ 1; the plan begins at rest
Plan slowed(const Plan& plan, double factor);

/// The greatest factor that is tried: a hundred, or what makes a million commands of the plan. ≥ 1
double most_slowing(const Plan& plan, double period);

/// The least factor, to a thousandth, by which the plan is driven slower so that no limit of the motors is exceeded; 1 where none is; empty where most_slowing is
/// not enough. @pre as of wheel_torques
std::optional<double> slowing_within(const Plan& plan, double period, const WheelMotors& motors);

}  // namespace waywright
