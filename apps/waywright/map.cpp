#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numbers.hpp"
#include "outputs.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/map/world.hpp"
#include "waywright/report/map_picture.hpp"

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
  for (const std::string& note : map.notes) text += "  note: " + note + "\n";
  return text;
}

/// "X,Y=X,Y": a point on the map and where it lies in the world.
Parsed<std::pair<Vec2, Vec2>> pair_from(const std::string& text) {
  if (const auto v = numbers_from(text, std::array{',', '=', ','})) return std::pair{Vec2{(*v)[0], (*v)[1]}, Vec2{(*v)[2], (*v)[3]}};
  return tl::unexpected{InputError{"", "--align", fmt::format("\"{}\" is not a pair of points", text),
                                   "X,Y=X,Y: a point on the map and where it lies in the world, in metres"}};
}

/// Names parted by commas; one of a name is written "\\,".
std::vector<std::string> names_from(const std::string& text) {
  std::vector<std::string> names;
  if (text.empty()) return names;
  names.emplace_back();
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ',') names.emplace_back();
    else if (text.compare(i, 2, "\\,") == 0) names.back() += text[++i];
    else names.back() += text[i];
  }
  return names;
}

std::string picture_of(const MapArguments& arguments, const Map& map, const std::optional<Map>& below, const std::vector<std::pair<Vec2, Vec2>>& pairs) {
  constexpr double width = 1000.0;  // px
  MapPicture picture{&map, arguments.file.filename().string(), below ? &*below : nullptr, arguments.overlay.value_or("").filename().string(), {}};
  for (const auto& [on_map, in_world] : pairs) picture.pairs.push_back(in_world);
  return map_svg(picture, width);
}

}  // namespace

int map(const MapArguments& arguments) {
  if (arguments.overlay && !arguments.picture) return complain({"", "--overlay", "there is no picture to draw the two maps in", "--picture FILE.svg beside it"});
  if (arguments.out && arguments.picture && *arguments.out == *arguments.picture) return complain({"", "--picture", "it names the same file as -o", "two files"});
  std::vector<std::pair<Vec2, Vec2>> pairs;
  for (const std::string& text : arguments.align) {
    auto pair = pair_from(text);
    if (!pair) return complain(pair.error());
    pairs.push_back(*pair);
  }
  if (arguments.about_drawing && !is_dxf(arguments.file)) {
    return complain({arguments.file.string(), "command line", "--unit, --obstacle-layers, --boundary-layer, --tolerance and --closing go with a drawing alone", "a .dxf file"});
  }
  dxf::Options drawing = arguments.drawing;
  drawing.obstacle_layers = names_from(arguments.obstacle_layers);
  auto map = read_map(arguments.file, pairs, drawing);
  if (!map) return complain(map.error());
  std::optional<Map> below;
  if (arguments.overlay) {
    auto read = read_map(*arguments.overlay);
    if (!read) return complain(read.error());
    below = std::move(*read);
  }
  std::vector<NamedContent> files;
  if (arguments.out) files.push_back({*arguments.out, map_json(*map)});
  if (arguments.picture) files.push_back({*arguments.picture, picture_of(arguments, *map, below, pairs)});
  std::string said = describe(arguments.file, *map);
  for (const NamedContent& file : files) {
    if (auto ready = prepare_folder_of(file.path); !ready) return complain(ready.error());
    said += "written: " + file.path.string() + "\n";
  }
  if (auto written = write_files(files); !written) return complain(written.error());
  return print(said) ? solved : not_solved;
}

}  // namespace waywright::app
