// What has appeared, what moves, and where the vehicle waits for it, in the picture.
#pragma once

#include <vector>

#include "waywright/report/scene_parts.hpp"

namespace waywright {

/// The part of the old plan that has been driven, and what has appeared since: after the map is drawn.
void draw_replanned(SvgWriter& svg, const Replanned& replanned);
/// Each moving obstacle at the plan's start and at its end, with its way between and times on it, the same as on the vehicle's way; of a plan that waits also where it is when the
/// vehicle comes to stand; and where both are when they come nearest to each other. Returns whether there is such a meeting.
bool draw_moving(SvgWriter& svg, Labels& labels, const Problem& problem, const Plan& plan, const Box& region);
/// Squares where the vehicle waits, with for how long.
void draw_waits(SvgWriter& svg, Labels& labels, const Plan& plan);
std::vector<LegendEntry> moving_legend(const Plan& plan, bool has_meetings);

}  // namespace waywright
