// What is asked, as JSON: a goal with or without waypoints, a station, or legs of such.
#pragma once

#include <string>
#include <vector>

#include "waywright/io/json_reader.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

/// The mission of a scenario object: one of goal (with waypoints), station, legs; what is doubtful goes to the scenario's notes. What is wrong is
/// in the context. A leg through waypoints for which nobody names a planner gets the one through waypoints.
void read_whole_mission(const Node& node, Scenario& scenario);
/// Its fields, appended to the scenario's.
void mission_to_json(const Scenario& scenario, Json& json);

/// `{"name", parameters…}`
PlannerChoice read_planner(const Node& node);

/// Says so where a heading looks like one in degrees.
void doubt_pose(const Node& pose, std::vector<std::string>& notes);

}  // namespace waywright
