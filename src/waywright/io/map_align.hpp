// Pairs of points that place a map, and whether they can be meant.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waywright/io/json_reader.hpp"
#include "waywright/map/map.hpp"

namespace waywright {

/// `[[[x, y] on the map, [x, y] in the world], …]`, coordinates within ±most. Pairs that only fit a mirrored map, or that no turn and shift bring together, are
/// refused; ones that would fit a map of another scale are noted. nullopt where the node has failed.
std::optional<Alignment> read_align(const Node& node, double most, std::vector<std::string>& notes);

}  // namespace waywright
