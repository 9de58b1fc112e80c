#pragma once

#include "waywright/io/json_reader.hpp"
#include "waywright/vehicle/vehicle.hpp"

namespace waywright {

/// `notes` receives what was repaired.
Vehicle read_vehicle_node(const Node& node, std::vector<std::string>& notes);
Json vehicle_to_json(const Vehicle& vehicle);

/// A polygon of corners, repaired where that is safe.
Ring read_ring(const Node& node, std::vector<std::string>& notes);

Json to_json(Vec2 p);
Json to_json(const Pose& p);
Json to_json(const std::vector<Vec2>& points);

}  // namespace waywright
