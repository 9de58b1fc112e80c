#pragma once

#include <filesystem>

#include "waywright/io/json_reader.hpp"
#include "waywright/map/lane_graph.hpp"

namespace waywright {

/// A scenario's `map` object; files in it are relative to `folder`. `source` receives where it came from, for
/// the record: kind, file as named, SHA-256 of the files read, transform and residuals, overlays; a record
/// that the object itself carries is kept as it is. `lanes`, where given, receives those that the file has.
Map read_map_node(const Node& node, const std::filesystem::path& folder, Json& source, LaneGraph* lanes = nullptr);

/// polygons and cells, inlined, with the alignment and the notes.
Json map_to_json(const Map& map);

}  // namespace waywright
