// A way with lines in place of its detours, as long as they come nearer to nothing than the detours did.
#pragma once

#include <vector>

#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

/// Laws: the same ends; never longer; each line of it keeps at least as far from everything as the nearest point of the run of `points` that it replaces, or is one of `points`'
/// own lines. Greedy, from each end in turn: the farthest place to which there is such a line is next.
std::vector<Vec2> straightened_way(const PlaneSpace& space, std::vector<Vec2> points);

}  // namespace waywright
