// Maps that are drawn: SVG, and floor plans from CAD.
#include <string_view>

#include "waywright/dxf/floor_plan.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/map_kinds.hpp"
#include "waywright/io/map_parts.hpp"
#include "waywright/io/scenario_json.hpp"
#include "waywright/io/svg_map.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_drawing = 1ULL << 30;  // bytes
constexpr std::uint64_t largest_svg = 64ULL << 20;     // bytes

}  // namespace

void read_svg(const MapBeingRead& m, Json& source) {
  const std::string name = m.node.at("svg").file_name();
  const double scale = m.node.has("scale") ? m.node.at("scale").number_above(0.0, 1e6) : 1.0;
  if (m.node.failed() || !count_file(m.node)) return;
  auto text = read_file(m.folder / name, largest_svg);
  if (!text) return fail_by_file(m.node.at("svg"), text.error());
  auto drawing = decode_svg_map(*text, (m.folder / name).string(), scale);
  if (!drawing) return fail_by_file(m.node.at("svg"), drawing.error());
  source["file"] = name;
  source["scale"] = scale;
  add_file(source, fs::path{name}.filename().string(), sha256(*text));
  append(m.map, std::move(*drawing));
}

void read_dxf(const MapBeingRead& m, Json& source) {
  const std::string name = m.node.at("dxf").file_name();
  dxf::Options options;
  if (m.node.has("unit")) options.unit = m.node.at("unit").word({"mm", "cm", "m", "in", "ft"});
  if (m.node.has("obstacle_layers")) {
    for (const Node& layer : m.node.at("obstacle_layers").elements()) options.obstacle_layers.push_back(layer.text());
  }
  if (m.node.has("boundary_layer")) options.boundary_layer = m.node.at("boundary_layer").text();
  if (m.node.has("tolerance")) options.tolerance = m.node.at("tolerance").number(dxf::least_tolerance, dxf::most_tolerance);
  if (m.node.has("closing")) options.closing = m.node.at("closing").number(0.0, dxf::most_closing);
  if (m.node.failed() || !count_file(m.node)) return;
  auto text = read_file(m.folder / name, largest_drawing);
  if (!text) return fail_by_file(m.node.at("dxf"), text.error());
  auto plan = dxf::read_floor_plan(*text, (m.folder / name).string(), options);
  if (!plan) {
    // Its sentences name the option of `map`, whose map object is the outermost one.
    InputError error = plan.error();
    constexpr std::string_view option = "give unit (--unit)";
    if (const std::size_t at = error.problem.find(option); at != std::string::npos && !m.node.path().empty()) error.problem.replace(at, option.size(), "give " + m.node.path() + ".unit");
    return fail_by_file(m.node.at("dxf"), error);
  }
  source["file"] = name;
  for (const char* field : {"unit", "obstacle_layers", "boundary_layer", "tolerance", "closing"}) {
    if (m.node.has(field)) source[field] = m.node.at(field).json();
  }
  add_file(source, fs::path{name}.filename().string(), sha256(*text));
  m.map.boundaries = std::move(plan->boundaries);
  m.map.obstacles = std::move(plan->obstacles);
  m.map.lines = std::move(plan->lines);
  for (std::string& note : plan->notes) m.map.notes.push_back(std::move(note));
}

}  // namespace waywright
