// The worlds of the navigation-field publication, reconstructed: it shows them as pictures only. For a point that goes from start to goal.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/map/map.hpp"
#include "waywright/map/published_maps.hpp"

namespace waywright {

struct FieldWorld {
  std::string name;
  std::string about;  ///< "two discs"
  Map map;            ///< discs as polygons of 96 corners: obstacles from inside, a round boundary from outside
  std::vector<PublishedTask> tasks;
};

/// APF-1 (polygons and a disc), APF-2 (a U), NF-TWO (two discs), NF-S3 (three discs), NF-ST (three stars).
const std::vector<std::string>& field_world_names();
std::optional<FieldWorld> field_world(std::string_view name);

}  // namespace waywright
