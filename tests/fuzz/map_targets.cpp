// Pictures, and ROS maps made of a yaml and a picture.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/fuzz/sentences.hpp"
#include "tests/fuzz/target.hpp"
#include "waywright/io/image.hpp"
#include "waywright/io/map_io.hpp"
#include "waywright/io/opentcs_map.hpp"
#include "waywright/io/rmf_map.hpp"
#include "waywright/io/svg_map.hpp"
#include "waywright/io/test_files.hpp"
#include "waywright/map/lane_graph.hpp"
#include "waywright/map/trace.hpp"
#include "waywright/scenario/lane_zones.hpp"

namespace waywright::fuzz {
namespace {

constexpr std::size_t most_pixels = 1 << 20;  // of a picture that is encoded again

void write(const std::filesystem::path& file, const std::string& content) { std::ofstream{file, std::ios::binary} << content; }

GreyImage gradient(int width, int height) {
  GreyImage image{width, height, {}};
  for (int i = 0; i < width * height; ++i) image.pixels.push_back(static_cast<std::uint8_t>(i * 37));
  return image;
}

const std::string pgm_binary = std::string{"P5\n# made by hand\n4 3 255\n"} + std::string{"\x00\x10\x80\xcd\xfe\xff\x01\x02\x03\x04\x05\x06", 12};
const std::string pgm_wide = std::string{"P5 2 2 4095\n"} + std::string{"\x00\x10\x0f\xff\x01\x02\xff\xff", 8};
const std::string pgm_plain = "P2\n3 2\n15\n0 1 2\n15 14 # half\n 3\n";

}  // namespace

Outcome run_image(const std::string& bytes) {
  const auto image = decode_image(bytes, "picture");
  if (!image) {
    require_sentence(image.error());
    return Outcome::refused;
  }
  require(image->width >= 1 && image->width <= largest_side && image->height >= 1 && image->height <= largest_side, "sides are in range");
  require(image->pixels.size() == static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height), "every pixel is there");
  if (image->pixels.size() > most_pixels) return Outcome::accepted;
  const auto again = decode_image(encode_png(*image), "again");
  require(again.has_value() && again->width == image->width && again->height == image->height && again->pixels == image->pixels,
          "a picture written as PNG reads back the same");
  return Outcome::accepted;
}

Outcome run_ros_map(const std::string& bytes) {
  static const test::Folder folder;
  const std::size_t end = std::min(bytes.find('\0'), bytes.size());
  write(folder.path() / "map.yaml", bytes.substr(0, end));
  write(folder.path() / "picture", bytes.substr(std::min(bytes.size(), end + 1)));
  const auto loaded = load_ros_map(folder.path() / "map.yaml", bytes.size() % 2 == 0);
  if (!loaded) {
    require_sentence(loaded.error());
    return Outcome::refused;
  }
  const CellGrid& grid = loaded->grid;
  require(grid.cell > 0.0 && is_finite(grid.origin), "the grid has a place and a size");
  require(grid.blocked.size() == static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), "every cell is there");
  require(std::all_of(grid.blocked.begin(), grid.blocked.end(), [](std::uint8_t c) { return c <= 2; }), "cells are free, occupied or unknown");
  require(loaded->files.size() == 2, "both files are on record");
  return Outcome::accepted;
}

Outcome run_movingai(const std::string& bytes) {
  const auto loaded = decode_movingai_map(bytes, "hall.map", 0.5);
  if (!loaded) {
    require_sentence(loaded.error());
    return Outcome::refused;
  }
  const CellGrid& grid = loaded->grid;
  require(grid.columns >= 1 && grid.columns <= largest_side && grid.rows >= 1 && grid.rows <= largest_side, "sides are in range");
  require(grid.blocked.size() == static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), "every cell is there");
  std::string written = "type octile\nheight " + std::to_string(grid.rows) + "\nwidth " + std::to_string(grid.columns) + "\nmap\n";
  for (std::size_t i = 0; i < grid.blocked.size(); ++i) {
    written += grid.blocked[i] != 0 ? '@' : '.';
    if ((i + 1) % static_cast<std::size_t>(grid.columns) == 0) written += '\n';
  }
  const auto again = decode_movingai_map(written, "again.map", 0.5);
  require(again.has_value() && again->grid.blocked == grid.blocked && again->grid.columns == grid.columns, "a map written reads back the same");
  return Outcome::accepted;
}

Outcome run_svg(const std::string& bytes) {
  const auto map = decode_svg_map(bytes, "scene.svg", 0.5);
  if (!map) {
    require_sentence(map.error());
    return Outcome::refused;
  }
  require(map->obstacles.size() + map->lines.size() > 0, "a map holds something");
  for (const Ring& ring : map->obstacles) {
    const RingRepair again = repair_ring(ring);
    require(!again.refused && again.mended.empty(), "polygons are simple and counter-clockwise");
  }
  for (const Polyline& line : map->lines) {
    require(line.size() > 1 && std::all_of(line.begin(), line.end(), [](Vec2 p) { return is_finite(p); }), "lines have two finite points or more");
  }
  return Outcome::accepted;
}

std::vector<std::string> svg_seeds() {
  return {"<svg viewBox='0 0 10 8'><g id='a' transform='translate(-1,2) rotate(30 1 1) scale(.5)'><path style='fill:#c7c7c7' d='m 1,1 2,-.5 h 3 l 1e0,4 v 1 z'/><rect x='1' y='2' width='3' height='1'/></g>"
          "<polygon points='5,5 6,5 6,6'/><line x1='0' y1='0' x2='10' y2='8'/><polyline fill='none' points='0 0 1 1 2 0'/><text>a</text></svg>",
          "<?xml version='1.0' encoding='UTF-8'?>\n<!-- made by hand -->\n<svg xmlns='http://www.w3.org/2000/svg' xmlns:e='e'><e:view a='1'/><defs><circle r='1'/></defs>"
          "<g transform='matrix(1 0 1 1 0 0) skewX(10)'><path d='M0 0H1V1H0ZM5 5h1v1z'/></g></svg>"};
}

Outcome run_rmf(const std::string& bytes) {
  const auto map = decode_rmf_map(bytes, "hall.building.yaml", bytes.size() % 3 == 0 ? "L1" : "");
  if (!map) {
    require_sentence(map.error());
    return Outcome::refused;
  }
  require(!map->lines.empty(), "a building has walls");
  for (const Polyline& wall : map->lines) require(wall.size() == 2 && is_finite(wall[0]) && is_finite(wall[1]), "walls have two finite points");
  for (const std::string& note : map->notes) require(std::none_of(note.begin(), note.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }), "a note is one line of text");
  return Outcome::accepted;
}

std::vector<std::string> rmf_seeds() {
  const std::string level = "vertices: [[100, 200, 0, \"\"], [300, 200, 0, a], [300, 400.5, 0, b]], walls: [[0, 1, {alpha: [3, 1]}], [1, 2, {}]]";
  return {"name: hall\nlevels:\n  L1: {" + level + ", measurements: [[0, 1, {distance: [3, 10]}], [1, 2, {distance: [3, 1e1]}]], doors: [[0, 1]]}\n",
          "coordinate_system: cartesian_meters\nlevels:\n  L1:\n    {" + level + "}\n  L2: {}\n", "{coordinate_system: reference_image, levels: {L1: {" + level + ", measurements: [[0, 2, {distance: [3, 4]}]]}}}"};
}

Outcome run_opentcs(const std::string& bytes) {
  const auto map = decode_opentcs_map(bytes, "plant.xml");
  if (!map) {
    require_sentence(map.error());
    return Outcome::refused;
  }
  const LaneGraph& graph = map->lanes;
  require(!graph.places.empty(), "a plant has places");
  for (const LanePlace& place : graph.places) require(is_finite(place.at) && std::isfinite(place.heading.value_or(0.0)), "places are somewhere");
  for (const Lane& lane : graph.lanes) {
    require(lane.from < graph.places.size() && lane.to < graph.places.size() && lane.from != lane.to, "lanes lead from place to place");
    require(lane.course.size() > 1 && lane.course.front() == graph.places[lane.from].at && lane.course.back() == graph.places[lane.to].at, "courses do, too");
    require(std::all_of(lane.course.begin(), lane.course.end(), [](Vec2 p) { return is_finite(p); }), "by finite points");
    require(lane.speed.value_or(0.0) > 0.0, "lanes are driven");
  }
  for (const LaneStation& station : graph.stations) {
    require(std::all_of(station.places.begin(), station.places.end(), [&](std::size_t i) { return i < graph.places.size(); }), "stations are served from places");
  }
  for (const std::string& note : map->notes) require(std::none_of(note.begin(), note.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }), "a note is one line of text");
  const Box box = bounding_box(graph);
  const double cell = std::max(0.05, 0.005 * norm(box.high - box.low));
  if (const auto grid = lane_corridors(graph, std::max(1.0, 4.0 * cell), cell); grid) {
    require(grid->blocked.size() == static_cast<std::size_t>(grid->columns) * static_cast<std::size_t>(grid->rows), "every cell is there");
  }
  if (const auto zones = lane_zones(graph, {.width = 1.0, .preference = 0.5, .vehicle_speed = 1.0}); zones) {
    for (const Zone& zone : zones->zones) require(zone.area.size() > 2 && std::all_of(zone.area.begin(), zone.area.end(), [](Vec2 p) { return is_finite(p); }), "zones have corners");
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(graph.places.size(), 4); ++i) {
    if (const auto route = shortest_route(graph, 0, i)) require(route->places.front() == 0 && route->places.back() == i, "a route leads where it should");
  }
  return Outcome::accepted;
}

std::vector<std::string> opentcs_seeds() {
  return {"<model version='7.0.0' name='m'><point name='A' positionX='0' positionY='-100' vehicleOrientationAngle='NaN'/><point name='B' positionX='9000' positionY='0' vehicleOrientationAngle='-90.5'/>"
          "<point name='C' positionX='9000' positionY='5e3'/><path name='AB' sourcePoint='A' destinationPoint='B' length='1' maxVelocity='1000' maxReverseVelocity='0' locked='false'><pathLayout connectionType='DIRECT'/></path>"
          "<path name='BC' sourcePoint='B' destinationPoint='C' maxVelocity='900' maxReverseVelocity='500'><pathLayout connectionType='BEZIER'><controlPoint x='300' y='0'/><controlPoint x='300' y='-100'/></pathLayout></path>"
          "<path name='CA' sourcePoint='C' destinationPoint='A' maxVelocity='0' maxReverseVelocity='500'><pathLayout connectionType='POLYPATH'><controlPoint x='100' y='-90'/></pathLayout></path>"
          "<path name='BA' sourcePoint='B' destinationPoint='A' maxVelocity='500' locked='true'/><vehicle name='V' maxVelocity='1000'><boundingBox length='1600' width='800' referenceOffsetX='300'/></vehicle>"
          "<location name='L' positionX='1' positionY='2'><link point='C'/></location><visualLayout scaleX='50.0' scaleY='50.0'/></model>",
          "<?xml version='1.0' encoding='UTF-8'?><model><point name='A' xPosition='0' yPosition='0'/><point name='B' xPosition='1000' yPosition='1000'/>"
          "<path name='p' sourcePoint='A' destinationPoint='B' maxVelocity='1'><pathLayout connectionType='ELBOW'/></path></model>"};
}

/// The first byte is the number of columns, the second says how, each bit of the rest is a cell.
Outcome run_trace(const std::string& bytes) {
  if (bytes.size() < 3) return Outcome::refused;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  CellGrid grid;
  grid.columns = 1 + byte(0) % 48;
  grid.cell = 0.1;
  grid.bounds = byte(1) % 2 == 1;
  for (std::size_t i = 2; i < bytes.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) grid.blocked.push_back(byte(i) >> bit & 1 ? 1 : 0);
  }
  grid.rows = static_cast<int>(std::min<std::size_t>(48, grid.blocked.size() / static_cast<std::size_t>(grid.columns)));
  if (grid.rows == 0) return Outcome::refused;
  grid.blocked.resize(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
  TraceOptions options{0.05 + 0.01 * (byte(1) / 2 % 32), std::nullopt, byte(1) >= 128 ? 0.13 : 0.0};
  if (byte(1) / 64 % 2 == 1) options.relative = 0.02;
  const auto traced = trace(grid, options);
  if (!traced) {
    require_sentence(traced.error());
    return Outcome::refused;
  }
  require(traced->reached <= options.tolerance + 1e-9, "the tolerance is kept");
  std::vector<Box> boxes;
  for (const Ring& ring : traced->obstacles) {
    const RingRepair again = repair_ring(ring);
    require(!again.refused && again.mended.empty(), "polygons are simple and counter-clockwise");
    boxes.push_back(bounding_box(ring));
  }
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      if (!grid.is_blocked(column, row)) continue;
      const Vec2 low = grid.corner(column, row + 1);
      for (const Vec2 part : {Vec2{0.5, 0.5}, Vec2{0.01, 0.01}, Vec2{0.99, 0.01}, Vec2{0.01, 0.99}, Vec2{0.99, 0.99}}) {
        const Vec2 p = low + grid.cell * part;
        bool is_held = false;
        for (std::size_t i = 0; i < boxes.size() && !is_held; ++i) is_held = boxes[i].contains(p) && contains(traced->obstacles[i], p);
        require(is_held, "every blocked cell is in a polygon");
      }
    }
  }
  return Outcome::accepted;
}

std::vector<std::string> trace_seeds() {
  std::string ring{"\x08\x01", 2}, blots{"\x20\x46", 2}, slanted{"\x1f\x8a", 2};
  for (const int row : {0xFF, 0x81, 0xBD, 0xA5, 0x81, 0xFF, 0x18, 0x24, 0x42, 0x81}) ring += static_cast<char>(row);
  for (int i = 0; i < 96; ++i) {
    blots += static_cast<char>(i * i * 37 >> 3);
    slanted += static_cast<char>(1 << i % 8);
  }
  return {ring, blots, slanted};
}

std::vector<std::string> movingai_seeds() {
  return {"type octile\nheight 3\nwidth 4\nmap\n.@GT\nOSW.\n....\n", "type octile\r\nheight 2\r\nwidth 7\r\nmap\r\n.@@@@@.\r\n.......\r\n", "type octile\nheight 1\nwidth 1\nmap\n."};
}

std::vector<std::string> image_seeds() { return {pgm_binary, pgm_wide, pgm_plain, encode_png(gradient(7, 5)), encode_png(gradient(1, 1))}; }

std::vector<std::string> ros_map_seeds() {
  const std::string yaml = "image: picture\nresolution: 0.05\norigin: [-1.0, 2.5, 0.1]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
  std::vector<std::string> seeds;
  for (const std::string& more : {std::string{}, std::string{"mode: scale\n"}, std::string{"mode: raw\n"}}) {
    seeds.push_back(yaml + more + '\0' + pgm_binary);
  }
  seeds.push_back("{image: picture, resolution: 1e-1, origin: [0, 0, 0], negate: true}" + std::string{'\0'} + encode_png(gradient(6, 4)));
  return seeds;
}

}  // namespace waywright::fuzz
