#include "waywright/io/map_parts.hpp"

#include <fmt/format.h>

#include "waywright/io/vehicle_io.hpp"

namespace waywright {
namespace {

constexpr std::int64_t most_cells = 1LL << 29;    // of all grids of a scenario: two of the largest pictures
constexpr std::int64_t longest_side = 1LL << 20;  // cells
// Of polygons, lines, points and the outlines of blocked cells; and of runs of equal cells in all grids. Three and two values each in a
// plan file: with the most samples there may be, a plan of the largest map can still be read.
constexpr std::size_t most_edges = 2'000'000;
constexpr std::size_t most_runs = 2'000'000;

}  // namespace

void read_rings(const Node& node, std::vector<Ring>& rings, std::vector<std::string>& notes, double most) {
  for (const Node& ring : node.elements()) {
    rings.push_back(read_ring(ring, notes, most));
    if (node.failed()) return;
  }
}

void read_polygons(const Node& node, Map& map, double most) {
  if (!node.is_object_of({"boundary", "boundaries", "obstacles", "lines", "points"})) return;
  if (node.has("boundary")) map.boundaries.push_back(read_ring(node.at("boundary"), map.notes, most));
  if (node.has("boundaries")) read_rings(node.at("boundaries"), map.boundaries, map.notes, most);
  if (node.failed()) return;
  if (node.has("obstacles")) read_rings(node.at("obstacles"), map.obstacles, map.notes, most);
  if (node.has("lines")) {
    for (const Node& line : node.at("lines").elements()) {
      map.lines.push_back(line.points(most));
      if (node.failed()) return;
      if (map.lines.back().size() < 2)
        return line.fail("a line of fewer than two points", "at least two points [x, y]");
    }
  }
  if (node.has("points")) map.points = node.at("points").points(most);
}

Json polygons_to_json(const Map& map) {
  Json j = Json::object();
  const auto all = [](const std::vector<std::vector<Vec2>>& lists) {
    Json array = Json::array();
    for (const auto& list : lists) array.push_back(to_json(list));
    return array;
  };
  if (map.boundaries.size() == 1) j["boundary"] = to_json(map.boundaries.front());
  if (map.boundaries.size() > 1) j["boundaries"] = all(map.boundaries);
  if (!map.obstacles.empty()) j["obstacles"] = all(map.obstacles);
  if (!map.lines.empty()) j["lines"] = all(map.lines);
  if (!map.points.empty()) j["points"] = to_json(map.points);
  return j;
}

bool has_extension(const std::filesystem::path& file, std::string_view extension) {
  std::string own = file.extension().string();
  for (char& c : own) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return own == extension;
}

bool count_cells(const Node& node, std::int64_t columns, std::int64_t rows) {
  node.context().cells += columns * rows;
  if (node.context().cells <= most_cells) return true;
  node.fail(fmt::format("the grids hold {} cells", node.context().cells),
            fmt::format("at most {} cells in all", most_cells));
  return false;
}

CellGrid read_cells(const Node& node, double most) {
  CellGrid grid;
  if (!node.is_object_of({"name", "columns", "rows", "cell", "origin", "bounds", "runs"})) return grid;
  if (node.has("name")) grid.name = node.at("name").text();
  grid.columns = static_cast<int>(node.at("columns").integer(1, longest_side));
  grid.rows = static_cast<int>(node.at("rows").integer(1, longest_side));
  grid.cell = node.at("cell").number_above(0.0, 1e3);
  grid.origin = node.at("origin").pose(most);
  if (node.has("bounds")) grid.bounds = node.at("bounds").boolean();
  const Node runs = node.at("runs");
  if (node.failed() || !count_cells(node, grid.columns, grid.rows)) return grid;
  const Json& list = runs.json();
  if (!list.is_array() || list.size() % 2 != 0) {
    runs.fail("it is not a list of values and counts", "[value, count, value, count, ...]");
    return grid;
  }
  const std::int64_t cells = static_cast<std::int64_t>(grid.columns) * grid.rows;
  std::int64_t covered = 0;
  const auto within = [](const Json& value, std::uint64_t low, std::uint64_t high) {
    return value.is_number_unsigned() && value.get<std::uint64_t>() >= low &&
           value.get<std::uint64_t>() <= high;
  };
  for (std::size_t i = 0; i < list.size() && covered <= cells; i += 2) {
    if (!within(list[i], 0, 2) || !within(list[i + 1], 1, static_cast<std::uint64_t>(cells))) {
      runs.at(i).integer(0, 2);
      runs.at(i + 1).integer(1, cells);
      if (!node.failed())
        runs.fail("a value or count is not written as a whole number", "whole numbers without a fraction");
      return grid;
    }
    covered += list[i + 1].get<std::int64_t>();
  }
  if (covered != cells) {
    runs.fail(covered > cells ? "the runs cover more cells than there are"
                              : fmt::format("the runs cover {} cells", covered),
              fmt::format("{} columns x {} rows = {} cells", grid.columns, grid.rows, cells));
    return grid;
  }
  grid.blocked.reserve(static_cast<std::size_t>(cells));
  for (std::size_t i = 0; i < list.size(); i += 2) {
    grid.blocked.insert(grid.blocked.end(), list[i + 1].get<std::size_t>(),
                        static_cast<std::uint8_t>(list[i].get<unsigned>()));
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
  return {{"name", grid.name},      {"columns", grid.columns},        {"rows", grid.rows},
          {"cell", grid.cell},      {"origin", to_json(grid.origin)}, {"bounds", grid.bounds},
          {"runs", std::move(runs)}};
}

void check_size(const Node& node, const Map& map) {
  std::size_t edges = map.points.size();
  for (const auto* lists : {&map.boundaries, &map.obstacles, &map.lines}) {
    for (const auto& list : *lists) edges += list.size();
  }
  std::size_t runs = 0;
  for (const CellGrid& grid : map.grids) {
    const auto columns = static_cast<std::size_t>(grid.columns);
    for (std::size_t i = 0; i < grid.blocked.size(); ++i) {
      const bool blocked = grid.blocked[i] != 0;
      const bool left = i % columns == 0 ? grid.bounds : grid.blocked[i - 1] != 0;
      const bool above = i < columns ? grid.bounds : grid.blocked[i - columns] != 0;
      // An edge begins where cells differ and did not differ in the same way one cell before.
      const bool left_above = i < columns || i % columns == 0 ? grid.bounds : grid.blocked[i - columns - 1] != 0;
      edges += blocked != left && (i < columns || above == left_above) ? 1 : 0;
      edges += blocked != above && (i % columns == 0 || left == left_above) ? 1 : 0;
      runs += i == 0 || grid.blocked[i] != grid.blocked[i - 1] ? 1 : 0;
    }
  }
  if (edges > most_edges) {
    node.fail(fmt::format("the map has {} edges", edges), fmt::format("at most {} of polygons, lines, points and outlines of blocked cells together", most_edges));
  } else if (runs > most_runs) {
    node.fail(fmt::format("the cells of the grids change {} times along their rows", runs), fmt::format("at most {} times", most_runs));
  }
}

}  // namespace waywright
