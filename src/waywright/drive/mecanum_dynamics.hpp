// How a mecanum base speeds up under its wheels' torques, and which torques a wanted motion takes.
//
// Source: the navigation-field publication, (2.8)–(2.10), with the terms that a turning frame needs put in: printed, a free body that turns would turn its velocity
// with it. Wheels roll without slip; x forward, y left; wheels front left, front right, rear left, rear right, driving forward positive.
#pragma once

#include "waywright/drive/odometry.hpp"

namespace waywright {

struct MecanumBody {
  double mass = 0.0;          ///< m, kg, wheels included, > 0
  double inertia = 0.0;       ///< I_pc, kg·m², of yaw about the origin, wheels included, > 0
  double wheel_inertia = 0.0; ///< I_w, kg·m², of one wheel's spin, ≥ 0
  double rolling_arm = 0.0;   ///< f, m: a wheel's rolling resistance is its load times this, ≥ 0
};

/// With a load on: masses add up, and the inertia of each about the origin. `at`: the load's middle in the body frame; `own`: its inertia about that, kg·m².
MecanumBody loaded(const MecanumBody& body, double mass, double own, Vec2 at);
/// kg·m², about the origin, of a mass spread evenly over the area of a footprint. @pre a polygon of positive area, or a disc
double even_inertia(const Footprint& footprint, double mass);

/// N·m at each wheel, driving forward positive.
struct MecanumTorques {
  double front_left = 0.0, front_right = 0.0, rear_left = 0.0, rear_right = 0.0;
};

class MecanumDynamics {
 public:
  /// @pre masses and inertias as told above
  MecanumDynamics(const Mecanum& drive, const MecanumBody& body);

  /// Rates of forward, left and turn: m/s², m/s², rad/s², in the body frame (which turns: a free body's change, though its velocity in the world stays).
  Twist acceleration(const Twist& twist, const MecanumTorques& torques) const;
  /// Of all torques with that acceleration those of least squares: friction and a quarter of what the motion needs at each wheel.
  /// Law: acceleration(twist, torques(twist, a)) is a up to rounding, where the load lies in the middle or not.
  MecanumTorques torques(const Twist& twist, const Twist& acceleration) const;

  /// J, of body and wheels.
  double kinetic_energy(const Twist& twist) const;
  /// W, what the motors put in and what friction takes. Law: the change of kinetic energy is their difference.
  double power_in(const Twist& twist, const MecanumTorques& torques) const;
  double power_lost(const Twist& twist) const;

  /// N·m, that a wheel's rolling resistance turns against where it spins; standing wheels are held by up to that.
  double resistance() const { return resistance_; }

 private:
  MecanumTorques resisting(const Twist& twist) const;

  Mecanum drive_;
  MecanumBody body_;
  double arm_ = 0.0;              // ℓ, m: half length + half width
  double mass_ = 0.0, inertia_ = 0.0;  // M and J, with the wheels' spin in them
  double resistance_ = 0.0;
};

/// As much of an acceleration as motors of `most` N·m can give at this motion: a share in [0, 1] of it. What friction and turning alone take comes first; 0 where
/// that is more than they can.
double share_within(const MecanumDynamics& dynamics, const Twist& twist, const Twist& acceleration, double most);

/// Where a wheel would be faster than `most` rad/s, all by the same factor slower: the way stays the same.
Twist saturated(const Mecanum& drive, const Twist& twist, double most);

}  // namespace waywright
