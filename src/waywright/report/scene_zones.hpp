// A scenario's zones in the picture.
#pragma once

#include <vector>

#include "waywright/report/scene_parts.hpp"

namespace waywright {

/// Tinted or hatched by type, with an outline, and arrows along the direction of one-way zones. Before the map is drawn.
void draw_zone_areas(SvgWriter& svg, const std::vector<Zone>& zones);
/// Their names and values. One-way zones, which have arrows, are named only where nothing else is and, of many, where their own area, or the paper beside it, holds the name.
void name_zones(Labels& labels, const View& view, const std::vector<Zone>& zones, const Box& region);
/// One entry for each type that there is.
std::vector<LegendEntry> zone_legend(const std::vector<Zone>& zones);

}  // namespace waywright
