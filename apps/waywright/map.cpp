#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/map/world.hpp"

namespace waywright::app {
namespace {

std::string describe(const std::filesystem::path& file, const Map& map) {
  World world{map};
  world.build();
  const Box box = world.bounds();
  std::string text = fmt::format("{}: x {:.3f} to {:.3f} m, y {:.3f} to {:.3f} m\n", file.string(), box.low.x, box.high.x, box.low.y, box.high.y);
  for (const CellGrid& grid : map.grids) {
    const auto count = [&](std::uint8_t kind) { return std::count(grid.blocked.begin(), grid.blocked.end(), kind); };
    text += fmt::format("  cells: {} × {} of {} m, origin ({}, {}, {} rad); {} free ({:.1f} m²), {} occupied, {} unknown\n", grid.columns, grid.rows,
                        grid.cell, grid.origin.x, grid.origin.y, grid.origin.heading, count(0), static_cast<double>(count(0)) * grid.cell * grid.cell,
                        count(1), count(2));
  }
  double area = 0.0;
  for (const Ring& ring : map.obstacles) area += std::abs(signed_area(ring));
  text += fmt::format("  {} boundaries, {} obstacle polygons ({:.2f} m²), {} lines, {} points\n", map.boundaries.size(), map.obstacles.size(), area,
                      map.lines.size(), map.points.size());
  if (map.alignment) {
    const Pose& t = map.alignment->transform;
    text += fmt::format("  placed at ({:.4f}, {:.4f}, {:.5f} rad)", t.x, t.y, t.heading);
    for (const double r : map.alignment->residuals) text += fmt::format("{} {:.4f}", r == map.alignment->residuals.front() ? "; residuals in m:" : ",", r);
    text += "\n";
  }
  for (const std::string& note : map.notes) text += "  repaired: " + note + "\n";
  return text;
}

}  // namespace

int map(const std::filesystem::path& file, const std::optional<std::filesystem::path>& out) {
  auto map = read_map(file);
  if (!map) return complain(map.error());
  if (out) {
    if (auto written = write_file(*out, map_json(*map)); !written) return complain(written.error());
  }
  return print(describe(file, *map) + (out ? "written: " + out->string() + "\n" : "")) ? solved : not_solved;
}

}  // namespace waywright::app
