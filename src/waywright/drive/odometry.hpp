// What wheels do where a vehicle moves so, and how it moves where they do so: odometry and the kinematics of each drive, both ways.
//
// Sources: RRT*-WOA publication (2.9)–(2.17), with its axes set right (x goes with the cosine) and the steered wheel's speed told apart from the fixed axle's;
// mecanum: navigation publication §2, with x forward, y left, wheels driving forward positive.
//
// Laws, tested: from wheels to twist and back, and the other way, is the same up to rounding; arc_step is the motion itself for a twist that
// is constant, and midpoint_step differs from it by at most distance · turn² / 24.
#pragma once

#include "waywright/core/pose.hpp"
#include "waywright/vehicle/vehicle.hpp"

namespace waywright {

/// Motion of the body frame, in it.
struct Twist {
  double forward = 0.0;  ///< [v] m/s, of the origin
  double left = 0.0;     ///< m/s; 0 but for mecanum wheels
  double turn = 0.0;     ///< [Ω] rad/s
};

/// x + δd cos(φ + δφ/2), y + δd sin(φ + δφ/2), φ + δφ: midpoint odometry (2.15)–(2.17), corrected. m, rad; heading wrapped.
Pose midpoint_step(const Pose& pose, double distance, double turn);

/// The same along the arc: δd sinc(δφ/2) in place of δd.
Pose arc_step(const Pose& pose, double distance, double turn);
/// Where a constant twist leads within `time` s.
Pose arc_step(const Pose& pose, const Twist& twist, double time);

/// The constant twist that leads from one pose to the other within `time` s by the shorter turn. Law: arc_step(from, it, time) == to. @pre time > 0
Twist twist_between(const Pose& from, const Pose& to, double time);

/// Speeds of the two wheels on the ground, m/s.
struct DifferentialWheels {
  double right = 0.0, left = 0.0;
};
/// v ± Ω·track/2
DifferentialWheels wheels_of(const Differential& drive, double v, double turn);
Twist twist_of(const Differential& drive, const DifferentialWheels& wheels);

struct SteeredWheel {
  double angle = 0.0;  ///< [ψ] rad, as Vehicle::steering_angle: the wheel's direction from straight ahead
  double speed = 0.0;  ///< m/s, on the ground, of the steered wheel; that of the fixed axle's middle is speed · cos ψ
};
/// `standing`: the angle where v and turn are both 0. |angle| ≤ π/2.
SteeredWheel wheel_of(const Tricycle& drive, double v, double turn, double standing);
Twist twist_of(const Tricycle& drive, const SteeredWheel& wheel);

/// rad/s, forward positive.
struct MecanumWheels {
  double front_left = 0.0, front_right = 0.0, rear_left = 0.0, rear_right = 0.0;
};
MecanumWheels wheels_of(const Mecanum& drive, const Twist& twist);
Twist twist_of(const Mecanum& drive, const MecanumWheels& wheels);
/// rad/s; 0 where the four speeds agree without slip.
double slip_residual(const MecanumWheels& wheels);

}  // namespace waywright
