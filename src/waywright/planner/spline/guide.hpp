// A shortest way around obstacles for a spline to follow: it tells a search on which side of each to look.
#pragma once

#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

struct Guide {
  std::vector<Vec2> corners;  ///< start and goal included; empty: no guide
  double disc = 0.0;          ///< m, radius of the disc that it is for
};

/// A taut way for the disc around the footprint, or, where that has none, for one of half the footprint's width: with half of `wanted` m more clearance
/// than is asked for where there is such a way, else with what is asked for. Empty where there is none, or where the clock or the flag ended the
/// search. It is a hint, and proves nothing; what it expands is no part of the budget's evaluations.
Guide guide_for(const Problem& problem, double wanted, Budget& budget);

/// `count` points between the ends of a guide: its corners, then again and again the middle of the longest gap; where there are more corners than
/// that, places at equal distances along it. @pre at least two corners
std::vector<Vec2> points_along(const std::vector<Vec2>& guide, std::size_t count);

}  // namespace waywright
