// Lanes as zones: what a scenario can ask of planners where lanes are drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waywright/map/lane_graph.hpp"
#include "waywright/scenario/zone.hpp"

namespace waywright {

struct LaneRules {
  double width = 1.0;                   ///< m, > 0, of the strip along a lane
  bool is_directed = true;              ///< lanes that lead one way become directed zones
  std::optional<double> preference{};   ///< all lanes become preferred zones of this factor
  double vehicle_speed = 0.0;           ///< m/s: lanes that allow less become speed limits
};

struct LaneZones {
  std::vector<Zone> zones;
  std::vector<std::string> notes;  ///< what of the lanes is in no zone, and why
};

/// Strips along the lanes, with square ends. Bends are followed by the strip where it stays simple, else stretch by stretch.
///
/// A directed zone's direction is that from one end to the other, of bends that leave it by up to 75° as a whole, else of each stretch. It ends half a width before the
/// lane's ends, or earlier where another lane that meets it there leads back beside it, so that two directions at a junction never forbid each other everything. Lanes
/// that come nearer than their width to one that leads the other way have no direction (both are told).
///
/// Preferred zones do not overlap: each lane's leaves out what is in one before it.
///
/// Refused: more zones than a scenario may have.
Parsed<LaneZones> lane_zones(const LaneGraph& graph, const LaneRules& rules);

}  // namespace waywright
