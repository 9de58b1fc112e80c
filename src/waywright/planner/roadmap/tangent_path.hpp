// From a way of lines and arcs to the pieces of a path.
#pragma once

#include "waywright/path/path.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/tangent_graph.hpp"

namespace waywright {

/// Arcs of `radius` are driven where the vehicle can; where it cannot, or where they are tiny, it drives along their chords and turns on the spot at their ends.
/// `margin`: what the chords may use, as of the graph.
bool drives_arcs(const Vehicle& vehicle, double radius);
/// Where chords begin and end, with start and goal.
std::vector<Vec2> chords_of(const TangentWay& way, double radius, double margin);
Path tangent_path(const PlaneSpace& space, const PlaneEnd& start, const TangentWay& way, const TangentGraph& graph, const PlaneEnd& goal);

}  // namespace waywright
