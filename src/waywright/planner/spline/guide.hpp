// A shortest way around obstacles for a spline to follow: it tells a search on which side of each to look.
#pragma once

#include <optional>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// Corners of a taut way from start to goal, both included, of the disc around the footprint: with half of `wanted` m more clearance than is asked for
/// where there is such a way, else with what is asked for. nullopt where there is none (the footprint may fit where its disc does not), or
/// where the clock or the flag ended the search. What it expands is no part of the budget's evaluations.
std::optional<std::vector<Vec2>> guide_for(const Problem& problem, double wanted, Budget& budget);

/// `count` points between the ends of a guide: its corners, then again and again the middle of the longest gap; where there are more corners than
/// that, places at equal distances along it. @pre at least two corners
std::vector<Vec2> points_along(const std::vector<Vec2>& guide, std::size_t count);

}  // namespace waywright
