#include "waywright/io/map_json.hpp"

#include "waywright/io/files.hpp"
#include "waywright/io/lane_map_io.hpp"
#include "waywright/io/map_parts.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/io/scenario_json.hpp"
#include "waywright/io/vehicle_io.hpp"

namespace waywright {

namespace fs = std::filesystem;

Json map_to_json(const Map& map) {
  Json j{{"polygons", polygons_to_json(map)}};
  if (!map.grids.empty()) {
    Json grids = Json::array();
    for (const CellGrid& grid : map.grids) grids.push_back(cells_to_json(grid));
    j["cells"] = std::move(grids);
  }
  if (map.alignment)
    j["alignment"] = {{"transform", to_json(map.alignment->transform)},
                      {"residuals", map.alignment->residuals}};
  if (!map.notes.empty()) j["notes"] = map.notes;
  return j;
}

std::string map_json(const Map& map) { return pretty(map_to_json(map)); }

bool is_dxf(const fs::path& file) { return has_extension(file, ".dxf"); }

namespace {

Parsed<Map> read_any(const fs::path& file, const std::vector<std::pair<Vec2, Vec2>>& align, const dxf::Options& drawing, std::string* record, const CellMapOptions& cells, const FreeAlongLanes& lanes_free, LaneGraph* lanes) {
  const auto refuse = [&](const char* problem, const char* allowed) {
    return tl::unexpected{InputError{file.string(), "", problem, allowed}};
  };
  const std::string extension = file.extension().string();
  const bool is_picture = has_extension(file, ".pgm") || has_extension(file, ".png");
  if (is_picture && !cells.resolution) return refuse("a picture alone has no scale", "a ROS yaml, a map.json with image and resolution, or `map --resolution`");
  if (!is_picture && cells.resolution) return refuse("it is no picture, and has a scale of its own", "no resolution");
  // A map object that names the file, or that lies in it: the same reading and checks as in a scenario.
  const bool is_building = file.filename().string().ends_with(".building.yaml");
  const bool yaml = !is_building && (extension == ".yaml" || extension == ".yml");
  const bool is_drawing = is_dxf(file);
  const bool is_movingai = extension == ".map";
  const bool is_svg = has_extension(file, ".svg");
  const bool is_plant = has_extension(file, ".xml");
  if (!is_plant && !is_building && lanes_free.corridor) return refuse("it has no lanes that could be all that is free", "--corridor with an openTCS plant model (.xml) or an Open-RMF building (.building.yaml)");
  if (!is_plant && lanes_free.margin) return refuse("it is no plant model: what is free is drawn in it", "--margin with an openTCS plant model (.xml)");
  Json named{{yaml ? "ros" : is_picture ? "image" : is_svg ? "svg" : is_plant ? "opentcs" : is_building ? "rmf" : is_drawing ? "dxf" : is_movingai ? "movingai" : "polygons", file.filename().string()}};
  if (is_movingai) named["cell"] = 1.0;  // the format has no scale
  if (is_picture) named["resolution"] = *cells.resolution;
  if (is_drawing) {
    if (!drawing.unit.empty()) named["unit"] = drawing.unit;
    if (!drawing.obstacle_layers.empty()) named["obstacle_layers"] = drawing.obstacle_layers;
    if (!drawing.boundary_layer.empty()) named["boundary_layer"] = drawing.boundary_layer;
    named["tolerance"] = drawing.tolerance;
    named["closing"] = drawing.closing;
  }
  for (const auto& [field, value] : {std::pair{"corridor", lanes_free.corridor}, std::pair{"margin", lanes_free.margin}, std::pair{"trace", cells.trace}, std::pair{"trace_relative", cells.trace_relative}, std::pair{"dilate", cells.dilate}}) {
    if (value) named[field] = *value;
  }
  for (const auto& [from, to] : align) named["align"].push_back(Json::array({to_json(from), to_json(to)}));
  ReadContext context{"", {}};
  Json source;
  Map map = read_map_node(Node{named, "", context}, file.parent_path(), source, lanes);
  if (record != nullptr) *record = source.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (!context.error) return map;
  InputError error = *context.error;
  const bool is_map_json = !yaml && !is_picture && !is_svg && !is_plant && !is_building && !is_drawing && !is_movingai;
  if (is_map_json && !has_extension(file, ".json") && error.problem.starts_with("not valid JSON")) {
    return refuse("it is of no kind that is read as a map", "a ROS map or an Open-RMF building (.yaml, .building.yaml), a picture (.png, .pgm), a map.json (.json), a floor plan (.dxf), a drawing (.svg), a MovingAI map (.map), an openTCS plant model (.xml)");
  }
  if (error.field == "ros" || error.field == "polygons" || error.field == "dxf" || error.field == "movingai" || error.field == "image" || error.field == "svg" || error.field == "rmf" || error.field == "opentcs") error.field.clear();  // of the object made here, which names the file itself
  else if (error.file.empty()) error.file = file.string();
  return tl::unexpected{error};
}

}  // namespace

Parsed<Map> read_map(const fs::path& file, const std::vector<std::pair<Vec2, Vec2>>& align, const dxf::Options& drawing, std::string* record, const CellMapOptions& cells) {
  return read_any(file, align, drawing, record, cells, {}, nullptr);
}

Parsed<LaneMap> read_lane_map(const fs::path& file, const std::vector<std::pair<Vec2, Vec2>>& align, const FreeAlongLanes& lanes_free, std::string* record, const dxf::Options& drawing, const CellMapOptions& cells) {
  LaneMap read;
  auto map = read_any(file, align, drawing, record, cells, lanes_free, &read.lanes);
  if (!map) return tl::unexpected{map.error()};
  read.map = std::move(*map);
  return read;
}

}  // namespace waywright
