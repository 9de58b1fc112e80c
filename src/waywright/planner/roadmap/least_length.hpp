// The shortest that any way can be: a lower bound for every planner in the plane.
#pragma once

#include <string>

#include "waywright/core/budget.hpp"
#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

struct LeastLength {
  double metres = 0.0;        ///< no path of the footprint from start to goal is shorter
  bool is_straight = false;   ///< it is only that of the straight line
  bool is_cut_short = false;    ///< that was so because the budget ended the search for a closer bound
  bool is_unreachable = false;  ///< there is none at all
  bool is_curve = false;      ///< it is that of the shortest curve between the ends that a vehicle which cannot turn on the spot can drive, among no obstacles
  double disc = 0.0;          ///< m, of the disc that it was found for: the largest about the origin that the footprint holds
  bool is_partial = false;    ///< of a map with very many corners: how far the search came, which is less than the shortest way
};

/// Of the largest disc about the origin that the footprint holds, which is there whatever the heading, and keeps what is required; obstacles are not grown by any
/// tolerance. (Gaps under two micrometres count as shut where neither a disc nor a clearance is left.) Where the map has more than 3000 corners only some of
/// the search is done, and its bound is told. The straight line where the budget ends.
/// Where it is longer, the Reeds–Shepp curve of the vehicle's greatest curvature, of vehicles that cannot turn on the spot.
LeastLength least_length(const PlaneSpace& space, Budget& budget);

/// "No path of this footprint … can be shorter than 3.210 m (visibility graph …): this one is at most 1.2 % longer." Empty where nothing is known.
std::string bound_sentence(const LeastLength& least, double metres);
/// What the bound says of a search that found nothing; empty where it says nothing.
std::string unreachable_sentence(const LeastLength& least, const Problem& problem);

}  // namespace waywright
