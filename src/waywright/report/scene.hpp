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

struct SmallPicture {
  std::string svg;
  double width = 0.0, height = 0.0;  ///< px
};
/// A small picture for an overview, of what is driven and a margin: map, station, swept footprint, path, tightest spot; nothing is written in it but S and the
/// end's letter. About 200 px on a side; long routes are as wide as they are long, up to 900 px.
SmallPicture small_picture(const Problem& problem, const Plan& plan);

/// Several plans of one problem overlaid, each path with its name in the legend, above them what all share (empty: nothing).
std::string overlay_svg(const Problem& problem, const std::vector<std::pair<std::string, const Plan*>>& plans, const std::string& shared, double width);

}  // namespace waywright
