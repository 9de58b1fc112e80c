// What a vehicle drives in one go: smoothly joined clothoids in one direction, or a turn on the spot.
#pragma once

#include <vector>

#include "waywright/path/path.hpp"

namespace waywright {

struct LatticeStretch {
  int direction = 1;             ///< +1 forward, −1 backward (the course is the heading + π); 0: turning on the spot
  std::vector<Clothoid> curves;  ///< in the course's direction; empty where it turns on the spot
  Turn turn{};
};

/// m; none of a turn on the spot
double length_of(const LatticeStretch& stretch);
/// ∫κ² over it, 1/m
double bend_of(const LatticeStretch& stretch);
/// Vehicle poses at its ends. @pre not empty
Pose start_of(const LatticeStretch& stretch);
Pose end_of(const LatticeStretch& stretch);
/// The same elsewhere: what was told in the frame's coordinates.
LatticeStretch placed(const LatticeStretch& stretch, const Frame& frame);

/// Clothoids without curvature as lines, straight on ones as one.
Path path_of(const std::vector<LatticeStretch>& stretches);

/// What the vehicle can drive without stopping.
struct BendLimits {
  double curvature = 0.0;       ///< 1/m
  double curvature_rate = 0.0;  ///< 1/m², +∞: none
};
bool are_within(const std::vector<Clothoid>& curves, const BendLimits& limits);

/// Chords: what is longer winds.
inline constexpr double longest_fit = 2.2;
/// Three clothoids from one course to another (two that are in line: straight), curvature continuous, within the limits and without loops; empty where there are none.
std::vector<Clothoid> fitted_within(const Pose& from, double from_curvature, const Pose& to, double to_curvature, const BendLimits& limits);

/// A vehicle's pose on the way, and what the way from the one before is.
struct SteppedPose {
  Pose pose{};
  double way = 0.0;    ///< m of the origin
  double angle = 0.0;  ///< rad by which the heading changes at most
  double bend = 0.0;   ///< ∫κ², 1/m
};
/// At most `step` m and `turn_step` rad apart, first and last included, appended.
void sample_stretch(const LatticeStretch& stretch, double step, double turn_step, std::vector<SteppedPose>& poses);

}  // namespace waywright
