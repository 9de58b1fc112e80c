// The picture of a map alone, or of two maps on each other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waywright/map/lane_graph.hpp"

namespace waywright {

struct MapPicture {
  const Map* map = nullptr;
  std::string name;                ///< of the map, for the legend
  const Map* below = nullptr;      ///< another map, drawn in grey under the first; may be none
  std::string below_name;
  struct Pair {
    Vec2 placed;  ///< where a point of the map lies
    Vec2 meant;   ///< where it should
  };
  std::vector<Pair> pairs;         ///< their residuals are those of the map's alignment
  const LaneGraph* lanes = nullptr;  ///< drawn over both; may be none
};

/// An SVG about `width` pixels wide, with coordinates and a legend.
std::string map_svg(const MapPicture& picture, double width);

}  // namespace waywright
