// A scenario's `map` object of any kind.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>

#include "waywright/io/files.hpp"
#include "waywright/io/map_align.hpp"
#include "waywright/io/map_io.hpp"
#include "waywright/io/map_json.hpp"
#include "waywright/io/map_kinds.hpp"
#include "waywright/io/map_parts.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/io/scenario_json.hpp"
#include "waywright/io/vehicle_io.hpp"
#include "waywright/map/lane_graph.hpp"
#include "waywright/map/trace.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

constexpr int most_files_deep = 4;
constexpr int most_files = 256;
constexpr int most_overlays_deep = 8;
constexpr std::size_t deepest_source = 24;      // levels of a record that is carried along
constexpr double largest_raw_coordinate = 1e9;  // m, before a transform: national grids have large ones
constexpr double largest_record = 1e12;         // m, of a transform that was made of several

/// A loading error that speaks of its own file.
void take_over(const Node& node, InputError error) {
  if (!node.failed()) node.context().error = std::move(error);
}

std::optional<Vec2> point_beyond_limits(const Map& map, const LaneGraph& lanes) {
  const auto beyond = [](Vec2 p) { return !(std::abs(p.x) <= largest_coordinate && std::abs(p.y) <= largest_coordinate); };
  for (const auto* lists : {&map.boundaries, &map.obstacles, &map.lines}) {
    for (const auto& list : *lists) {
      if (const auto p = std::find_if(list.begin(), list.end(), beyond); p != list.end()) return *p;
    }
  }
  if (const auto p = std::find_if(map.points.begin(), map.points.end(), beyond); p != map.points.end())
    return *p;
  for (const LanePlace& place : lanes.places) {
    if (beyond(place.at)) return place.at;
  }
  for (const Lane& lane : lanes.lanes) {
    if (const auto p = std::find_if(lane.course.begin(), lane.course.end(), beyond); p != lane.course.end()) return *p;
  }
  for (const CellGrid& grid : map.grids) {
    for (const int c : {0, grid.columns}) {
      for (const int r : {0, grid.rows}) {
        if (const Vec2 p = grid.corner(c, r); beyond(p)) return p;
      }
    }
  }
  return std::nullopt;
}

/// By the field that names the file; polygons and cells stand in the object itself.
constexpr std::array<std::pair<const char*, void (*)(const MapBeingRead&, Json&)>, 8> readers{{{"ros", read_ros},
                                                                                             {"image", read_image},
                                                                                             {"dxf", read_dxf},
                                                                                             {"movingai", read_movingai},
                                                                                             {"generate", read_generated},
                                                                                             {"svg", read_svg},
                                                                                             {"rmf", read_rmf},
                                                                                             {"opentcs",read_opentcs}}};

/// Reads one `map` object.
class MapReader {
 public:
  MapReader(const Node& node, const fs::path& folder, int overlays_deep)
      : node_{node}, folder_{folder}, overlays_deep_{overlays_deep} {}

  Map read(Json& source) {
    if (!check_fields()) return {};
    const bool recorded = node_.has("source");
    if (recorded && !read_source(source)) return {};
    if (!recorded) source = {{"kind", kind_}};
    if (node_.has("notes")) {
      for (const Node& note : node_.at("notes").elements()) map_.notes.push_back(note.text());
    }
    const std::size_t known_notes = map_.notes.size();
    most_ = node_.has("transform") || node_.has("align") ? largest_raw_coordinate : largest_coordinate;

    const MapBeingRead m{node_, folder_, most_, map_, lanes_};
    const auto* kind = std::find_if(readers.begin(), readers.end(), [&](const auto& k) { return kind_ == k.first; });
    if (kind != readers.end()) kind->second(m, source);
    else
      read_inlined(source);
    if (!node_.failed()) trace_cells(source);
    if (!node_.failed()) place(source);
    if (!node_.failed() && node_.has("obstacles")) {
      read_rings(node_.at("obstacles"), map_.obstacles, map_.notes, largest_coordinate);
    }
    if (!node_.failed()) check_limits();
    if (!node_.failed() && node_.has("overlay")) read_overlays(source);
    if (!node_.failed()) check_size(node_, map_);
    if (!recorded || map_.notes.size() > known_notes) {
      if (!map_.notes.empty()) source["notes"] = map_.notes;
    }
    return std::move(map_);
  }
  /// Of the map itself, not of what lies over it.
  LaneGraph take_lanes() { return std::move(lanes_); }

 private:
  bool check_fields() {
    if (!node_.is_object()) {
      node_.fail(fmt::format("it is {}", kind_of(node_.json())), "an object with polygons, cells, ros, image, dxf, movingai, generate, svg, rmf or opentcs");
      return false;
    }
    if (!node_.is_object_of({"polygons", "cells", "ros", "image", "resolution", "origin", "occupied_below",
                             "unknown_is_free", "movingai", "cell", "generate", "dxf", "unit", "obstacle_layers",
                             "boundary_layer", "tolerance", "closing", "svg", "scale", "rmf", "level", "opentcs", "corridor", "margin", "trace", "trace_relative", "dilate", "transform", "align", "overlay", "obstacles", "source",
                             "notes", "alignment"})) {
      return false;
    }
    int kinds = 0;
    for (const auto& [kind, reader] : readers) {
      if (!node_.has(kind)) continue;
      ++kinds;
      kind_ = kind;
    }
    if (node_.has("polygons") || node_.has("cells")) {
      ++kinds;
      kind_ = "polygons";
    }
    if (kinds != 1) {
      node_.fail(kinds == 0 ? "no kind of map is given" : fmt::format("{} kinds of map are given", kinds),
                 "exactly one of polygons (with cells), ros, image, dxf, movingai, generate, svg, rmf, opentcs");
      return false;
    }
    if (kind_ != "dxf" && !has_none_of({"unit", "obstacle_layers", "boundary_layer", "tolerance", "closing"})) return false;
    if (kind_ != "movingai" && kind_ != "opentcs" && kind_ != "rmf" && !has_none_of({"cell"})) return false;
    if (kind_ != "opentcs" && kind_ != "rmf" && !has_none_of({"corridor"})) return false;
    if (kind_ != "opentcs" && !has_none_of({"margin"})) return false;
    if (kind_ != "svg" && !has_none_of({"scale"})) return false;
    if (kind_ != "rmf" && !has_none_of({"level"})) return false;
    if (kind_ == "movingai" || kind_ == "generate" || kind_ == "svg" || kind_ == "rmf" || kind_ == "opentcs") return has_none_of({"resolution", "origin", "occupied_below", "unknown_is_free", "source", "notes", "alignment"});
    if (kind_ == "ros")
      return has_none_of({"resolution", "origin", "occupied_below", "source", "notes", "alignment"});
    if (kind_ == "image") return has_none_of({"unknown_is_free", "source", "notes", "alignment"});
    if (kind_ == "dxf") return has_none_of({"resolution", "origin", "occupied_below", "unknown_is_free", "source", "notes", "alignment"});
    return has_none_of({"resolution", "origin", "occupied_below", "unknown_is_free"});
  }

  /// Fields of other kinds would be ignored silently.
  bool has_none_of(std::initializer_list<const char*> fields) {
    for (const char* field : fields) {
      if (node_.has(field))
        node_.at(field).fail(fmt::format("it does not go with a map of kind {}", kind_), "no such field");
    }
    return !node_.failed();
  }

  bool read_source(Json& source) {
    const Node given = node_.at("source");
    if (!given.is_object()) {
      given.fail(fmt::format("it is {}", kind_of(given.json())), "an object");
    } else if (depth_of(given.json()) > deepest_source) {
      given.fail("it is nested too deeply", fmt::format("at most {} levels", deepest_source));
    } else {
      source = given.json();
    }
    return !node_.failed();
  }

  /// Polygons in place of the cells, in the map's own frame.
  void trace_cells(Json& source) {
    if (!node_.has("trace")) {
      for (const char* field : {"trace_relative", "dilate"}) {
        if (node_.has(field)) node_.at(field).fail("it goes with trace alone", "trace beside it");
      }
      return;
    }
    TraceOptions options;
    options.tolerance = node_.at("trace").number_above(0.0, 1e3);
    if (node_.has("trace_relative")) options.relative = node_.at("trace_relative").number_above(0.0, 1.0);
    if (node_.has("dilate")) options.dilate = node_.at("dilate").number(0.0, 1e3);
    if (!node_.failed() && map_.grids.empty()) node_.at("trace").fail("the map has no cells", "a map of cells: ros, image, movingai, cells or one that is generated of them");
    if (node_.failed()) return;
    for (CellGrid& grid : map_.grids) {
      if (overlays_deep_ > 0) grid.bounds = false;  // an overlay says nothing of what lies outside it
      auto traced = trace(grid, options);
      if (!traced) return node_.at("trace").fail(traced.error().problem, traced.error().allowed);
      map_.notes.push_back((grid.name.empty() ? std::string{"the cells"} : grid.name) + ": " + describe(*traced, options));
      if (grid.bounds && traced->covered == static_cast<std::int64_t>(grid.blocked.size())) {
        map_.notes.push_back(options.dilate > 0.0 ? fmt::format("nothing is free any more: what is blocked, grown by {:g} m, covers all {:g} x {:g} m of the map", options.dilate, grid.columns * grid.cell, grid.rows * grid.cell)
                                                  : std::string{"nothing is free: every cell is blocked"});
      }
      if (traced->boundary) map_.boundaries.push_back(std::move(*traced->boundary));
      map_.obstacles.insert(map_.obstacles.end(), std::make_move_iterator(traced->obstacles.begin()), std::make_move_iterator(traced->obstacles.end()));
    }
    map_.grids.clear();
    for (const char* field : {"trace", "trace_relative", "dilate"}) {
      if (node_.has(field)) source[field] = node_.at(field).json();
    }
  }

  void read_inlined(Json& source) {
    if (node_.has("alignment")) map_.alignment = read_alignment(node_.at("alignment"));
    if (node_.has("polygons")) {
      const Node polygons = node_.at("polygons");
      if (polygons.json().is_string())
        read_named(polygons, source);
      else
        read_polygons(polygons, map_, most_);
    }
    if (node_.failed() || !node_.has("cells")) return;
    for (const Node& cells : node_.at("cells").elements()) {
      map_.grids.push_back(read_cells(cells, most_));
      if (node_.failed()) return;
    }
  }

  static Alignment read_alignment(const Node& node) {
    Alignment alignment;
    if (!node.is_object_of({"transform", "residuals"})) return alignment;
    alignment.transform = node.at("transform").pose(largest_record);
    if (node.has("residuals")) alignment.residuals = node.at("residuals").numbers(0.0, largest_record);
    return alignment;
  }

  /// A map.json: a map object of its own, or just the polygons.
  void read_named(const Node& polygons, Json& source) {
    if (node_.has("source"))
      return polygons.fail("a named map has its own record", "polygons inlined where source is given");
    const std::string name = polygons.file_name();
    if (node_.failed() || !count_file(node_)) return;
    const fs::path path = folder_ / name;
    for (const auto& [extension, what, kind] : {std::tuple{".dxf", "a drawing", "dxf"}, {".yaml", "a ROS map", "ros"}, {".yml", "a ROS map", "ros"}, {".svg", "an SVG drawing", "svg"}, {".xml", "a plant model", "opentcs"}}) {
      if (has_extension(path, extension)) return polygons.fail(fmt::format("{} is {}, not a map.json", name, what), fmt::format("{{\"{}\": \"{}\"}}", kind, name));
    }
    auto text = read_file(path, largest_json);
    if (!text) return fail_by_file(polygons, text.error());
    auto json = parse_json(*text, path.string());
    if (!json) return take_over(node_, json.error());
    ReadContext inner = node_.context();
    inner.file = path.string();
    if (++inner.files_deep > most_files_deep) {
      return polygons.fail("map files name each other in a circle or too deeply",
                           fmt::format("at most {} levels", most_files_deep));
    }
    const Node root{*json, "", inner};
    Json inner_source = Json::object();
    Map named;
    if (is_bare(*json))
      read_polygons(root, named, most_);
    else
      named = MapReader{root, path.parent_path(), overlays_deep_}.read(inner_source);
    node_.context().files_read = inner.files_read;
    node_.context().cells = inner.cells;
    if (inner.error) return take_over(node_, *inner.error);
    source["file"] = name;
    add_file(source, path.filename().string(), sha256(*text));
    if (!inner_source.empty()) source["source"] = std::move(inner_source);
    for (std::string& note : named.notes) note = name + ": " + note;
    map_.alignment = named.alignment;
    append(map_, std::move(named));
  }

  static bool is_bare(const Json& json) {
    const auto any = [&](std::initializer_list<const char*> fields) {
      return json.is_object() &&
             std::any_of(fields.begin(), fields.end(), [&](const char* f) { return json.contains(f); });
    };
    return any({"boundary", "boundaries", "obstacles", "lines", "points"}) &&
           !any({"polygons", "cells", "ros", "image", "dxf", "movingai", "generate", "svg", "rmf", "opentcs"});
  }

  void place(Json& source) {
    if (node_.has("transform") && node_.has("align")) {
      return node_.at("align").fail("both transform and align are given", "one of them");
    }
    Alignment alignment;
    if (node_.has("transform")) {
      alignment.transform = node_.at("transform").pose(largest_raw_coordinate);
    } else if (node_.has("align")) {
      auto found = read_align(node_.at("align"), largest_raw_coordinate, map_.notes);
      if (!found) return;
      alignment = std::move(*found);
    } else {
      return;
    }
    if (node_.failed()) return;
    transform(map_, alignment.transform);
    transform(lanes_, alignment.transform);
    for (std::vector<Ring>* rings : {&map_.boundaries, &map_.obstacles}) {
      for (Ring& ring : *rings) repair_placed(ring);
    }
    // A map that had been placed before is now placed by both.
    if (map_.alignment) alignment.transform = Frame{alignment.transform}.to_world(map_.alignment->transform);
    source["transform"] = to_json(alignment.transform);
    if (!alignment.residuals.empty()) source["align_residuals"] = alignment.residuals;
    map_.alignment = std::move(alignment);
  }

  /// Corners that rounding brings together, or edges that it makes cross, are found here and not by whoever
  /// reads the map again.
  void repair_placed(Ring& ring) {
    RingRepair repair = repair_ring(std::move(ring));
    if (repair.refused)
      node_.fail("in the world frame " + *repair.refused, "polygons that stay simple when they are moved");
    for (const std::string& mended : repair.mended)
      map_.notes.push_back(node_.path() + ": in the world frame " + mended);
    ring = std::move(repair.ring);
  }

  void check_limits() {
    if (const auto p = point_beyond_limits(map_, lanes_)) {
      node_.fail(fmt::format("it reaches ({:g}, {:g}) in the world frame", p->x, p->y),
                 fmt::format("coordinates within {:g} m after the transform", largest_coordinate));
    }
  }

  void read_overlays(Json& source) {
    const Node overlays = node_.at("overlay");
    if (overlays_deep_ >= most_overlays_deep) {
      return overlays.fail("overlays are nested too deeply",
                           fmt::format("at most {} levels", most_overlays_deep));
    }
    Json records =
        source.contains("overlay") && source["overlay"].is_array() ? source["overlay"] : Json::array();
    for (const Node& over : overlays.elements()) {
      Json record = Json::object();
      Map more = MapReader{over, folder_, overlays_deep_ + 1}.read(record);
      if (node_.failed()) return;
      for (CellGrid& grid : more.grids)
        grid.bounds = false;  // an overlay says nothing of what lies outside it
      records.push_back(std::move(record));
      append(map_, std::move(more));
    }
    if (!records.empty()) source["overlay"] = std::move(records);
  }

  const Node& node_;
  const fs::path& folder_;
  int overlays_deep_;
  LaneGraph lanes_;
  std::string kind_;
  double most_ = largest_coordinate;
  Map map_;
};

}  // namespace

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

bool count_file(const Node& node) {
  if (++node.context().files_read <= most_files) return true;
  node.fail("too many map files are named", fmt::format("at most {} in all", most_files));
  return false;
}

void add_file(Json& source, const std::string& name, const std::string& hash) {
  source["files"].push_back({{"name", name}, {"sha256", hash}});
}

Map read_map_node(const Node& node, const fs::path& folder, Json& source, LaneGraph* lanes) {
  MapReader reader{node, folder, 0};
  Map map = reader.read(source);
  if (lanes != nullptr) *lanes = reader.take_lanes();
  return map;
}

}  // namespace waywright
