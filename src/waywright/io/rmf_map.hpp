// The walls of an Open-RMF building: its traffic editor's .building.yaml.
#pragma once

#include <string>

#include "waywright/core/result.hpp"
#include "waywright/map/map.hpp"

namespace waywright {

/// Walls of one level as lines, in metres, y upwards. Pixels of the reference image are scaled by the level's measurements (the mean of what they say), and their
/// origin is the image's upper left corner, as Open-RMF has it; in `cartesian_meters` coordinates are taken as they stand. `level`: needed where there are several.
/// The notes tell the scale and how well the measurements agree, where the named vertices lie (places for goals and waypoints), and what was left out: doors (open),
/// models, and lanes, which are routes.
Parsed<Map> decode_rmf_map(const std::string& bytes, const std::string& name, const std::string& level);

}  // namespace waywright
