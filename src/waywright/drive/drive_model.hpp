// A vehicle that is told speeds and turning rates, and follows as fast as its limits let it.
#pragma once

#include <limits>

#include "waywright/drive/odometry.hpp"
#include "waywright/vehicle/vehicle.hpp"

namespace waywright {

struct DriveState {
  Pose pose{};
  double v = 0.0;          ///< m/s, forward positive
  double turn = 0.0;       ///< rad/s
  double curvature = 0.0;  ///< 1/m, turn/v as the wheels stand; of vehicles that cannot turn on the spot
};

/// What happened in a step: as if these had been constant in it, an arc.
struct DriveStep {
  double v = 0.0, turn = 0.0;
};

/// Speeds follow commands within acceleration and deceleration (to 0 first, where they change their sign), turning within the angular acceleration. Vehicles with a
/// steered wheel take turn/v of the command as a steering angle, within its limit and rate and those of curvature, and keep it while they speed up or brake.
/// Commands over the limits of speed, angular speed and lateral acceleration are obeyed as far as those go. A limit that is not given is none, but for `turn_speed`.
///
/// Law: a state that keeps the limits is followed by one that does, and the step's v and turn do too: of speed, angular speed, lateral acceleration, curvature (but under
/// 0.01 m/s, where vehicles with two driven wheels are taken to turn on the spot), acceleration, deceleration, angular acceleration (not of steered wheels), the wheel's
/// rate and that of curvature.
class DriveModel {
 public:
  /// `turn_speed`: rad/s, where the vehicle names no angular speed
  explicit DriveModel(const Vehicle& vehicle, double turn_speed = 1.0);

  /// What a command may be at most.
  double most_turn() const { return most_turn_; }
  double most_speed(int direction) const { return direction < 0 ? limits_.reverse_speed : limits_.speed; }

  /// After `time` s, > 0, under a command. Commands of less than a fiftieth of the greatest speed are to stand.
  DriveStep advance(DriveState& state, double v, double turn, double time) const;
  /// The same on the way to a stand: speed and turning fall as fast as they may, the steered wheel stays as it is.
  DriveStep brake(DriveState& state, double time) const;
  bool stands(const DriveState& state) const { return state.v == 0.0 && state.turn == 0.0; }

 private:
  DriveStep move(DriveState& state, double v, double turn, double time) const;
  DriveStep turned(DriveState& state, double v, double turn, double time) const;
  DriveStep bent(DriveState& state, double v, double turn, double time) const;
  double ramped_speed(double from, double to, double time) const;
  double steered(const DriveState& state, double curvature, double way, double time) const;
  /// m/s, by the limits of angular speed and lateral acceleration
  double top_speed(double curvature) const;

  Limits limits_;
  bool on_the_spot_;
  const bool has_wheel_;
  Tricycle wheel_{};
  double most_turn_, most_curvature_;
};

}  // namespace waywright
