// A scenario's zones as JSON.
#pragma once

#include <string>
#include <vector>

#include "waywright/io/json_reader.hpp"
#include "waywright/scenario/zone.hpp"

namespace waywright {

/// An array of {"type", "name", "area", "direction"|"factor"|"speed"}. What was repaired in a polygon, and directions that look like degrees, go into the notes.
std::vector<Zone> read_zones(const Node& node, std::vector<std::string>& notes);
Json zones_to_json(const std::vector<Zone>& zones);

}  // namespace waywright
