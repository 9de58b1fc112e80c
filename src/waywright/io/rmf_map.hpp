// The walls and lanes of an Open-RMF building: its traffic editor's .building.yaml.
#pragma once

#include <string>

#include "waywright/core/result.hpp"
#include "waywright/map/lane_graph.hpp"

namespace waywright {

/// Walls of one level as lines, in metres, y upwards. Pixels of the reference image are scaled by the level's measurements (the mean of what they say), and their
/// origin is the image's upper left corner, as Open-RMF has it; in `cartesian_meters` coordinates are taken as they stand. `level`: needed where there are several.
/// Lanes, which are routes and no obstacles, go into
/// `lanes`, with the vertices on them and the named ones as places. The notes tell the scale and how well the measurements agree, where the named vertices lie (places for goals
/// and waypoints), how many lanes there are, and what was left out: doors (open), models, lanes for people.
Parsed<Map> decode_rmf_map(const std::string& bytes, const std::string& name, const std::string& level, LaneGraph* lanes = nullptr);

}  // namespace waywright
