// obstacles.json: what appears while a plan is driven.
#pragma once

#include <filesystem>
#include <string>

#include "waywright/core/result.hpp"
#include "waywright/scenario/seen_obstacles.hpp"

namespace waywright {

/// {"format": "waywright-obstacles/1", "obstacles", "lines", "points", "moving"}, each part optional, one needed.
Parsed<SeenObstacles> read_obstacles(const std::filesystem::path& file);
Parsed<SeenObstacles> parse_obstacles(const std::string& text, const std::string& name);

/// The same as a text that parse_obstacles accepts.
std::string obstacles_json(const SeenObstacles& seen);

}  // namespace waywright
