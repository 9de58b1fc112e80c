#include "waywright/io/obstacles_io.hpp"

#include <fmt/format.h>

#include "waywright/io/files.hpp"
#include "waywright/io/map_parts.hpp"
#include "waywright/io/moving_json.hpp"
#include "waywright/io/scenario_json.hpp"

namespace waywright {

Parsed<SeenObstacles> parse_obstacles(const std::string& text, const std::string& name) {
  auto json = parse_json(text, name);
  if (!json) return tl::unexpected{json.error()};
  ReadContext context{name, {}};
  const Node node{*json, "", context};
  SeenObstacles seen;
  check_format(node, "obstacles");
  if (!node.failed() && node.is_object_of({"format", "obstacles", "lines", "points", "moving"})) {
    Json still = Json::object();
    for (const char* part : {"obstacles", "lines", "points"}) {
      if (node.has(part)) still[part] = (*json)[part];
    }
    const Node map{still, "", context};
    read_polygons(map, seen.still, largest_coordinate);
    if (!node.failed()) check_size(map, seen.still);
    if (!node.failed() && node.has("moving")) seen.moving = read_moving(node.at("moving"), seen.still.notes);
    const bool is_empty = seen.still.obstacles.empty() && seen.still.lines.empty() && seen.still.points.empty() && seen.moving.empty();
    if (!node.failed() && is_empty) node.fail("it holds no obstacle", "at least one of obstacles, lines, points, moving");
  }
  if (context.error) return tl::unexpected{*context.error};
  return seen;
}

Parsed<SeenObstacles> read_obstacles(const std::filesystem::path& file) {
  auto text = read_file(file, largest_json);
  if (!text) return tl::unexpected{text.error()};
  return parse_obstacles(*text, file.string());
}

std::string obstacles_json(const SeenObstacles& seen) {
  Json j = polygons_to_json(seen.still);
  Json all{{"format", "waywright-obstacles/1"}};
  for (auto& [field, value] : j.items()) all[field] = value;
  if (!seen.moving.empty()) all["moving"] = moving_to_json(seen.moving);
  return pretty(all);
}

}  // namespace waywright
