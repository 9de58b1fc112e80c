// Pictures, and ROS maps made of a yaml and a picture.
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/fuzz/sentences.hpp"
#include "tests/fuzz/target.hpp"
#include "waywright/io/image.hpp"
#include "waywright/io/map_io.hpp"
#include "waywright/io/test_files.hpp"

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
