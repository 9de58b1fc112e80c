#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numbers.hpp"
#include "outputs.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/map/world.hpp"

namespace waywright::app {
namespace {

std::string describe(const std::filesystem::path& file, const Map& map) {
  World world{map};
  world.build();
  const Box box = world.bounds();
  std::string text = fmt::format("{}: x {:.3f} to {:.3f} m, y {:.3f} to {:.3f} m\n", file.string(), box.low.x,
                                 box.high.x, box.low.y, box.high.y);
  for (const CellGrid& grid : map.grids) {
    const auto count = [&](std::uint8_t kind) {
      return std::count(grid.blocked.begin(), grid.blocked.end(), kind);
    };
    text += fmt::format(
        "  cells: {} × {} of {} m, origin ({}, {}, {} rad); {} free ({:.1f} m²), {} occupied, {} unknown\n",
        grid.columns, grid.rows, grid.cell, grid.origin.x, grid.origin.y, grid.origin.heading, count(0),
        static_cast<double>(count(0)) * grid.cell * grid.cell, count(1), count(2));
  }
  double area = 0.0;
  for (const Ring& ring : map.obstacles) area += std::abs(signed_area(ring));
  text += fmt::format("  {} boundaries, {} obstacle polygons ({:.2f} m²), {} lines, {} points\n",
                      map.boundaries.size(), map.obstacles.size(), area, map.lines.size(), map.points.size());
  if (map.alignment) {
    const Pose& t = map.alignment->transform;
    text += fmt::format("  placed at ({:.4f}, {:.4f}, {:.5f} rad)", t.x, t.y, t.heading);
    const std::vector<double>& residuals = map.alignment->residuals;
    for (std::size_t i = 0; i < residuals.size(); ++i)
      text += fmt::format("{} {:.4f}", i == 0 ? "; residuals in m:" : ",", residuals[i]);
    text += "\n";
  }
  for (const std::string& repaired : map.notes) text += "  repaired: " + repaired + "\n";
  return text;
}

/// "X,Y=X,Y": a point on the map and where it lies in the world.
Parsed<std::pair<Vec2, Vec2>> pair_from(const std::string& text) {
  if (const auto v = numbers_from(text, std::array{',', '=', ','})) return std::pair{Vec2{(*v)[0], (*v)[1]}, Vec2{(*v)[2], (*v)[3]}};
  return tl::unexpected{InputError{"", "--align", fmt::format("\"{}\" is not a pair of points", text),
                                   "X,Y=X,Y: a point on the map and where it lies in the world, in metres"}};
}

}  // namespace

int map(const MapArguments& arguments) {
  std::vector<std::pair<Vec2, Vec2>> pairs;
  for (const std::string& text : arguments.align) {
    auto pair = pair_from(text);
    if (!pair) return complain(pair.error());
    pairs.push_back(*pair);
  }
  auto map = read_map(arguments.file, pairs);
  if (!map) return complain(map.error());
  const auto& out = arguments.out;
  if (out) {
    if (auto ready = prepare_folder_of(*out); !ready) return complain(ready.error());
    if (auto written = write_file(*out, map_json(*map)); !written) return complain(written.error());
  }
  return print(describe(arguments.file, *map) + (out ? "written: " + out->string() + "\n" : "")) ? solved
                                                                                                 : not_solved;
}

}  // namespace waywright::app
