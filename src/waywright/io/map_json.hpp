#pragma once

#include <filesystem>
#include <string>

#include "waywright/io/json_reader.hpp"
#include "waywright/map/map.hpp"

namespace waywright {

/// A scenario's `map` object; files in it are relative to `folder`. `source` receives where it came from, for the record.
Map read_map_node(const Node& node, const std::filesystem::path& folder, Json& source);

/// polygons and cells, inlined.
Json map_to_json(const Map& map);

}  // namespace waywright
