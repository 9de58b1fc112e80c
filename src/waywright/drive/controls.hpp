// What is commanded to drive a plan: a series in time, with what each wheel does.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "waywright/drive/odometry.hpp"
#include "waywright/judge/plan.hpp"

namespace waywright {

/// Holds from t to the next one's t. The last one stands.
struct ControlRow {
  double t = 0.0;       ///< s from the start
  Twist twist{};        ///< commanded; constant while it holds
  double steering = 0.0;  ///< rad, of a tricycle's steered wheel, also while it stands
  Pose pose{};          ///< where the commands lead to by t, from the plan's start
};

/// How far a drive ends from where it should.
struct EndError {
  double position = 0.0;  ///< m
  double heading = 0.0;   ///< rad, ≥ 0
};
EndError end_error(const Pose& end, const Pose& wanted);

/// Names and units of what a drive's wheels are told, in order: "right", "left" (m/s); "steering" (rad), "wheel" (m/s); "front_left" … (rad/s).
struct WheelColumn {
  const char* name;
  const char* unit;
};
std::vector<WheelColumn> wheel_columns(const Drive& drive);
/// The values of these; those that there are not are 0.
std::array<double, 4> wheel_values(const Drive& drive, const ControlRow& row);

/// Between two stands: the first of its commands, and of the plan's samples.
struct StretchRows {
  std::size_t first_row = 0, first_sample = 0;
};

/// The plan's own path and speed profile as commands of one period.
struct ExactControls {
  double period = 0.0;  ///< s
  std::vector<ControlRow> rows;
  std::vector<StretchRows> stretches;
  EndError end;             ///< of the commands, each an arc, added up
  EndError midpoint_end;    ///< of midpoint odometry over the same commands
  double deviation = 0.0;   ///< m, greatest, of the commands' poses from the plan's
  double plan_time = 0.0;   ///< s
  int stands = 0;           ///< places where the vehicle stands on the way
};

/// Each command is the mean of the plan's motion over its period: way driven by v, turn by ω, so headings are exact at every row and the position's error falls with the
/// square of the period. The path's exact curves are asked, not its samples. Where the vehicle stands (changes of direction, turns on the spot, jumps of
/// curvature) it does so until the next multiple of the period: the whole takes at most a period a stand longer than the plan, and no command spans two ways of moving.
/// @pre the plan verifies; period > 0
ExactControls exact_controls(const Plan& plan, double period);

}  // namespace waywright
