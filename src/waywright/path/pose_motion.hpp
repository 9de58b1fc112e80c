// What a sequence of poses from outside does as a drive: progress, slip and turning from pose to pose, and an
// estimate of the curvature that the vehicle follows. Poses carry noise of some millimetres and milliradians,
// so that no single step says anything.
#pragma once

#include <vector>

#include "waywright/curve/curve.hpp"

namespace waywright {

/// Sums over the steps up to a pose. Each step is split along and across the mean heading of its two poses;
/// for a vehicle that rolls on an arc that split is exact, and noise of the positions cancels from step to
/// step.
struct PoseMotion {
  double progress =
      0.0;  ///< m in the driving direction; smaller than before where the vehicle moves the other way
  double sideways = 0.0;  ///< m to the vehicle's left
  double turned = 0.0;    ///< rad, left positive
};

/// One for each pose; the first is 0.
std::vector<PoseMotion> motion_along(const PoseSequence& sequence, int direction);

/// Indices of poses whose progress grows by at least `apart` metres from each to the next (the last pose
/// excepted); first and last pose are among them, the last only where it is ahead of the one before.
std::vector<std::size_t> thinned(const std::vector<PoseMotion>& motion, double apart = 0.01);

/// Curvature and its rate at a pose.
struct EstimatedCurvature {
  double curvature = 0.0;  ///< 1/m
  double rate = 0.0;       ///< dκ/ds, 1/m²
};

/// One for each pose: the parabola that fits turning over progress best (least squares) within estimate_reach
/// to both sides, inside the sequence. Where there are two places only, their mean curvature. Law: exact up
/// to rounding where curvature is linear in length.
inline constexpr double estimate_reach = 0.2;  ///< m
std::vector<EstimatedCurvature> estimated_curvature(const PoseSequence& sequence, int direction);

}  // namespace waywright
