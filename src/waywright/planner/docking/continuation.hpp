// What is left of a plan, carried along when start or docked pose turn out to be a little elsewhere.
#pragma once

#include <optional>
#include <vector>

#include "waywright/path/path.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// A place on a path that is being driven, as a start for what comes next.
struct Handover {
  double driven = 0.0;  ///< m of the path so far
  Pose pose{};
  StartMotion motion;
  bool is_turning = false;  ///< on the spot: `driven` and `pose` are of before its turns there
  double turned = 0.0;      ///< rad, of those turns, whichever way, that are done
};

/// Where the samples have the vehicle after t seconds (clamped to their time). Within 0.1 mm before the end of a piece it is taken to be there, and to stand where the
/// samples have it stand there; where it drives on, its curvature is that of the next piece. Turns on the spot that are over are behind it.
/// @pre the samples are the path's, with t and speed
Handover handover_at(const Path& path, const std::vector<Sample>& samples, double t);

struct Continuation {
  Path path;              ///< of the whole mission
  double farthest = 0.0;  ///< m, no place of what was left moves by more than this
};

/// What is left of `old` after `driven` metres, its first curve carried along to the problem's first pose and curvature, its last one to the
/// goal: of a quintic, the three control points that make pose and curvature of an end move with it, and every other curve stays
/// what it is. (A Bézier curve moves nowhere by more than its control points.) Empty where that cannot be: an end has moved and its curve is no
/// quintic, nothing is left but the way into the shelf, or the vehicle is driven out of it. Nothing is proven of what is returned.
std::optional<Continuation> continuation(const Problem& problem, const Path& old, double driven);

}  // namespace waywright
