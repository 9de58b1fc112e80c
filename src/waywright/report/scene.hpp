// The picture of a plan.
#pragma once

#include <string>

#include "waywright/judge/plan.hpp"
#include "waywright/report/svg_writer.hpp"

namespace waywright {

/// An <svg> element about `width` pixels wide: map, station, zones, alternatives, swept footprint, path,
/// tightest spot, legend.
std::string scene_svg(const Problem& problem, const Plan& plan, double width);

/// The same for a page: the legend is a list below the picture.
std::string scene_html(const Problem& problem, const Plan& plan, double width);

/// A small picture for an overview: map, station, swept footprint, path, tightest spot; nothing is written in it but S and the end's letter.
std::string small_svg(const Problem& problem, const Plan& plan, double width);

/// Several plans of one problem overlaid, each path with its name in the legend.
std::string overlay_svg(const Problem& problem, const std::vector<std::pair<std::string, const Plan*>>& plans,
                        double width);

}  // namespace waywright
