// scenario.json and vehicle.json.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/dxf/floor_plan.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

/// Reads and checks every field; paths inside are relative to the file.
Parsed<Scenario> read_scenario(const std::filesystem::path& file);
/// The same from text; `name` stands for the file in messages, `folder` is where relative paths start.
Parsed<Scenario> parse_scenario(const std::string& text, const std::string& name, const std::filesystem::path& folder);

Parsed<Vehicle> read_vehicle(const std::filesystem::path& file);

/// What a map of cells needs beside its file, and what becomes of it.
struct CellMapOptions {
  std::optional<double> resolution{};      ///< m a pixel, of a picture alone
  std::optional<double> trace{};           ///< m: polygons in place of the cells, see map/trace
  std::optional<double> trace_relative{};  ///< share of an outline's length
  std::optional<double> dilate{};          ///< m
};

/// A map alone: scenario.json's `map` object in a file of its own, a ROS yaml, a picture (resolution needed), an SVG or DXF drawing, by extension; placed
/// by pairs of points (on the map, in the world) where such are given. Of a DXF `drawing` says what is taken.
/// `record`, where given, receives where it came from, as JSON text (Scenario::map_source).
Parsed<Map> read_map(const std::filesystem::path& file, const std::vector<std::pair<Vec2, Vec2>>& align = {}, const dxf::Options& drawing = {}, std::string* record = nullptr, const CellMapOptions& cells = {});
bool is_dxf(const std::filesystem::path& file);  ///< by its extension
/// What all places of a site share.
struct Site {
  Map map;
  std::string map_source = "{}";  ///< JSON text: as of Scenario
  Vehicle vehicle;
  std::vector<std::string> notes;  ///< what was repaired in both
};
Parsed<Site> read_site(const std::filesystem::path& map, const std::filesystem::path& vehicle);

/// A map.json (polygons and cells inlined), as `map` writes it.
std::string map_json(const Map& map);

/// The scenario as a JSON text that read_scenario accepts: defaults filled in, map inlined.
std::string scenario_json(const Scenario& scenario, int indent = 2);

}  // namespace waywright
