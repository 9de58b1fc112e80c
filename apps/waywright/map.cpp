#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "map_scenario.hpp"
#include "numbers.hpp"
#include "outputs.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/lane_map_io.hpp"
#include "waywright/io/map_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/map/world.hpp"
#include "waywright/report/map_picture.hpp"

namespace waywright::app {
namespace {

/// Letters of UTF-8 text.
std::size_t letters_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// After a title, parted by commas: in one line where they have room in it, else in columns of equal width.
std::string in_columns(const std::string& title, std::vector<std::string> entries) {
  constexpr std::size_t most = 100;  // letters a line
  std::size_t widest = 0, all = title.size();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i + 1 < entries.size()) entries[i] += ',';
    widest = std::max(widest, letters_of(entries[i]));
    all += 1 + letters_of(entries[i]);
  }
  const std::string indent(4, ' ');
  const std::size_t columns = all <= most ? std::max<std::size_t>(entries.size(), 1) : std::max<std::size_t>(1, (most - indent.size() + 1) / (widest + 1));
  std::string text = title;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (all <= most) {
      text += ' ' + entries[i];
      continue;
    }
    text += i % columns == 0 ? '\n' + indent : std::string(1 + widest - letters_of(entries[i - 1]), ' ');
    text += entries[i];
  }
  return text + '\n';
}

/// Every place that missions can begin and end at, and the stations beside them.
std::string describe_places(const LaneGraph& graph) {
  constexpr std::size_t most = 2000;
  if (graph.empty()) return "";
  const auto told = [](auto count_of_all, std::vector<std::string> entries) {
    if (count_of_all > entries.size()) entries.push_back(fmt::format("and {} more", count_of_all - entries.size()));
    return entries;
  };
  std::vector<std::string> places, stations;
  for (std::size_t i = 0; i < std::min(graph.places.size(), most); ++i) {
    const LanePlace& place = graph.places[i];
    places.push_back(fmt::format("{} ({:.3f}, {:.3f}{})", place.name, place.at.x, place.at.y, place.heading ? fmt::format(", {:.4f} rad", *place.heading) : ""));
  }
  for (std::size_t i = 0; i < std::min(graph.stations.size(), most); ++i) {
    const LaneStation& station = graph.stations[i];
    std::string text = fmt::format("{} ({:.3f}, {:.3f}", station.name, station.at.x, station.at.y);
    for (std::size_t k = 0; k < station.places.size(); ++k) text += (k == 0 ? "; at " : " or ") + graph.places[station.places[k]].name;
    stations.push_back(text + ")");
  }
  return in_columns("  places:", told(graph.places.size(), places)) + (stations.empty() ? "" : in_columns("  stations:", told(graph.stations.size(), stations)));
}

std::string describe(const std::filesystem::path& file, const Map& map, const LaneGraph& lanes) {
  World world{map};
  world.build();
  const auto is_free = [](const CellGrid& grid) { return std::find(grid.blocked.begin(), grid.blocked.end(), 0) != grid.blocked.end(); };
  const bool cells_alone = map.boundaries.empty() && map.obstacles.empty() && map.lines.empty() && map.points.empty() && !map.grids.empty();
  const bool full = cells_alone && std::none_of(map.grids.begin(), map.grids.end(), is_free);
  Box box = world.bounds();
  if (full) {  // no edge of a free place bounds it
    std::vector<Vec2> corners;
    for (const CellGrid& grid : map.grids) {
      for (const int c : {0, grid.columns}) {
        for (const int r : {0, grid.rows}) corners.push_back(grid.corner(c, r));
      }
    }
    box = bounding_box(corners);
  }
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
  const auto counted = [](std::size_t n, const char* one, const char* more) { return fmt::format("{} {}", n, n == 1 ? one : more); };
  text += fmt::format("  {}, {} ({:.2f} m²), {}, {}\n", counted(map.boundaries.size(), "boundary", "boundaries"), counted(map.obstacles.size(), "obstacle polygon", "obstacle polygons"),
                      area, counted(map.lines.size(), "line", "lines"), counted(map.points.size(), "point", "points"));
  text += describe_places(lanes);
  if (map.alignment) {
    const Pose& t = map.alignment->transform;
    text += fmt::format("  placed at ({:.4f}, {:.4f}, {:.5f} rad)", t.x, t.y, t.heading);
    const std::vector<double>& residuals = map.alignment->residuals;
    for (std::size_t i = 0; i < residuals.size(); ++i)
      text += fmt::format("{} {:.4f}", i == 0 ? "; residuals in m:" : ",", residuals[i]);
    text += "\n";
  }
  if (full) text += "  note: nothing is free: every cell is occupied or unknown\n";
  for (auto note = map.notes.begin(); note != map.notes.end(); ++note) {
    if (std::find(map.notes.begin(), note, *note) != note) continue;  // told
    const auto times = std::count(note, map.notes.end(), *note);
    text += fmt::format("  note: {}{}\n", *note, times > 1 ? fmt::format(" ({} times)", times) : "");
  }
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

/// Has the file's name this ending, in capitals or not?
bool is_named(const std::filesystem::path& file, std::string_view ending) {
  const std::string extension = file.extension().string();
  return std::equal(extension.begin(), extension.end(), ending.begin(), ending.end(), [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

std::string picture_of(const MapArguments& arguments, const Map& map, const std::optional<Map>& below, const std::vector<std::pair<Vec2, Vec2>>& pairs, const LaneGraph& lanes) {
  constexpr double width = 1000.0;  // px
  MapPicture picture{&map, arguments.file.filename().string(), below ? &*below : nullptr, arguments.overlay.value_or("").filename().string(), {}, lanes.empty() ? nullptr : &lanes};
  std::vector<Vec2> from, to;
  for (const auto& [on_map, in_world] : pairs) {
    from.push_back(on_map);
    to.push_back(in_world);
  }
  // By the pairs alone: a map.json may have been placed before, too.
  if (const auto placed = pairs.empty() ? Parsed<Alignment>{} : align(from, to); placed) {
    const Frame frame{placed->transform};
    for (std::size_t i = 0; i < from.size(); ++i) picture.pairs.push_back({frame.to_world(from[i]), to[i]});
  }
  return map_svg(picture, width);
}

/// Residuals that are more than reading points off a map leaves, as `plan` warns of those over its clearance.
std::optional<std::string> alignment_doubt(const Map& map, const std::vector<std::pair<Vec2, Vec2>>& pairs) {
  constexpr double least = 0.05, share = 0.01;  // m; of the pairs' extent
  if (!map.alignment || map.alignment->residuals.size() != pairs.size() || pairs.empty()) return std::nullopt;
  std::vector<Vec2> in_world;
  for (const auto& pair : pairs) in_world.push_back(pair.second);
  const Box box = bounding_box(in_world);
  const double extent = norm(box.high - box.low);
  const std::vector<double>& residuals = map.alignment->residuals;
  const auto worst = std::max_element(residuals.begin(), residuals.end());
  if (*worst <= std::max(least, share * extent)) return std::nullopt;
  const auto& [from, to] = pairs[static_cast<std::size_t>(worst - residuals.begin())];
  return fmt::format("the map is {:.3f} m off at the pair {:g},{:g}={:g},{:g} ({:.1f} m lie between the pairs): it may not be where it truly is", *worst, from.x, from.y, to.x, to.y, extent);
}

}  // namespace

int map(const MapArguments& arguments) { return map(arguments, {}); }

int map(const MapArguments& arguments, const LaneArguments& about_lanes) {
  if (arguments.overlay && !arguments.picture) return complain({"", "--overlay", "there is no picture to draw the two maps in", "--picture FILE.svg beside it"});
  if (arguments.picture && !is_named(*arguments.picture, ".svg")) return complain({arguments.picture->string(), "--picture", "a picture is written as SVG, which this name is not for", "a name that ends in .svg"});
  for (const auto& [written, option] : {std::pair{arguments.out, "-o"}, std::pair{arguments.picture, "--picture"}, std::pair{about_lanes.scenario, "--scenario"}}) {
    for (const auto& [read, what] : {std::pair{std::optional{arguments.file}, "FILE"}, std::pair{arguments.overlay, "--overlay"}}) {
      std::error_code error;
      if (written && read && std::filesystem::equivalent(*written, *read, error)) return complain({written->string(), option, fmt::format("it is the file that {} names, which would be lost", what), "another name"});
    }
  }
  if (about_lanes.scenario && (about_lanes.scenario == arguments.out || about_lanes.scenario == arguments.picture)) return complain({"", "--scenario", "it names the same file as -o or --picture", "another file"});
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
  if (!arguments.overlay_unit.empty() && !(arguments.overlay && is_dxf(*arguments.overlay))) {
    return complain({arguments.overlay.value_or("").string(), "--overlay-unit", "it goes with a drawing alone", "--overlay FILE.dxf beside it"});
  }
  dxf::Options drawing = arguments.drawing;
  drawing.obstacle_layers = names_from(arguments.obstacle_layers);
  std::string record;
  std::vector<std::string> doubts;
  FreeAlongLanes lanes_free{about_lanes.corridor, about_lanes.margin};
  auto whole = read_lane_map(arguments.file, pairs, lanes_free, &record, drawing, arguments.cells);
  if (about_lanes.off_lanes && lanes_free.corridor) return complain({"", "--off-lanes", "--corridor beside it makes lanes all that is free", "one of them"});
  const bool keeps_lanes = !lanes_free.margin && !about_lanes.off_lanes;
  if (whole && !whole->lanes.empty() && about_lanes.scenario && keeps_lanes && !lanes_free.corridor) {
    // A scenario on a roadmap is one on its lanes.
    std::vector<std::string> told_later;
    const auto vehicle = vehicle_on_lanes(arguments.file, about_lanes, whole->lanes, told_later);
    if (!vehicle) return complain(vehicle.error());
    lanes_free.corridor = corridor_for(*vehicle);
    doubts.push_back(fmt::format("the vehicle keeps to the lanes: nothing is free but strips {:g} m across along the lanes, in which it has room to turn: --corridor METRES makes others, --off-lanes frees what lies beside them", *lanes_free.corridor));
    record.clear();
    whole = read_lane_map(arguments.file, pairs, lanes_free, &record, drawing, arguments.cells);
  } else if (about_lanes.scenario && lanes_free.corridor) {
    doubts.push_back(fmt::format("the vehicle keeps to the lanes: nothing is free but strips {:g} m across along the lanes", *lanes_free.corridor));
  }
  if (!whole) return complain(whole.error());
  Map* const map = &whole->map;
  if (const auto doubt = alignment_doubt(*map, pairs)) note_all({}, {*doubt});
  std::optional<Map> below;
  if (arguments.overlay) {
    dxf::Options of_overlay;
    of_overlay.unit = arguments.overlay_unit;
    auto read = read_map(*arguments.overlay, {}, of_overlay);
    if (!read) {
      // Its sentences name the option of the other map.
      constexpr std::string_view option = "(--unit)";
      InputError error = read.error();
      if (const std::size_t at = error.problem.find(option); at != std::string::npos) error.problem.replace(at, option.size(), "(--overlay-unit)");
      return complain(error);
    }
    below = std::move(*read);
  }
  std::vector<NamedContent> files;
  if (arguments.out) files.push_back({*arguments.out, map_json(*map)});
  if (arguments.picture) files.push_back({*arguments.picture, picture_of(arguments, *map, below, pairs, whole->lanes)});
  if (about_lanes.scenario) {
    if (!whole->lanes.empty() && !keeps_lanes) {
      doubts.push_back(is_named(arguments.file, ".xml") ? fmt::format("the vehicle may leave the lanes: all is free {:g} m around places and lanes", lanes_free.margin.value_or(usual_margin))
                                                        : std::string{"the vehicle may leave the lanes: all that walls leave free may be driven on"});
    }
    LaneArguments along = about_lanes;
    along.corridor = lanes_free.corridor;
    const auto scenario = scenario_along_lanes(arguments.file, along, whole->lanes, *map, record, doubts);
    if (!scenario) return complain(scenario.error());
    note_all({}, doubts);
    files.push_back({*about_lanes.scenario, scenario_json(*scenario)});
  }
  std::string said = describe(arguments.file, *map, whole->lanes);
  for (const NamedContent& file : files) {
    if (auto ready = prepare_folder_of(file.path); !ready) return complain(ready.error());
    said += "written: " + file.path.string() + "\n";
  }
  if (auto written = write_files(files); !written) return complain(written.error());
  return print(said) ? solved : not_solved;
}

}  // namespace waywright::app
