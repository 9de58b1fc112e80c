// One function for each kind of map that a scenario's `map` object may name; what all kinds share is in map_reader.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "waywright/io/json_reader.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/map/lane_graph.hpp"

namespace waywright {

/// The object that is read, and what it becomes. Failures are its node's.
struct MapBeingRead {
  const Node& node;
  const std::filesystem::path& folder;  ///< that its files' names are relative to
  double most = 0.0;                    ///< m, of coordinates
  Map& map;
  LaneGraph& lanes;
};

/// Each adds to the map, and to the record of where it is from.
void read_ros(const MapBeingRead& m, Json& source);
void read_image(const MapBeingRead& m, Json& source);
void read_movingai(const MapBeingRead& m, Json& source);
void read_generated(const MapBeingRead& m, Json& source);
void read_svg(const MapBeingRead& m, Json& source);
void read_dxf(const MapBeingRead& m, Json& source);
void read_rmf(const MapBeingRead& m, Json& source);
void read_opentcs(const MapBeingRead& m, Json& source);

/// One more file of those that a scenario may name; false where there are too many.
bool count_file(const Node& node);
/// A file's name, without its folder, and hash: the record is the same wherever the scenario lies.
void add_file(Json& source, const std::string& name, const std::string& hash);
void append(Map& map, Map more);

}  // namespace waywright
