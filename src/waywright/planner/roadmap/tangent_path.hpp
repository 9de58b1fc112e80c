// From a way of lines and arcs to the pieces of a path.
#pragma once

#include "waywright/path/path.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/tangent_graph.hpp"

namespace waywright {

/// Arcs of `radius` are driven where the vehicle can; where it cannot, or where they are tiny, it turns on the spot at corners around them.
bool drives_arcs(const Vehicle& vehicle, double radius);
/// The corners, with start and goal: of each arc as few as leave no more than 60° to each and are free (15 % farther out at most); of one beside which nothing is, its chords.
std::vector<Vec2> corners_around(const PlaneSpace& space, const TangentWay& way, const TangentGraph& graph);
Path tangent_path(const PlaneSpace& space, const PlaneEnd& start, const TangentWay& way, const TangentGraph& graph, const PlaneEnd& goal);

}  // namespace waywright
