// How a search went: its lines in the picture of the plan, and a moving picture of its own.
#pragma once

#include <string>

#include "waywright/judge/plan.hpp"
#include "waywright/report/scene_parts.hpp"

namespace waywright {

/// The lines that are there at the end, and agents where they ended. Of very many lines in the region evenly fewer, as the legend tells.
void draw_search(SvgWriter& svg, const SearchPicture& search, const Box& region);
std::vector<LegendEntry> search_legend(const SearchPicture& search, const Box& region);

/// An <svg> element that moves (SMIL): lines, the best ways and swarms as they came and went, over and over; where nothing moves it shows the end. @pre plan.search
std::string search_svg(const Problem& problem, const Plan& plan, double width);

}  // namespace waywright
