// Obstacles that move, as JSON.
#pragma once

#include <string>
#include <vector>

#include "waywright/io/json_reader.hpp"
#include "waywright/scenario/moving_obstacle.hpp"

namespace waywright {

/// An array of {"name", "footprint", "track": [[t, x, y] or [t, x, y, heading], …], "velocity", "spread", "seen", "range", "free_for", "patience"}. What was repaired in a polygon goes
/// into the notes.
std::vector<MovingObstacle> read_moving(const Node& node, std::vector<std::string>& notes);
Json moving_to_json(const std::vector<MovingObstacle>& moving);

}  // namespace waywright
