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

inline constexpr double usual_margin = 5.0;  ///< m

struct LaneMap {
  Map map;
  LaneGraph lanes;  ///< empty where the file has none
};

/// What is free by the lanes. At most one of the two.
struct FreeAlongLanes {
  std::optional<double> corridor{};  ///< m, > 0: nothing but strips so wide along them, beside which walls of a building stay walls
  std::optional<double> margin{};    ///< m, > 0, of a plant model, which has no walls: all that far around them; usual_margin where there is no corridor either
};

/// As read_map, with the lanes of an Open-RMF building or an openTCS plant model, placed as the map is.
Parsed<LaneMap> read_lane_map(const std::filesystem::path& file, const std::vector<std::pair<Vec2, Vec2>>& align = {}, const FreeAlongLanes& lanes_free = {}, std::string* record = nullptr, const dxf::Options& drawing = {}, const CellMapOptions& cells = {});

}  // namespace waywright
