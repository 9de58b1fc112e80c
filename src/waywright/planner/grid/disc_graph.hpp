// The moves that a disc can make between the cells of a grid.
#pragma once

#include "waywright/planner/grid/grid_frame.hpp"
#include "waywright/planner/grid/grid_graph.hpp"

namespace waywright {

/// Moves of a point that keeps more than `needed` m from everything (a disc's radius and its margin). What a distance transform settles is
/// settled: by Lipschitz's bound a point on the way from p to q, ℓ apart, is at least (d(p) + d(q) − ℓ)/2 from everything. The rest has to be asked of
/// the exact outlines when a search comes there.
GridGraph disc_graph(const GridFrame& frame, const CellBounds& bounds, Neighbours neighbours, double needed);

}  // namespace waywright
