// The five maps of the publication that joins RRT* with the whale optimisation algorithm, reconstructed: it shows them as pictures without a
// scale. Halls of 20 × 20 m with rectangles in them, for a point that goes from (1.5, 1.5) to (18.5, 18.5).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/map/map.hpp"
#include "waywright/map/published_maps.hpp"

namespace waywright {

struct WhaleMap {
  std::string name;
  std::string about;  ///< what the publication calls it: "narrow passages"
  Map map;            ///< one boundary and obstacles
  PublishedTask task;
  double optimum;     ///< m, of the shortest way of a point, to half a millimetre
};

/// WOA-1 (empty), WOA-2 (unobtrusive), WOA-3 (narrow passages), WOA-4 (local minima), WOA-5 (cluttered).
const std::vector<std::string>& whale_map_names();
std::optional<WhaleMap> whale_map(std::string_view name);

}  // namespace waywright
