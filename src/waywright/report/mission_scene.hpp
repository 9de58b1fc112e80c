// The picture of a mission in legs.
#pragma once

#include <string>
#include <vector>

#include "waywright/report/leg_views.hpp"
#include "waywright/report/scene.hpp"

namespace waywright {

/// An <svg> element about `width` pixels wide: map, stations, each leg with its number and colour, what the vehicle with its load sweeps, the
/// load where it is carried, tightest spots, legend.
std::string mission_scene_svg(const Plan& plan, const std::vector<LegView>& legs, double width);
/// The same for a page: the legend is a list below the picture.
std::string mission_scene_html(const Plan& plan, const std::vector<LegView>& legs, double width);
/// A small one for an overview, without names.
SmallPicture mission_small_picture(const Plan& plan, const std::vector<LegView>& legs);

}  // namespace waywright
