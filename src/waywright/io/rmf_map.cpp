#include "waywright/io/rmf_map.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "waywright/core/spelling.hpp"
#include "waywright/io/json_reader.hpp"
#include "waywright/io/yaml_text.hpp"

namespace waywright {
namespace {

constexpr std::size_t largest = 16U << 20U;     // bytes
constexpr double largest_raw_coordinate = 1e9;  // m, before a transform
constexpr std::size_t most_places = 40;         // named in a note
constexpr std::size_t most_lanes = 100'000;
constexpr std::size_t no_place = std::numeric_limits<std::size_t>::max();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double doubtful = 0.02;               // of the scale: measurements that differ by more are told

class Building {
 public:
  Building(const std::string& name, const std::string& level, LaneGraph& lanes) : name_{name}, wanted_{level}, lanes_{lanes} {}

  Parsed<Map> read(const YAML::Node& root) {
    const YAML::Node levels = root.IsMap() ? root["levels"] : YAML::Node{};
    if (!levels.IsDefined() || !levels.IsMap() || levels.size() == 0) return refuse("levels", "it has no levels", "an Open-RMF building");
    const std::string system = word(root["coordinate_system"], "reference_image");
    if (system != "reference_image" && system != "cartesian_meters") return refuse("coordinate_system", fmt::format("\"{}\" is not read{}", shortened(system), meant_instead(system, {"reference_image", "cartesian_meters"})), "reference_image, cartesian_meters");
    is_image_ = system == "reference_image";
    std::vector<std::string> all;
    YAML::Node level;
    for (const auto& entry : levels) {
      const std::string one = word(entry.first, "");
      all.push_back(shortened(one));
      if (one == wanted_ || (wanted_.empty() && levels.size() == 1)) {
        level.reset(entry.second);
        path_ = "levels." + shortened(one);
      }
    }
    if (path_.empty()) return refuse("level", wanted_.empty() ? "it has several levels" : fmt::format("there is no level \"{}\"{}", shortened(wanted_), meant_instead(wanted_, all)), list_of_words(all));
    if (!level.IsMap()) return refuse(path_, "it is no map of fields", "vertices, walls, measurements");
    if (!read_vertices(level["vertices"]) || !read_scale(level["measurements"]) || !read_walls(level["walls"]) || !read_lanes(level["lanes"])) return tl::unexpected{*error_};
    if (lanes_.empty()) name_places();  // else they are the lanes' places
    for (const char* what : {"doors", "models", "human_lanes"}) {
      const YAML::Node list = level[what];
      if (list.IsDefined() && list.IsSequence() && list.size() > 0) map_.notes.push_back(fmt::format("left out: {} ({})", what, list.size()));
    }
    return std::move(map_);
  }

 private:
  tl::unexpected<InputError> refuse(const std::string& field, std::string problem, std::string allowed) {
    error_ = InputError{name_, field, std::move(problem), std::move(allowed)};
    return tl::unexpected{*error_};
  }
  bool fail(const std::string& field, std::string problem, std::string allowed) {
    error_ = InputError{name_, path_ + "." + field, std::move(problem), std::move(allowed)};
    return false;
  }

  static std::string word(const YAML::Node& node, const std::string& fallback) { return node.IsDefined() && node.IsScalar() ? node.Scalar() : fallback; }

  static std::optional<double> number(const YAML::Node& node) {
    if (!node.IsDefined() || !node.IsScalar()) return std::nullopt;
    const std::string& text = node.Scalar();
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
  }

  std::optional<std::size_t> vertex(const YAML::Node& node) const {
    const auto value = number(node);
    if (!value || *value < 0.0 || *value >= static_cast<double>(vertices_.size()) || *value != std::floor(*value)) return std::nullopt;
    return static_cast<std::size_t>(*value);
  }

  bool read_vertices(const YAML::Node& list) {
    if (!list.IsDefined() || !list.IsSequence()) return fail("vertices", "the field is missing or no list", "a list of [x, y, z, name]");
    for (const YAML::Node& entry : list) {
      const bool is_list = entry.IsSequence() && entry.size() >= 2;
      const auto x = is_list ? number(entry[0]) : std::nullopt, y = is_list ? number(entry[1]) : std::nullopt;
      if (!x || !y) return fail(fmt::format("vertices[{}]", vertices_.size()), "it is no vertex", "[x, y, z, name] with numbers");
      vertices_.push_back({*x, is_image_ ? -*y : *y});
      names_.push_back(entry.size() >= 4 ? word(entry[3], "") : "");
    }
    return true;
  }

  /// m a pixel.
  bool read_scale(const YAML::Node& list) {
    if (is_image_) {
      std::vector<double> scales;
      if (list.IsDefined() && list.IsSequence()) {
        for (const YAML::Node& entry : list) {
          const std::string field = fmt::format("measurements[{}]", scales.size());
          const bool is_list = entry.IsSequence() && entry.size() == 3 && entry[2].IsMap();
          const auto a = is_list ? vertex(entry[0]) : std::nullopt, b = is_list ? vertex(entry[1]) : std::nullopt;
          const YAML::Node said = is_list ? entry[2]["distance"] : YAML::Node{};
          const double metres = said.IsDefined() && said.IsSequence() && said.size() == 2 ? number(said[1]).value_or(no_number) : no_number;
          if (!a || !b || std::isnan(metres)) return fail(field, "it is no measurement", "[vertex, vertex, {distance: [3, metres]}]");
          const double pixels = distance(vertices_[*a], vertices_[*b]);
          if (!(pixels > 0.0) || !(metres > 0.0) || !std::isfinite(metres / pixels)) return fail(field, "a length of it is 0", "two vertices apart, and metres over 0");
          scales.push_back(metres / pixels);
        }
      }
      if (scales.empty()) return fail("measurements", "there is none, so the drawing has no scale", "at least one");
      double sum = 0.0;
      for (const double s : scales) sum += s;
      scale_ = sum / static_cast<double>(scales.size());
      const auto [least, most] = std::minmax_element(scales.begin(), scales.end());
      map_.notes.push_back(fmt::format("a pixel is {:.6g} m by {} measurement{}", scale_, scales.size(), scales.size() == 1 ? "" : "s") +
                           (*most - *least > doubtful * scale_ ? fmt::format(", which differ: {:.6g} to {:.6g} m", *least, *most) : ""));
    }
    for (Vec2& v : vertices_) {
      v = scale_ * v;
      if (!(std::abs(v.x) <= largest_raw_coordinate && std::abs(v.y) <= largest_raw_coordinate)) return fail("vertices", fmt::format("one is at ({:g}, {:g})", v.x, v.y), "coordinates within 1e9 m");
    }
    return true;
  }

  void name_places() {
    std::string places;
    std::size_t count = 0;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (names_[i].empty() || ++count > most_places) continue;
      places += fmt::format("{}{} ({:.3f}, {:.3f})", places.empty() ? "" : ", ", shortened(names_[i]), vertices_[i].x, vertices_[i].y);
    }
    if (count > most_places) places += fmt::format(" and {} more", count - most_places);
    if (count > 0) map_.notes.push_back("places: " + places);
  }

  bool read_walls(const YAML::Node& list) {
    if (!list.IsDefined() || !list.IsSequence() || list.size() == 0) return fail("walls", "there are none", "a list of [vertex, vertex, …]");
    std::size_t index = 0;
    for (const YAML::Node& entry : list) {
      const bool is_list = entry.IsSequence() && entry.size() >= 2;
      const auto a = is_list ? vertex(entry[0]) : std::nullopt, b = is_list ? vertex(entry[1]) : std::nullopt;
      if (!a || !b) return fail(fmt::format("walls[{}]", index), "it is no wall", fmt::format("[vertex, vertex, …] with numbers from 0 to {}", vertices_.empty() ? 0 : vertices_.size() - 1));
      map_.lines.push_back({vertices_[*a], vertices_[*b]});
      ++index;
    }
    return true;
  }

  /// A value in Open-RMF's manner: [type, value].
  static YAML::Node value_of(const YAML::Node& fields, const char* name) {
    const YAML::Node typed = fields.IsMap() ? fields[name] : YAML::Node{};
    return typed.IsDefined() && typed.IsSequence() && typed.size() == 2 ? typed[1] : YAML::Node{};
  }

  /// Only vertices that lie on a lane or have a name are places.
  bool read_lanes(const YAML::Node& list) {
    if (!list.IsDefined() || list.IsNull()) return true;
    if (!list.IsSequence()) return fail("lanes", "it is no list", "a list of [vertex, vertex, …]");
    LaneGraph& graph = lanes_;
    std::vector<std::size_t> places(vertices_.size(), no_place);
    const auto place = [&](std::size_t i) {
      if (places[i] == no_place) {
        places[i] = graph.places.size();
        graph.places.push_back({names_[i].empty() ? fmt::format("vertex {}", i) : one_line(names_[i]), vertices_[i], {}});
      }
      return places[i];
    };
    for (const YAML::Node& entry : list) {
      const std::string field = fmt::format("lanes[{}]", graph.lanes.size());
      const bool is_list = entry.IsSequence() && entry.size() >= 2;
      const auto a = is_list ? vertex(entry[0]) : std::nullopt, b = is_list ? vertex(entry[1]) : std::nullopt;
      if (!a || !b || *a == *b) return fail(field, "it is no lane", fmt::format("[vertex, vertex, …] with two numbers from 0 to {}", vertices_.empty() ? 0 : vertices_.size() - 1));
      if (graph.lanes.size() >= most_lanes) return fail("lanes", fmt::format("there are over {}", most_lanes), fmt::format("at most {}", most_lanes));
      Lane lane;
      lane.from = place(*a);
      lane.to = place(*b);
      lane.name = graph.places[lane.from].name + " - " + graph.places[lane.to].name;
      lane.course = {vertices_[*a], vertices_[*b]};
      const YAML::Node fields = entry.size() >= 3 ? entry[2] : YAML::Node{};
      lane.is_both_ways = word(value_of(fields, "bidirectional"), "false") == "true";
      if (const auto speed = number(value_of(fields, "speed_limit")); speed && *speed > 0.0) lane.speed = *speed;
      graph.lanes.push_back(std::move(lane));
    }
    if (graph.lanes.empty()) return true;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      if (!names_[i].empty()) place(i);
    }
    for (std::string& sentence : describe(graph)) map_.notes.push_back(std::move(sentence));
    return true;
  }

  std::string name_, wanted_, path_;
  bool is_image_ = true;
  double scale_ = 1.0;
  std::optional<InputError> error_;
  std::vector<Vec2> vertices_;
  std::vector<std::string> names_;
  Map map_;
  LaneGraph& lanes_;
};

}  // namespace

Parsed<Map> decode_rmf_map(const std::string& bytes, const std::string& name, const std::string& level, LaneGraph* lanes) {
  if (bytes.size() > largest) return tl::unexpected{InputError{name, "", fmt::format("it has {} bytes", bytes.size()), fmt::format("at most {}", largest)}};
  if (auto problem = suspicious_yaml(bytes)) return tl::unexpected{InputError{name, "", *problem, "plain maps and lists"}};
  try {
    LaneGraph unasked;
    return Building{name, level, lanes != nullptr ? *lanes : unasked}.read(YAML::Load(bytes));
  } catch (const YAML::Exception& e) {
    return tl::unexpected{InputError{name, "", fmt::format("not valid yaml near line {}", e.mark.line + 1), ""}};
  }
}

}  // namespace waywright
