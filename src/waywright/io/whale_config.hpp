// The configuration file of the publication on RRT* with the whale optimisation algorithm, as a scenario.
//
// The publication's program is told everything by such a file: `MapProcessor_…`, `PathPlanner_…` and `PathOptimizer_…`, flat as printed, or as
// three objects. Start and goal, the vehicle (a point) and the scale of maps are not in it and are those of the reconstruction: see
// map/whale_maps.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

struct ConfiguredScenario {
  Scenario scenario;
  std::vector<std::string> mapping;  ///< a line a key, in the file's order: "PathPlanner_Step_Size 1.0 -> planner.parameters.step = 1"
};

/// Does the text look like such a file: an object with one of its keys and without a `format`? A comma before a closing bracket, as printed, does no harm.
bool is_whale_config(const std::string& text);

/// Every key is mapped, named as ignored, or refused. `planner`: in place of the one that follows from the keys (rrt_star_woa_global where there is a PathOptimizer
/// key, else rrt_star). `takes` says whether a planner has a parameter; what it has not is named as ignored. A picture is read from `folder`, and taken as
/// 20 m wide, as the five maps are.
Parsed<ConfiguredScenario> parse_whale_config(const std::string& text, const std::string& name, const std::filesystem::path& folder, const std::string& planner = {},
                                              const std::function<bool(const std::string& planner, const std::string& parameter)>& takes = {});

}  // namespace waywright
