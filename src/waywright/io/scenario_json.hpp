#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "waywright/io/json_reader.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

/// Of missions with waypoints that name no planner.
inline constexpr const char* planner_through_waypoints = "waypoint_clothoid";
/// Of missions to goals that leave the heading free, and to goal poses where the vehicle turns on the spot and has no forks: nothing there docks.
inline constexpr const char* planner_to_goals = "astar";

/// The planner of a mission, or of a leg, that names none.
std::string usual_planner(const Mission& mission, const std::vector<Vec2>& waypoints, const Vehicle& vehicle);

/// The whole scenario object; what is wrong is in the context. Paths in it are relative to `folder`. With `site` the object names no map and
/// no vehicle: the vehicle, the notes and the map's record are the site's, and the scenario's map holds nothing but the notes. `noted`: what is
/// known of it already, for its notes.
Scenario read_scenario_node(const Node& node, const std::filesystem::path& folder, const Site* site = nullptr, const std::vector<std::string>& noted = {});
Json scenario_to_json(const Scenario& scenario);

/// An angle that is read in radians and is more than a whole turn: what it is taken for, and what it would be as degrees. Such angles are wrapped, as
/// asked for, but hardly anybody means that.
std::optional<std::string> heading_doubt(double radians);

/// Of a map that is a drawing: the closed outlines that a start lies inside of. They are solid, and one of them may be that of a room.
std::vector<std::string> outline_doubts(const Map& drawing, Vec2 start);

/// A planner's parameters: every member of the object but `name`.
Parameters read_parameters(const Node& node);
/// The parameters as an object; `name`, where given, stands before them.
Json parameters_to_json(const Parameters& parameters, const std::string* name = nullptr);

/// Checks `format` ("waywright-<what>/1"): a newer number gets its own sentence.
void check_format(const Node& node, const char* what);

/// Text of a JSON value: objects one field a line, arrays of plain values or points on one line. Numbers have
/// the fewest digits that read back to the same bits; one that is not finite becomes null.
std::string pretty(const Json& json, int indent = 2);

}  // namespace waywright
