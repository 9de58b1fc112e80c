// How a vehicle that moves any way, or turns on the spot, follows a wanted velocity: one short even motion after another, under its limits.
#pragma once

#include "waywright/path/path.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// Of the vehicle's origin, on a way that it drives forwards or, moving any way, however it faces.
struct FreeState {
  Vec2 at{};
  double course = 0.0;     ///< rad
  double curvature = 0.0;  ///< 1/m, of the way where it is
  double speed = 0.0;      ///< m/s, ≥ 0
  double t = 0.0;          ///< s
};

struct FreeStep {
  enum class Kind { stand, turn, drive };
  Kind kind = Kind::stand;
  double begins = 0.0;          ///< course at its beginning, rad; not that of the state before where the vehicle stood and moves any way
  double curvature = 0.0;       ///< 1/m, at its beginning, of a drive
  double curvature_rate = 0.0;  ///< 1/m²
  double length = 0.0;          ///< m
  double turn = 0.0;            ///< rad, of a turn on the spot
  FreeState after{};
};

/// Laws: speed, acceleration, deceleration, lateral acceleration (of the acceleration's size where none is given), angular speed and acceleration, curvature and its rate are
/// kept; speeds change evenly within a step. Curvature jumps only where the vehicle's limits let it, or it stands.
class FreeMotion {
 public:
  /// `turn`: rad that a vehicle that moves any way turns by, evenly over at least `least` m of way.
  FreeMotion(const Problem& problem, double turn, double least);

  /// `top`: m/s. A turn on the spot takes the time that it takes, everything else `period`. `exact`: the place after it is that of the curve, else that of its chord.
  FreeStep towards(const FreeState& from, Vec2 wanted, double top, double period, bool exact) const;
  /// Of one that stands, on the spot.
  FreeStep turn(const FreeState& from, double angle) const;
  /// On the arc that leads to a place, to rest there or as far as it comes in a period; kind stand: it cannot.
  FreeStep onto(const FreeState& from, Vec2 goal, double top, double period) const;
  Curve curve(const FreeState& from, const FreeStep& step) const;

  double braking(double speed) const { return 0.5 * speed * speed / deceleration_; }  ///< m
  double top_speed() const { return speed_; }
  double acceleration() const { return acceleration_; }
  double deceleration() const { return deceleration_; }
  bool moves_any_way() const { return any_way_; }
  bool is_smooth() const { return is_smooth_; }  ///< its curvature cannot jump while it moves

 private:
  double turning_time(double angle) const;
  void finish(const FreeState& from, FreeStep& step, double speed, double period, bool exact) const;

  bool any_way_, is_smooth_;
  double speed_, acceleration_, deceleration_, lateral_, angular_, angular_acceleration_, curvature_, curvature_rate_;
};

}  // namespace waywright
