// A way along corners as a path: corners rounded by arcs where there is room, for vehicles that move any way and for those that turn on the spot.
#pragma once

#include <vector>

#include "waywright/path/path.hpp"
#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

/// Lines and arcs that touch, along `points`. Each corner is cut by as wide an arc as takes half of the shorter line beside it, or a half, a quarter… of that where only
/// so much is free; where none of at least a centimetre is, or the
/// vehicle cannot drive it, it stays a corner. Points nearer than a nanometre are one.
///
/// Law: every place of the disc on it is free where the lines along `points` are; arcs keep `beyond` (m, ≥ 0) more than what is needed.
std::vector<Curve> rounded_way(const PlaneSpace& space, const std::vector<Vec2>& points, double beyond = 0.0);

/// The same way driven from `heading`: by a vehicle that moves any way with its heading going evenly to heading + turn, by another facing along, with turns on the spot
/// at the ends and at corners. Of a way without length a turn on the spot.
Path driven_way(const PlaneSpace& space, const std::vector<Vec2>& points, double heading, double turn, double beyond = 0.0);

/// Fewer points: of a run of them that stays within `tolerance` m of the line between its ends the ends alone, where that line is free. The same ends.
std::vector<Vec2> thinned_way(const PlaneSpace& space, const std::vector<Vec2>& points, double tolerance);

/// Corners within `reach` m of an end are left out where the straight way from the last one outside to the end is free: middles of cells beside start and goal, for which
/// nobody need turn aside. Law: never longer; the first and the last point stay. @pre at least two points
std::vector<Vec2> without_stubs(const PlaneSpace& space, std::vector<Vec2> points, double reach);

}  // namespace waywright
