// Maps of cells: ROS, pictures, MovingAI, and what is generated.
#include <fmt/format.h>

#include "waywright/core/spelling.hpp"
#include "waywright/io/map_io.hpp"
#include "waywright/io/map_kinds.hpp"
#include "waywright/io/map_parts.hpp"
#include "waywright/io/scenario_json.hpp"
#include "waywright/io/vehicle_io.hpp"
#include "waywright/map/field_worlds.hpp"
#include "waywright/map/published_maps.hpp"
#include "waywright/map/whale_maps.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

void take_grid(const MapBeingRead& m, const Node& name, Parsed<LoadedGrid> loaded, Json& source) {
  if (!loaded) return fail_by_file(name, loaded.error());
  if (!count_cells(m.node, loaded->grid.columns, loaded->grid.rows)) return;
  // The files' names without their folders: the record is the same wherever the scenario lies.
  for (const MapFile& file : loaded->files)
    add_file(source, fs::path{file.path}.filename().string(), file.sha256);
  m.map.grids.push_back(std::move(loaded->grid));
  m.map.notes.insert(m.map.notes.end(), loaded->notes.begin(), loaded->notes.end());
}

}  // namespace

void read_ros(const MapBeingRead& m, Json& source) {
  const std::string name = m.node.at("ros").file_name();
  const bool unknown_is_free = m.node.has("unknown_is_free") && m.node.at("unknown_is_free").boolean();
  if (m.node.failed() || !count_file(m.node)) return;
  source["file"] = name;
  if (m.node.has("unknown_is_free")) source["unknown_is_free"] = unknown_is_free;
  take_grid(m, m.node.at("ros"), load_ros_map(m.folder / name, unknown_is_free), source);
}

void read_image(const MapBeingRead& m, Json& source) {
  const std::string name = m.node.at("image").file_name();
  const double resolution = m.node.at("resolution").number_above(0.0, 1e3);
  const Pose origin = m.node.has("origin") ? m.node.at("origin").pose(m.most) : Pose{};
  const double below = m.node.has("occupied_below") ? m.node.at("occupied_below").number(0.0, 1.0) : 0.5;
  if (m.node.failed() || !count_file(m.node)) return;
  source["file"] = name;
  source["resolution"] = resolution;
  source["origin"] = to_json(origin);
  source["occupied_below"] = below;
  take_grid(m, m.node.at("image"), load_image_map(m.folder / name, resolution, origin, below), source);
}

void read_movingai(const MapBeingRead& m, Json& source) {
  const std::string name = m.node.at("movingai").file_name();
  const double cell = m.node.at("cell").number_above(0.0, 1e3);
  if (m.node.failed() || !count_file(m.node)) return;
  source["file"] = name;
  source["cell"] = cell;
  take_grid(m, m.node.at("movingai"), load_movingai_map(m.folder / name, cell), source);
}

/// Cells and polygons are inlined in plans, so that no plan depends on what a later version would make.
void read_generated(const MapBeingRead& m, Json& source) {
  const Node node = m.node.at("generate");
  const std::string name = node.text();
  if (node.failed()) return;
  if (auto hall = whale_map(name)) {
    source["name"] = name;
    append(m.map, std::move(hall->map));
    return;
  }
  if (auto world = field_world(name)) {
    source["name"] = name;
    append(m.map, std::move(world->map));
    return;
  }
  auto made = published_map(name);
  if (!made) {
    std::vector<std::string> names;
    for (const auto* all : {&published_map_names(), &whale_map_names(), &field_world_names()}) names.insert(names.end(), all->begin(), all->end());
    return node.fail(fmt::format("\"{}\" is not known{}", shortened(name), meant_instead(name, names)), list_of_words(names));
  }
  if (!count_cells(m.node, made->grid.columns, made->grid.rows)) return;
  source["name"] = name;
  m.map.grids.push_back(std::move(made->grid));
}

}  // namespace waywright
