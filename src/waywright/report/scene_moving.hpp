// What has appeared, what moves, and where the vehicle waits for it, in the picture.
#pragma once

#include <vector>

#include "waywright/report/scene_parts.hpp"

namespace waywright {

/// The part of the old plan that has been driven, and what has appeared since: after the map is drawn.
void draw_replanned(SvgWriter& svg, const Replanned& replanned);
/// Each moving obstacle at the plan's start and at its end, with its way between; of a plan that waits also where it is when the vehicle comes to stand.
void draw_moving(SvgWriter& svg, const Canvas& canvas, const Plan& plan, LabelRoom& room);
/// Squares where the vehicle waits, with for how long.
void draw_waits(SvgWriter& svg, const Canvas& canvas, const Plan& plan, LabelRoom& room);
std::vector<LegendEntry> moving_legend(const Plan& plan);

}  // namespace waywright
