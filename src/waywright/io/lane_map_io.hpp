// Map files with the lanes that some of them have.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/map/lane_graph.hpp"

namespace waywright {

struct LaneMap {
  Map map;
  LaneGraph lanes;  ///< empty where the file has none
};

/// As read_map, with the lanes of an Open-RMF building or an openTCS plant model, placed as the map is. `corridor`, m: of a plant model, strips so wide along its lanes are
/// all that is free.
Parsed<LaneMap> read_lane_map(const std::filesystem::path& file, const std::vector<std::pair<Vec2, Vec2>>& align = {}, std::optional<double> corridor = std::nullopt,
                              std::string* record = nullptr, const dxf::Options& drawing = {}, const CellMapOptions& cells = {});

}  // namespace waywright
