// What there is to say of a path of lines, arcs and turns on the spot.
#pragma once

#include <string>
#include <vector>

#include "waywright/path/path.hpp"

namespace waywright {

struct WayCounts {
  int direction_changes = 0;
  int curvature_jumps = 0;  ///< while the direction stays
  int turns = 0;            ///< on the spot
  double turning = 0.0;     ///< rad, in all
};

WayCounts counts_of(const Path& path);

/// "2 changes of direction"; with `is_turning` also "… and 3 turns on the spot, 180.0° in all".
std::string changes_words(const WayCounts& counts, bool is_turning);
/// That the steered wheel is turned standing where the curvature jumps; empty where it does not.
std::string jumps_sentence(const WayCounts& counts);
/// Poses along it, near enough to each other for a picture.
std::vector<Pose> poses_along(const Path& path);

}  // namespace waywright
