// ROS map_server's yaml with its picture, and bare pictures.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "waywright/core/spelling.hpp"
#include "waywright/io/files.hpp"
#include "waywright/io/image.hpp"
#include "waywright/io/json_reader.hpp"
#include "waywright/io/map_io.hpp"
#include "waywright/io/yaml_text.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_yaml = 1 << 20;
constexpr std::uint64_t largest_image_file = 1ULL << 30;

struct Header {
  std::string image;
  double resolution = 0.0;
  Pose origin{};
  bool negate = false;
  double occupied = 0.65;
  double free = 0.196;
  enum class Mode { trinary, scale, raw } mode = Mode::trinary;
};

/// The whole file, once its header shows a size that can be used.
Parsed<std::string> read_picture(const fs::path& path) {
  constexpr std::size_t header = 4096;  // bytes: comments may come before a PGM's numbers
  auto head = read_head(path, header);
  if (!head) return head;
  if (auto error = refused_by_header(*head, path.string())) return tl::unexpected{*error};
  return read_file(path, largest_image_file);
}

class HeaderReader {
 public:
  HeaderReader(const YAML::Node& root, ReadContext& context) : root_{root}, context_{context} {}

  Header read() {
    Header header;
    check_fields();
    if (context_.error) return header;
    header.image = scalar("image", true);
    header.resolution = number("resolution", true, 0.0);
    if (!(header.resolution > 0.0 && header.resolution <= 1e3)) context_.fail("resolution", fmt::format("{} is out of range", header.resolution), "above 0, at most 1000 m");
    header.origin = origin();
    const double negate = number("negate", false, 0.0);
    if (negate != 0.0 && negate != 1.0) context_.fail("negate", fmt::format("{} is no truth value", negate), "0, 1, true, false");
    header.negate = negate != 0.0;
    header.occupied = threshold("occupied_thresh", header.occupied);
    header.free = threshold("free_thresh", header.free);
    if (header.occupied < header.free) {
      context_.fail("occupied_thresh", fmt::format("{} is under free_thresh {}", header.occupied, header.free), "free_thresh or more");
    }
    const std::string mode = root_["mode"] ? scalar("mode", false) : "trinary";
    if (mode == "scale") header.mode = Header::Mode::scale;
    else if (mode == "raw") header.mode = Header::Mode::raw;
    else if (mode != "trinary") context_.fail("mode", fmt::format("\"{}\" is not known{}", mode, meant_instead(mode, {"trinary", "scale", "raw"})), "trinary, scale, raw");
    return header;
  }

 private:
  static constexpr std::array<const char*, 7> known{"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh", "mode"};

  /// Each field known and given once: a threshold that is misspelt would make obstacles of free space, or the other way round.
  void check_fields() {
    std::vector<std::string> seen;
    const std::vector<std::string> names{known.begin(), known.end()};
    for (const auto& entry : root_) {
      const std::string name = entry.first.IsScalar() ? entry.first.Scalar() : std::string{};
      if (std::find(known.begin(), known.end(), name) == known.end()) return context_.fail(shortened(name), "unknown field" + meant_instead(name, names), list_of_words(names));
      if (std::find(seen.begin(), seen.end(), name) != seen.end()) return context_.fail(name, "the field is given twice", "each field once");
      seen.push_back(name);
    }
  }

  /// What is allowed of each field, for messages.
  static std::string allowed(std::string_view field) {
    if (field == "image") return "the name of a PGM or PNG file";
    if (field == "resolution") return "a number above 0, at most 1000, metres a cell";
    if (field == "negate") return "0, 1, true, false";
    if (field == "mode") return "trinary, scale, raw";
    return field.starts_with("origin") ? "a number, -1e9 to 1e9" : "a number, 0 to 1";
  }

  std::string scalar(const char* field, bool needed) {
    const YAML::Node node = root_[field];
    if (!node) {
      if (needed) context_.fail(field, "the field is missing", allowed(field));
      return {};
    }
    if (!node.IsScalar()) {
      context_.fail(field, "it is not a plain value", allowed(field));
      return {};
    }
    return node.Scalar();
  }

  double parse(const std::string& text, const std::string& field) {
    if (text == "true") return 1.0;
    if (text == "false") return 0.0;
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(value) || std::abs(value) > 1e9) {
      context_.fail(field, fmt::format("\"{}\" is not a number that can be used", shortened(text)), allowed(field));
      return 0.0;
    }
    return value;
  }

  double number(const char* field, bool needed, double fallback) {
    if (!root_[field] && !needed) return fallback;
    const std::string text = scalar(field, needed);
    return context_.error ? fallback : parse(text, field);
  }

  double threshold(const char* field, double fallback) {
    const double value = number(field, false, fallback);
    if (!(value >= 0.0 && value <= 1.0)) context_.fail(field, fmt::format("{} is out of range", value), "0 to 1");
    return value;
  }

  Pose origin() {
    const YAML::Node node = root_["origin"];
    if (!node || !node.IsSequence() || node.size() != 3) {
      context_.fail("origin", node ? "it is not a list of three numbers" : "the field is missing", "[x, y, yaw]");
      return {};
    }
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (!node[i].IsScalar()) {
        context_.fail("origin", "it is not a list of three numbers", "[x, y, yaw]");
        return {};
      }
      values[i] = parse(node[i].Scalar(), fmt::format("origin[{}]", i));
    }
    return {values[0], values[1], wrap(values[2])};
  }

  const YAML::Node& root_;
  ReadContext& context_;
};

/// 0 free, 1 occupied, 2 unknown for each grey value, as map_server has it.
std::array<std::uint8_t, 256> classes_of(const Header& header, bool unknown_is_free) {
  std::array<std::uint8_t, 256> classes{};
  const std::uint8_t unknown = unknown_is_free ? 0 : 2;
  for (std::size_t grey = 0; grey < 256; ++grey) {
    const double p = static_cast<double>(header.negate ? grey : 255 - grey) / 255.0;
    if (header.mode == Header::Mode::raw) {
      // Raw cells hold occupancy in per cent (0…100); everything else is unknown.
      const double percent = static_cast<double>(grey);
      classes[grey] = percent > 100.0                            ? unknown
                      : percent >= header.occupied * 100.0 ? std::uint8_t{1}
                      : percent <= header.free * 100.0     ? std::uint8_t{0}
                                                           : unknown;
    } else {
      classes[grey] = p > header.occupied ? std::uint8_t{1} : p < header.free ? std::uint8_t{0} : unknown;
      // Scale mode has degrees between its thresholds, and none of them is surely free.
      if (header.mode == Header::Mode::scale && p <= header.occupied && p >= header.free) classes[grey] = 1;
    }
  }
  return classes;
}

/// Generous: the limit on coordinates holds in the world, after the map has been placed.
constexpr double largest_raw_coordinate = 1e9;  // m

std::optional<InputError> check_extent(const CellGrid& grid, const std::string& name) {
  for (const int column : {0, grid.columns}) {
    for (const int row : {0, grid.rows}) {
      const Vec2 p = grid.corner(column, row);
      if (!(std::abs(p.x) <= largest_raw_coordinate && std::abs(p.y) <= largest_raw_coordinate)) {
        return InputError{name, "", fmt::format("the map reaches ({:g}, {:g})", p.x, p.y), "coordinates within 1e9 m"};
      }
    }
  }
  return std::nullopt;
}

}  // namespace

Parsed<LoadedGrid> load_ros_map(const fs::path& yaml, bool unknown_is_free) {
  auto text = read_file(yaml, largest_yaml);
  if (!text) return tl::unexpected{text.error()};
  ReadContext context{yaml.string(), {}, 0};
  if (auto problem = suspicious_yaml(*text)) return tl::unexpected{InputError{yaml.string(), "", *problem, "a flat list of fields"}};
  Header header;
  try {
    const YAML::Node root = YAML::Load(*text);
    if (!root.IsMap()) return tl::unexpected{InputError{yaml.string(), "", "it is not a yaml map", "image, resolution, origin, …"}};
    header = HeaderReader{root, context}.read();
  } catch (const YAML::Exception& e) {
    return tl::unexpected{InputError{yaml.string(), "", fmt::format("not valid yaml near line {}", e.mark.line + 1), ""}};
  }
  if (context.error) return tl::unexpected{*context.error};

  const fs::path image_path = yaml.parent_path() / header.image;  // an absolute image path replaces the folder
  auto bytes = read_picture(image_path);
  if (!bytes) {
    // A file that is not there is the yaml's matter; what is wrong inside it is its own.
    InputError error = bytes.error();
    std::error_code unusable;  // a name that is too long, say
    if (!fs::is_regular_file(image_path, unusable)) error = {yaml.string(), "image", error.file + ": " + error.problem, error.allowed};
    return tl::unexpected{error};
  }
  auto image = decode_image(*bytes, image_path.string());
  if (!image) return tl::unexpected{image.error()};

  LoadedGrid loaded;
  loaded.grid = {yaml.filename().string(), image->width, image->height, header.resolution, header.origin,
                 std::move(image->pixels), true};
  const auto classes = classes_of(header, unknown_is_free);
  for (std::uint8_t& cell : loaded.grid.blocked) cell = classes[cell];
  // In scale mode transparency says that nothing is known.
  if (header.mode == Header::Mode::scale && !unknown_is_free) {
    for (std::size_t i = 0; i < image->see_through.size(); ++i) {
      if (image->see_through[i]) loaded.grid.blocked[i] = 2;
    }
  }
  if (auto error = check_extent(loaded.grid, yaml.string())) return tl::unexpected{*error};
  loaded.files = {{yaml.string(), sha256(*text)}, {image_path.string(), sha256(*bytes)}};
  return loaded;
}

Parsed<LoadedGrid> load_image_map(const fs::path& path, double resolution, const Pose& origin, double occupied_below) {
  auto bytes = read_picture(path);
  if (!bytes) return tl::unexpected{bytes.error()};
  auto image = decode_image(*bytes, path.string());
  if (!image) return tl::unexpected{image.error()};
  LoadedGrid loaded;
  loaded.grid = {path.filename().string(), image->width, image->height, resolution, origin, std::move(image->pixels), true};
  for (std::uint8_t& cell : loaded.grid.blocked) cell = static_cast<double>(cell) / 255.0 < occupied_below ? 1 : 0;
  if (auto error = check_extent(loaded.grid, path.string())) return tl::unexpected{*error};
  loaded.files = {{path.string(), sha256(*bytes)}};
  return loaded;
}

}  // namespace waywright
