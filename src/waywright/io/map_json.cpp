#include "waywright/io/map_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/io/files.hpp"
#include "waywright/io/map_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/io/vehicle_io.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_json = 256ULL << 20;
constexpr std::int64_t most_cells = 1LL << 28;
constexpr int most_files_deep = 4;

std::vector<Vec2> read_points(const Node& node) {
  std::vector<Vec2> points;
  for (const Node& p : node.elements()) {
    points.push_back(p.point());
    if (node.failed()) return {};
  }
  return points;
}

void read_polygons(const Node& node, Map& map) {
  if (!node.is_object_of({"boundary", "boundaries", "obstacles", "lines", "points"})) return;
  if (node.has("boundary")) map.boundaries.push_back(read_ring(node.at("boundary"), map.notes));
  if (node.has("boundaries")) {
    for (const Node& ring : node.at("boundaries").elements()) {
      map.boundaries.push_back(read_ring(ring, map.notes));
      if (node.failed()) return;
    }
  }
  if (node.has("obstacles")) {
    for (const Node& ring : node.at("obstacles").elements()) {
      map.obstacles.push_back(read_ring(ring, map.notes));
      if (node.failed()) return;
    }
  }
  if (node.has("lines")) {
    for (const Node& line : node.at("lines").elements()) {
      map.lines.push_back(read_points(line));
      if (node.failed()) return;
      if (map.lines.back().size() < 2) line.fail("a line needs at least two points");
    }
  }
  if (node.has("points")) map.points = read_points(node.at("points"));
}

/// Run lengths: value, count, value, count, … row by row from the top.
CellGrid read_cells(const Node& node) {
  CellGrid grid;
  if (!node.is_object_of({"name", "columns", "rows", "cell", "origin", "bounds", "runs"})) return grid;
  if (node.has("name")) grid.name = node.at("name").text();
  grid.columns = static_cast<int>(node.at("columns").integer(1, 1 << 20));
  grid.rows = static_cast<int>(node.at("rows").integer(1, 1 << 20));
  grid.cell = node.at("cell").number_above(0.0, 1e3);
  grid.origin = node.at("origin").pose();
  if (node.has("bounds")) grid.bounds = node.at("bounds").boolean();
  const Node runs = node.at("runs");
  if (node.failed()) return grid;
  const std::int64_t cells = static_cast<std::int64_t>(grid.columns) * grid.rows;
  if (cells > most_cells) {
    node.fail(fmt::format("{} × {} cells", grid.columns, grid.rows), fmt::format("at most {} cells", most_cells));
    return grid;
  }
  std::int64_t covered = 0;
  const Json& list = runs.json();
  if (!list.is_array() || list.size() % 2 != 0) {
    runs.fail("it is not a list of values and counts", "[value, count, value, count, …]");
    return grid;
  }
  for (std::size_t i = 0; i + 1 < list.size(); i += 2) {
    runs.at(i).integer(0, 2);
    covered += runs.at(i + 1).integer(1, cells);
    if (node.failed()) return grid;
    if (covered > cells) break;
  }
  if (covered != cells) {
    runs.fail(fmt::format("the runs cover {} cells", covered), fmt::format("{} columns × {} rows", grid.columns, grid.rows));
    return grid;
  }
  grid.blocked.reserve(static_cast<std::size_t>(cells));
  for (std::size_t i = 0; i + 1 < list.size(); i += 2) {
    grid.blocked.insert(grid.blocked.end(), list[i + 1].get<std::size_t>(), static_cast<std::uint8_t>(list[i].get<int>()));
  }
  return grid;
}

Json cells_to_json(const CellGrid& grid) {
  Json runs = Json::array();
  for (std::size_t i = 0; i < grid.blocked.size();) {
    std::size_t end = i;
    while (end < grid.blocked.size() && grid.blocked[end] == grid.blocked[i]) ++end;
    runs.push_back(grid.blocked[i]);
    runs.push_back(end - i);
    i = end;
  }
  return {{"name", grid.name}, {"columns", grid.columns}, {"rows", grid.rows}, {"cell", grid.cell},
          {"origin", to_json(grid.origin)}, {"bounds", grid.bounds}, {"runs", std::move(runs)}};
}

/// A loading error that speaks of its own file.
void take_over(const Node& node, InputError error) {
  if (!node.context().error) node.context().error = std::move(error);
}

void record_files(Json& source, const LoadedGrid& loaded) {
  for (const MapFile& file : loaded.files) {
    source["files"].push_back({{"name", fs::path{file.path}.filename().string()}, {"sha256", file.sha256}});
  }
}

void read_named_map(const Node& node, const fs::path& folder, Map& map, Json& source) {
  const fs::path path = folder / node.text();
  auto text = read_file(path, largest_json);
  if (!text) return take_over(node, text.error());
  auto json = parse_json(*text, path.string());
  if (!json) return take_over(node, json.error());
  ReadContext inner{path.string(), {}, node.context().files_deep + 1};
  if (inner.files_deep > most_files_deep) return node.fail("map files name each other in a circle or too deeply");
  Json inner_source;
  Map named = read_map_node(Node{*json, "", inner}, path.parent_path(), inner_source);
  if (inner.error) return take_over(node, *inner.error);
  source["files"].push_back({{"name", path.filename().string()}, {"sha256", sha256(*text)}});
  map = std::move(named);
}

void append(Map& map, Map more) {
  const auto move_all = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  move_all(map.boundaries, more.boundaries);
  move_all(map.obstacles, more.obstacles);
  move_all(map.lines, more.lines);
  move_all(map.points, more.points);
  move_all(map.grids, more.grids);
  move_all(map.notes, more.notes);
}

void check_limits(const Node& node, const Map& map) {
  const auto check = [&](Vec2 p) {
    if (std::max(std::abs(p.x), std::abs(p.y)) > largest_coordinate) {
      node.fail(fmt::format("after the transform a point lies at ({:g}, {:g})", p.x, p.y), "coordinates within 1e6 m");
    }
  };
  for (const auto* rings : {&map.boundaries, &map.obstacles, &map.lines}) {
    for (const auto& ring : *rings) std::for_each(ring.begin(), ring.end(), check);
  }
  std::for_each(map.points.begin(), map.points.end(), check);
  for (const CellGrid& grid : map.grids) {
    for (const int c : {0, grid.columns}) {
      for (const int r : {0, grid.rows}) check(grid.corner(c, r));
    }
  }
}

void place(const Node& node, Map& map, Json& source) {
  if (node.has("transform") && node.has("align")) return node.fail("both transform and align are given", "one of them");
  Alignment alignment;
  if (node.has("transform")) {
    alignment.transform = node.at("transform").pose();
  } else if (node.has("align")) {
    std::vector<Vec2> from, to;
    for (const Node& pair : node.at("align").elements()) {
      if (!pair.is_array_of(2, "[[x, y] on the map, [x, y] in the world]")) return;
      from.push_back(pair.at(std::size_t{0}).point());
      to.push_back(pair.at(1).point());
    }
    if (node.failed()) return;
    auto found = align(from, to);
    if (!found) return node.at("align").fail(found.error().problem, found.error().allowed);
    alignment = *found;
    source["align_residuals"] = alignment.residuals;
  } else {
    return;
  }
  if (node.failed()) return;
  source["transform"] = to_json(alignment.transform);
  transform(map, alignment.transform);
  map.alignment = alignment;
  check_limits(node, map);
}

}  // namespace

Map read_map_node(const Node& node, const fs::path& folder, Json& source) {
  Map map;
  if (!node.is_object_of({"polygons", "cells", "ros", "image", "resolution", "origin", "occupied_below", "unknown_is_free", "dxf",
                          "unit", "obstacle_layers", "boundary_layer", "movingai", "cell", "generate", "seed", "transform", "align",
                          "overlay", "obstacles", "source", "notes"})) {
    return map;
  }
  int kinds = 0;
  for (const char* kind : {"ros", "image", "dxf", "movingai", "generate"}) kinds += node.has(kind) ? 1 : 0;
  kinds += node.has("polygons") || node.has("cells") ? 1 : 0;
  if (kinds != 1) {
    node.fail(fmt::format("{} kinds of map are given", kinds), "exactly one of polygons (with cells), ros, image");
    return map;
  }
  for (const char* later : {"dxf", "movingai", "generate"}) {
    if (node.has(later)) {
      node.at(later).fail("this kind of map is not supported yet", "polygons, cells, ros, image");
      return map;
    }
  }
  if (node.has("source")) source = node.at("source").json();
  const bool unknown_is_free = node.has("unknown_is_free") && node.at("unknown_is_free").boolean();

  if (node.has("ros")) {
    source["kind"] = "ros";
    source["file"] = node.at("ros").text();
    if (node.failed()) return map;
    auto loaded = load_ros_map(folder / node.at("ros").text(), unknown_is_free);
    if (!loaded) {
      take_over(node, loaded.error());
      return map;
    }
    record_files(source, *loaded);
    map.grids.push_back(std::move(loaded->grid));
  } else if (node.has("image")) {
    source["kind"] = "image";
    source["file"] = node.at("image").text();
    const double resolution = node.at("resolution").number_above(0.0, 1e3);
    const Pose origin = node.has("origin") ? node.at("origin").pose() : Pose{};
    const double below = node.has("occupied_below") ? node.at("occupied_below").number(0.0, 1.0) : 0.5;
    if (node.failed()) return map;
    auto loaded = load_image_map(folder / node.at("image").text(), resolution, origin, below);
    if (!loaded) {
      take_over(node, loaded.error());
      return map;
    }
    record_files(source, *loaded);
    map.grids.push_back(std::move(loaded->grid));
  } else {
    if (!source.contains("kind")) source["kind"] = "polygons";
    if (node.has("polygons")) {
      const Node polygons = node.at("polygons");
      if (polygons.json().is_string()) {
        source["file"] = polygons.text();
        read_named_map(polygons, folder, map, source);
      } else {
        read_polygons(polygons, map);
      }
    }
    if (node.has("cells")) {
      for (const Node& cells : node.at("cells").elements()) {
        map.grids.push_back(read_cells(cells));
        if (node.failed()) return map;
      }
    }
  }
  if (node.failed()) return map;
  if (node.has("notes")) {
    for (const Node& note : node.at("notes").elements()) map.notes.push_back(note.text());
  }
  place(node, map, source);
  if (node.has("obstacles")) {
    for (const Node& ring : node.at("obstacles").elements()) {
      map.obstacles.push_back(read_ring(ring, map.notes));
      if (node.failed()) return map;
    }
  }
  if (node.has("overlay")) {
    for (const Node& over : node.at("overlay").elements()) {
      Json over_source = Json::object();
      Map more = read_map_node(over, folder, over_source);
      if (node.failed()) return map;
      for (CellGrid& grid : more.grids) grid.bounds = false;  // an overlay says nothing of what lies outside it
      source["overlay"].push_back(std::move(over_source));
      append(map, std::move(more));
    }
  }
  return map;
}

Json map_to_json(const Map& map) {
  Json polygons = Json::object();
  if (!map.boundaries.empty()) {
    if (map.boundaries.size() == 1) {
      polygons["boundary"] = to_json(map.boundaries.front());
    } else {
      for (const Ring& ring : map.boundaries) polygons["boundaries"].push_back(to_json(ring));
    }
  }
  for (const Ring& ring : map.obstacles) polygons["obstacles"].push_back(to_json(ring));
  for (const Polyline& line : map.lines) polygons["lines"].push_back(to_json(line));
  if (!map.points.empty()) polygons["points"] = to_json(map.points);
  Json j{{"polygons", std::move(polygons)}};
  for (const CellGrid& grid : map.grids) j["cells"].push_back(cells_to_json(grid));
  if (!map.notes.empty()) j["notes"] = map.notes;
  return j;
}

Parsed<Map> read_map(const fs::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".yaml" || extension == ".yml") {
    auto loaded = load_ros_map(file, false);
    if (!loaded) return tl::unexpected{loaded.error()};
    Map map;
    map.grids.push_back(std::move(loaded->grid));
    map.notes = std::move(loaded->notes);
    return map;
  }
  if (extension == ".dxf") {
    return tl::unexpected{InputError{file.string(), "", "DXF maps are not supported yet", "map.json, ROS yaml"}};
  }
  if (extension == ".pgm" || extension == ".png") {
    return tl::unexpected{InputError{file.string(), "", "a bare picture has no scale", "a ROS yaml, or a map.json with image and resolution"}};
  }
  auto text = read_file(file, largest_json);
  if (!text) return tl::unexpected{text.error()};
  auto json = parse_json(*text, file.string());
  if (!json) return tl::unexpected{json.error()};
  ReadContext context{file.string(), {}, 0};
  Json source;
  Map map = read_map_node(Node{*json, "", context}, file.parent_path(), source);
  if (context.error) return tl::unexpected{*context.error};
  return map;
}

}  // namespace waywright
