#pragma once

#include <string>
#include <vector>

#include "commands.hpp"
#include "waywright/map/lane_graph.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright::app {

/// What `map` takes beside its other arguments where a file has lanes.
struct LaneArguments {
  std::optional<double> corridor;                 ///< m
  std::optional<double> margin;                   ///< m
  bool off_lanes = false;                         ///< what lies beside lanes may be driven on, too
  std::optional<std::filesystem::path> scenario;  ///< to write: between two places
  std::string from, to;                           ///< names of them
  std::optional<std::filesystem::path> vehicle;   ///< that drives there
  std::optional<double> lane_width;               ///< m, of the lanes' zones
  std::optional<double> prefer;                   ///< what a metre on a lane costs
};
int map(const MapArguments& arguments, const LaneArguments& about_lanes);

/// The vehicle that is named, else the model's first with a size, as `doubts` is told.
Parsed<Vehicle> vehicle_on_lanes(const std::filesystem::path& file, const LaneArguments& arguments, const LaneGraph& graph, std::vector<std::string>& doubts);
/// m: the width of strips along lanes in which a vehicle has room to turn.
double corridor_for(const Vehicle& vehicle);

/// From the place --from to the place --to: heading as a place asks for it, else along the lanes of the shortest route, which `meta` tells; one-way lanes, speeds and
/// preferences as zones. `doubts` receives what a user should know of it.
Parsed<Scenario> scenario_along_lanes(const std::filesystem::path& file, const LaneArguments& arguments, const LaneGraph& graph, Map map, std::string record, std::vector<std::string>& doubts);

}  // namespace waywright::app
