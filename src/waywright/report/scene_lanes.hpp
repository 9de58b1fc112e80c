// Lanes that vehicles are led along, in pictures of plans and of maps.
#pragma once

#include <vector>

#include "waywright/report/scene_parts.hpp"
#include "waywright/scenario/zone.hpp"

namespace waywright {

/// An arrow head of some pixels in the middle of a course; of what is no longer than `shortest` px none.
void draw_course_arrow(SvgWriter& svg, const Polyline& course, double shortest, std::string_view style);

/// The lanes that `meta` tells of, faint, with arrows on those of one way but where a directed zone has its own. Returns whether there are any.
bool draw_lane_courses(SvgWriter& svg, const std::string& meta, const std::vector<Zone>& zones);

std::vector<LegendEntry> lane_legend();

}  // namespace waywright
