// The vehicle: footprint, drive model, limits. Body frame: x forward (on a forklift towards the fork tips), y left;
// its origin is the point that follows the path.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// Outline in the body frame: a simple polygon, or a disc about the origin.
struct Footprint {
  Ring polygon;        ///< counter-clockwise; empty where the footprint is a disc
  double disc = 0.0;   ///< radius in metres, ≥ 0, where polygon is empty

  bool is_disc() const { return polygon.empty(); }
  double radius() const;       ///< greatest distance of any of its points from the origin
  double inner_radius() const; ///< of the largest disc about the origin that it holds; 0 where the origin is not in it
  double front() const;        ///< greatest x: the fork tips of a forklift
  double least_width() const;  ///< least distance between parallel lines that enclose it
};

enum class SteeredAxle { rear, front };

/// One steered axle, `wheelbase` behind (rear) or before (front) the fixed axle that follows the path.
struct Tricycle {
  double wheelbase = 0.0;                     ///< m, > 0
  double max_steering = 0.0;                  ///< rad, in (0, π/2)
  std::optional<double> max_steering_rate{};  ///< rad/s, > 0
  SteeredAxle steered_axle = SteeredAxle::rear;
};
struct Differential {
  double track = 0.0;  ///< m, > 0
};
struct Mecanum {
  double wheel_radius = 0.0, half_length = 0.0, half_width = 0.0;  ///< m, > 0
  std::optional<double> max_wheel_speed{};  ///< rad/s of any wheel, > 0
  std::optional<double> max_torque{};       ///< N·m of a motor at its wheel, > 0
  double wheel_inertia = 0.0;               ///< kg·m² of one wheel's spin with its motor's, ≥ 0
  double rolling_arm = 0.0;                 ///< m: a wheel's rolling resistance is its load times this; ≥ 0

  /// m/s: the greatest speed along a way on which no wheel is faster than it may; +∞ where wheels have no limit. `off` in rad: from the heading to the course, wherever it is
  /// from `off` to `off + change`; `turning` in rad/m: dθ/ds of the heading, at most. Wheels turn by v·(±cos off ± sin off ± (half_length + half_width)·turning)/wheel_radius,
  /// the fastest of them by the sum of the sizes, which is greatest askew, at odd eighths of a turn.
  double max_speed(double off, double change, double turning) const;
};
using Drive = std::variant<Tricycle, Differential, Mecanum>;

/// An absent limit is no limit.
struct Limits {
  double speed = 1.0;                          ///< m/s, direction +1
  double reverse_speed = 1.0;                  ///< m/s, direction −1
  double acceleration = 0.5;                   ///< m/s²
  double deceleration = 0.5;                   ///< m/s²
  std::optional<double> lateral_acceleration;  ///< m/s²
  std::optional<double> angular_speed;         ///< rad/s
  std::optional<double> angular_acceleration;  ///< rad/s²
  std::optional<double> curvature;             ///< 1/m
  std::optional<double> curvature_rate;        ///< dκ/ds, 1/m²
};

struct Load {
  Footprint footprint;
  double mass = 0.0;  ///< kg
};

struct Vehicle {
  std::string name;
  Footprint footprint;
  std::vector<Ring> forks;  ///< the parts of the footprint that may enter a pocket; empty: none
  std::map<std::string, Load> loads;
  double mass = 0.0;  ///< kg; 0: not given
  Drive drive = Differential{1.0};
  Limits limits;
  Pose control_point{};

  /// The smaller of the limit given and tan(max_steering)/wheelbase; +∞ where neither binds. 1/m.
  double max_curvature() const;
  bool can_turn_on_the_spot() const;
  /// It can drive in any direction whichever way it faces (holonomic).
  bool moves_any_way() const { return std::holds_alternative<Mecanum>(drive); }
  /// Curvature rate or steering rate is limited: the curvature can jump only where the vehicle stands.
  bool steering_takes_time() const;
  /// That, or angular acceleration is limited: a vehicle that moves cannot change its curvature at once.
  bool stands_at_curvature_jumps() const { return steering_takes_time() || limits.angular_acceleration.has_value(); }
  /// rad/s of a turn on the spot: the smaller of the limit and what the wheels' greatest speed allows; absent where neither binds.
  std::optional<double> max_turning_speed() const;
  /// Steering angle of a tricycle at a path curvature; 0 for other drives.
  double steering_angle(double curvature) const;
};

}  // namespace waywright
