#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "waywright/io/json_reader.hpp"
#include "waywright/vehicle/vehicle.hpp"

namespace waywright {

/// `notes` receives what was repaired.
Vehicle read_vehicle_node(const Node& node, std::vector<std::string>& notes);
/// The vehicle in a file of its own, named `name` in the notes.
Parsed<Vehicle> read_vehicle_file(const std::filesystem::path& file, const std::string& name,
                                  std::vector<std::string>& notes);
Json vehicle_to_json(const Vehicle& vehicle);

/// A polygon of at most 500 corners or {"disc": radius}, nothing of it farther than `reach` m from its origin.
Footprint read_footprint(const Node& node, std::vector<std::string>& notes, double reach = 1e3);
Json footprint_to_json(const Footprint& footprint);

/// A polygon of corners within ±most, repaired where that is safe; `notes` receives what was mended, with the
/// field's name.
Ring read_ring(const Node& node, std::vector<std::string>& notes, double most = largest_coordinate);

Json to_json(Vec2 p);
Json to_json(const Pose& p);
Json to_json(const std::vector<Vec2>& points);

}  // namespace waywright
