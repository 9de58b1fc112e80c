// What a drive can do, held against poses from outside.
#pragma once

#include <vector>

#include "waywright/path/path.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {

/// What noise of outside poses may cause. Each holds for every stretch of all pose sequences of the path
/// together, however short its pieces: what is allowed does not grow with their number.
inline constexpr double slip_allowed = 0.01;     ///< m sideways, beside slip_share
inline constexpr double slip_share = 0.02;       ///< of the progress
inline constexpr double retreat_allowed = 0.01;  ///< m against the driving direction, of a piece
inline constexpr double turn_allowed = 0.02;     ///< rad of turning beyond the curvature limit
inline constexpr double heading_change_allowed =
    0.01;  ///< rad, of each heading difference that the curvature rate is made of
inline constexpr double estimate_slack = 0.01;  ///< of the limits: chords are shorter than arcs

/// Slip and driving direction of vehicles that cannot move sideways; curvature and its rate where the vehicle
/// has such limits.
std::vector<Violation> check_pose_sequences(const Vehicle& vehicle, const Path& path);

}  // namespace waywright
