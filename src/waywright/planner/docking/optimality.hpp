// How far from the optimum a docking pattern can be: branch and bound over all transition points and headings.
#pragma once

#include "waywright/planner/docking/pattern_docking.hpp"
#include "waywright/planner/docking/prepared.hpp"

namespace waywright {

/// Splits the searched sides' boxes, the one with the lowest bound first, until no pattern can cost less than `cost` / (1 + wanted), or the work
/// is spent. What is bounded: every pattern of our form with these leads whose transition point lies in the sides' polygons and whose
/// heading is within its range; boxes in which every pattern collides are left out. The same input gives the same answer.
/// `reference`: what costs are relative to.
Optimality bound_optimum(const PreparedDocking& prepared, const PatternDockingOptions& options, const PathMeasures& reference, double cost,
                         Budget& budget);

}  // namespace waywright
