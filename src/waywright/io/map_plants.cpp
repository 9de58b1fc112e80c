// Maps with lanes: Open-RMF buildings, openTCS plant models.
#include <fmt/format.h>

#include <optional>
#include <utility>

#include "waywright/io/files.hpp"
#include "waywright/io/lane_map_io.hpp"
#include "waywright/io/map_kinds.hpp"
#include "waywright/io/map_parts.hpp"
#include "waywright/io/opentcs_map.hpp"
#include "waywright/io/rmf_map.hpp"
#include "waywright/io/scenario_json.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_building = 16ULL << 20;  // bytes
constexpr std::uint64_t largest_plant = 64ULL << 20;     // bytes

struct CorridorAsked {
  double width = 0.0, cell = 0.0;  // m; of a cell 0: by the width
};
std::optional<CorridorAsked> read_corridor(const MapBeingRead& m) {
  if (m.node.has("cell") && !m.node.has("corridor")) m.node.at("cell").fail("it goes with corridor alone", "corridor beside it");
  if (m.node.failed() || !m.node.has("corridor")) return std::nullopt;
  CorridorAsked corridor;
  corridor.width = m.node.at("corridor").number_above(0.0, 1e3);
  if (m.node.has("cell")) corridor.cell = m.node.at("cell").number_above(0.0, 1e3);
  return corridor;
}
/// Strips along lanes as all that is free, beside what else the map holds.
void add_corridors(const MapBeingRead& m, const CorridorAsked& corridor, const LaneGraph& lanes, const std::string& short_name, Json& source) {
  const double cell = corridor.cell > 0.0 ? corridor.cell : lanes.empty() ? corridor.width : corridor_cell(lanes, corridor.width);
  auto grid = lane_corridors(lanes, corridor.width, cell);
  if (!grid) return m.node.at("corridor").fail(grid.error().problem, grid.error().allowed);
  if (!count_cells(m.node, grid->columns, grid->rows)) return;
  grid->name = short_name;
  m.map.notes.push_back(fmt::format("nothing is free but strips {:g} m across along the lanes, as cells of {:g} m", corridor.width, cell));
  m.map.grids.push_back(std::move(*grid));
  source["corridor"] = corridor.width;
  source["cell"] = cell;
}

}  // namespace

void read_rmf(const MapBeingRead& m, Json& source) {
  const std::string name = m.node.at("rmf").file_name();
  const std::string level = m.node.has("level") ? m.node.at("level").text() : std::string{};
  const std::optional<CorridorAsked> corridor = read_corridor(m);
  if (m.node.failed() || !count_file(m.node)) return;
  auto text = read_file(m.folder / name, largest_building);
  if (!text) return fail_by_file(m.node.at("rmf"), text.error());
  auto walls = decode_rmf_map(*text, (m.folder / name).string(), level, &m.lanes);
  if (!walls) return fail_by_file(m.node.at("rmf"), walls.error());
  source["file"] = name;
  if (!level.empty()) source["level"] = level;
  add_file(source, fs::path{name}.filename().string(), sha256(*text));
  append(m.map, std::move(*walls));
  if (corridor) add_corridors(m, *corridor, m.lanes, fs::path{name}.filename().string(), source);
}

/// A plant model knows no obstacles: what is free is said beside it.
void read_opentcs(const MapBeingRead& m, Json& source) {
  const std::string name = m.node.at("opentcs").file_name();
  const std::optional<CorridorAsked> corridor = read_corridor(m);
  const double margin = m.node.has("margin") ? m.node.at("margin").number_above(0.0, 1e5) : usual_margin;
  if (corridor && m.node.has("margin")) m.node.at("margin").fail("it does not go with corridor, which says all that is free", "one of them");
  if (m.node.failed() || !count_file(m.node)) return;
  auto text = read_file(m.folder / name, largest_plant);
  if (!text) return fail_by_file(m.node.at("opentcs"), text.error());
  auto plant = decode_opentcs_map(*text, (m.folder / name).string());
  if (!plant) return fail_by_file(m.node.at("opentcs"), plant.error());
  std::vector<std::string>& notes = m.map.notes;
  notes.insert(notes.end(), plant->notes.begin(), plant->notes.end());
  const std::string short_name = fs::path{name}.filename().string();
  source["file"] = name;
  if (corridor) {
    add_corridors(m, *corridor, plant->lanes, short_name, source);
    if (m.node.failed()) return;
  } else {
    const Box box = bounding_box(plant->lanes);
    m.map.boundaries.push_back(rectangle(box.low - Vec2{margin, margin}, box.high + Vec2{margin, margin}));
    notes.push_back(fmt::format("a plant model has no walls: all is free up to {:g} m around its places and lanes (margin); corridor makes strips along the lanes all that is free", margin));
    source["margin"] = margin;
  }
  add_file(source, short_name, sha256(*text));
  append(m.lanes, std::move(plant->lanes));
}

}  // namespace waywright
