#include "waywright/io/whale_config.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include "waywright/core/spelling.hpp"
#include "waywright/io/json_reader.hpp"
#include "waywright/io/map_io.hpp"
#include "waywright/io/map_parts.hpp"
#include "waywright/io/scenario_json.hpp"
#include "waywright/io/vehicle_io.hpp"
#include "waywright/map/whale_maps.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_config = 1 << 20;  // bytes: a longer text is none
constexpr double picture_width = 20.0;             // m, as wide as the five maps
constexpr double from_corner = 1.5;                // m, of start and goal
constexpr double most = 1e9;                       // of any number; the planner's own ranges are narrower

enum class Kind { flag, count, number };

/// A key that is a parameter of a planner.
struct ParameterKey {
  const char* key;
  const char* parameter;
  Kind kind;
};
constexpr std::array<ParameterKey, 11> parameter_keys{{{"ReturnOnFirstPath", "first_path", Kind::flag},
                                                       {"PathPlanner_Iterations", "iterations", Kind::count},
                                                       {"PathPlanner_Step_Size", "step", Kind::number},
                                                       {"PathPlanner_Search_Radius", "radius", Kind::number},
                                                       {"PathPlanner_Goal_Threshold", "goal_threshold", Kind::number},
                                                       {"PathOptimizer_Population", "population", Kind::count},
                                                       {"PathOptimizer_Iterations", "woa_iterations", Kind::count},
                                                       {"PathOptimizer_a_Parameter", "a0", Kind::number},
                                                       {"PathOptimizer_b_Parameter", "b", Kind::number},
                                                       {"PathOptimizer_Width_Bound", "bound", Kind::number},
                                                       {"PathOptimizer_Height_Bound", "bound", Kind::number}}};

/// A key without a meaning here, and why.
struct IgnoredKey {
  const char* key;
  Kind kind;
  const char* why;
};
constexpr const char* ordered = "a free path comes before one that collides, and then the shorter one: weights cannot change that";
constexpr std::array<IgnoredKey, 5> ignored_keys{{{"RenderGraphics", Kind::flag, "plan.svg and report.html are always written"},
                                                  {"CreateVideo", Kind::flag, "there are no videos"},
                                                  {"TestMode", Kind::flag, "many runs are made by compare"},
                                                  {"PathOptimizer_Shortness_Weight", Kind::number, ordered},
                                                  {"PathOptimizer_Collision_Free_Weight", Kind::number, ordered}}};

constexpr const char* dilation_key = "MapProcessor_Obstacles_Dilation";
constexpr const char* epsilon_key = "MapProcessor_Epsilon";
constexpr const char* map_key = "MapProcessor_Map_Name";
constexpr std::array<const char*, 3> groups{"MapProcessor", "PathPlanner", "PathOptimizer"};

template <class Keys>
auto find_key(const Keys& keys, const std::string& name) {
  return std::find_if(keys.begin(), keys.end(), [&](const auto& k) { return name == k.key; });
}

bool is_group(const std::string& name) { return std::find(groups.begin(), groups.end(), name) != groups.end(); }

bool is_known(const std::string& name) {
  return name == dilation_key || name == epsilon_key || name == map_key || find_key(parameter_keys, name) != parameter_keys.end() || find_key(ignored_keys, name) != ignored_keys.end();
}

/// Commas that stand before a closing bracket become spaces, so that places in the text stay where they are.
std::string without_trailing_commas(std::string text) {
  bool in_text = false;
  constexpr std::size_t none = std::string::npos;
  std::size_t comma = none;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_text) {
      if (c == '\\') ++i;
      else if (c == '"') in_text = false;
    } else if (c == ',') {
      comma = i;
    } else if (c == '}' || c == ']') {
      if (comma != none) text[comma] = ' ';
      comma = none;
    } else if (c != ' ' && c != '\n' && c != '\r' && c != '\t') {
      comma = none;
      in_text = c == '"';
    }
  }
  return text;
}

std::string as_written(const Json& value) { return value.is_string() ? "\"" + shortened(value.get<std::string>()) + "\"" : shortened(value.dump(-1, ' ', false, Json::error_handler_t::replace)); }

class ConfigReader {
 public:
  ConfigReader(const Node& root, const fs::path& folder, std::string planner, const std::function<bool(const std::string&, const std::string&)>& takes)
      : root_{root}, folder_{folder}, planner_{std::move(planner)}, takes_{takes} {}

  /// A scenario as scenario.json has it.
  Json read() {
    flatten();
    if (root_.failed()) return {};
    const auto given = [&](const char* key) { return std::any_of(keys_.begin(), keys_.end(), [&](const auto& k) { return k.first == key; }); };
    if (!given(map_key)) {
      root_.at(map_key).fail("", map_allowed);
      return {};
    }
    if (planner_.empty()) planner_ = std::any_of(keys_.begin(), keys_.end(), [](const auto& k) { return k.first.starts_with("PathOptimizer_"); }) ? "rrt_star_woa_global" : "rrt_star";
    parameters_["name"] = planner_;
    read_map();
    for (const auto& [key, node] : keys_) {
      if (root_.failed()) return {};
      read_key(key, node);
    }
    if (root_.failed()) return {};
    Json scenario{{"format", "waywright-scenario/1"}, {"name", name_}, {"meta", {{"configuration", root_.json()}}}, {"map", std::move(map_)}};
    scenario["vehicle"] = {{"name", "a point that turns on the spot"}, {"footprint", {{"disc", 0}}}, {"drive", {{"type", "differential"}, {"track", 0.5}}}};
    const double heading = 0.25 * pi;  // the diagonal's
    scenario["start"] = {start_.x, start_.y, heading};
    scenario["goal"] = {goal_.x, goal_.y, heading};
    scenario["clearance"] = clearance_;
    scenario["planner"] = std::move(parameters_);
    return scenario;
  }

  std::vector<std::string> mapping() { return std::move(mapping_); }

 private:
  static constexpr const char* map_allowed = "\"1\" to \"5\", or the name of a PNG or PGM picture";

  void add(const std::string& key, Node node) {
    if (!is_known(key)) {
      std::vector<std::string> all;
      for (const auto& k : parameter_keys) all.emplace_back(k.key);
      for (const auto& k : ignored_keys) all.emplace_back(k.key);
      for (const char* k : {dilation_key, epsilon_key, map_key}) all.emplace_back(k);
      return node.fail("unknown key" + meant_instead(key, all), list_of_words(all));
    }
    if (std::any_of(keys_.begin(), keys_.end(), [&](const auto& k) { return k.first == key; })) return node.fail("the key is given twice, by itself and in an object", "once");
    keys_.emplace_back(key, std::move(node));
  }

  void flatten() {
    for (auto& [name, node] : root_.members("an object")) {
      if (root_.failed()) return;
      if (!is_group(name)) {
        add(name, node);
        continue;
      }
      for (auto& [inner, value] : node.members("an object of keys")) {
        if (root_.failed()) return;
        add(name + "_" + inner, value);
      }
    }
  }

  void say(const std::string& key, const Node& node, const std::string& becomes) { mapping_.push_back(fmt::format("{} {} -> {}", key, as_written(node.json()), becomes)); }
  void ignore(const std::string& key, const Node& node, const std::string& why) { mapping_.push_back(fmt::format("{} {} is ignored: {}", key, as_written(node.json()), why)); }

  /// Which map, before the keys that depend on it.
  void read_map() {
    const Node node = std::find_if(keys_.begin(), keys_.end(), [](const auto& k) { return k.first == map_key; })->second;
    std::string name;
    if (node.json().is_number()) name = std::to_string(node.integer(1, 5));
    else if (node.json().is_string()) name = node.file_name();
    else node.fail(fmt::format("it is {}", kind_of(node.json())), map_allowed);
    if (node.failed()) return;
    if (const auto hall = whale_map("WOA-" + name)) {
      name_ = hall->name + ", " + hall->about;
      map_ = {{"generate", hall->name}};
      map_words_ = fmt::format("map.generate = \"{}\"", hall->name);
      start_ = hall->task.start;
      goal_ = hall->task.goal;
      return;
    }
    if (!has_extension(name, ".png") && !has_extension(name, ".pgm")) return node.fail(fmt::format("\"{}\" is no map that is known", shortened(name)), map_allowed);
    const auto picture = load_image_map(folder_ / name, 1.0, {}, 0.5);
    if (!picture) return fail_by_file(node, picture.error());
    const double width = picture->grid.columns, height = picture->grid.rows;
    pixel_ = picture_width / width;
    name_ = shortened(name);
    map_ = {{"image", name}, {"resolution", pixel_}};
    map_words_ = fmt::format("map.image = \"{}\", map.resolution = {:.6g} ({} pixels are {:g} m)", shortened(name), pixel_, width, picture_width);
    start_ = {from_corner, from_corner};
    goal_ = {picture_width - from_corner, pixel_ * height - from_corner};
  }

  void read_key(const std::string& key, const Node& node) {
    if (const auto known = find_key(parameter_keys, key); known != parameter_keys.end()) return read_parameter(*known, node);
    if (const auto known = find_key(ignored_keys, key); known != ignored_keys.end()) {
      (void)value_of(known->kind, node);  // its type has to be right all the same
      return ignore(key, node, known->why);
    }
    if (key == map_key) {
      say(key, node, map_words_);
      mapping_.push_back(fmt::format("{} {} -> start = ({:g}, {:g}), goal = ({:g}, {:g}), vehicle = a point, as the maps are reconstructed", key, as_written(node.json()), start_.x, start_.y, goal_.x, goal_.y));
    } else if (key == dilation_key) {
      read_dilation(node);
    } else {
      node.number(0.0, 1.0);
      ignore(key, node, pixel_ > 0.0 ? "cells are taken as they are" : "the map is made of polygons");
    }
  }

  void read_dilation(const Node& node) {
    const auto pixels = node.integer(0, 16384);
    if (node.failed()) return;
    if (pixels > 0 && pixel_ == 0.0) return node.fail("the map is made of polygons and has no pixels", "0, or a picture as the map");
    clearance_ = static_cast<double>(pixels) * pixel_;
    say(dilation_key, node, fmt::format("clearance = {:g}", clearance_));
  }

  static Json value_of(Kind kind, const Node& node) {
    switch (kind) {
      case Kind::flag:
        return node.boolean();
      case Kind::count:
        return node.integer(0, static_cast<std::int64_t>(most));
      case Kind::number:
        break;
    }
    return node.number(0.0, most);
  }

  void read_parameter(const ParameterKey& key, const Node& node) {
    const Json value = value_of(key.kind, node);
    if (node.failed()) return;
    if (takes_ && !takes_(planner_, key.parameter)) return ignore(key.key, node, fmt::format("{} has no such parameter", planner_));
    if (parameters_.contains(key.parameter) && parameters_[key.parameter] != value) {
      return node.fail("the two bounds differ, and a way is varied by one", fmt::format("{}, as PathOptimizer_Width_Bound and PathOptimizer_Height_Bound both", parameters_[key.parameter].dump()));
    }
    parameters_[key.parameter] = value;
    say(key.key, node, fmt::format("planner.parameters.{} = {}", key.parameter, value.is_number_float() ? fmt::format("{}", value.get<double>()) : value.dump()));
  }

  const Node& root_;
  const fs::path& folder_;
  std::string planner_;
  const std::function<bool(const std::string&, const std::string&)>& takes_;
  std::vector<std::pair<std::string, Node>> keys_;
  std::vector<std::string> mapping_;
  std::string name_, map_words_;
  Json map_, parameters_ = Json::object();
  Vec2 start_{}, goal_{};
  double pixel_ = 0.0;  // m; 0: no picture
  double clearance_ = 0.0;
};

}  // namespace

bool is_whale_config(const std::string& text) {
  if (text.size() > largest_config) return false;
  constexpr std::array<std::string_view, 7> signs{"\"MapProcessor", "\"PathPlanner", "\"PathOptimizer", "\"ReturnOnFirstPath\"", "\"RenderGraphics\"", "\"CreateVideo\"", "\"TestMode\""};
  if (std::none_of(signs.begin(), signs.end(), [&](std::string_view sign) { return text.find(sign) != std::string::npos; })) return false;
  const auto json = parse_json(without_trailing_commas(text), "");
  if (!json || !json->is_object() || json->contains("format")) return false;
  const auto& members = json->get_ref<const Json::object_t&>();
  return std::any_of(members.begin(), members.end(), [](const auto& member) { return is_group(member.first) || is_known(member.first); });
}

Parsed<ConfiguredScenario> parse_whale_config(const std::string& text, const std::string& name, const fs::path& folder, const std::string& planner,
                                              const std::function<bool(const std::string&, const std::string&)>& takes) {
  const std::string mended = without_trailing_commas(text);
  auto json = parse_json(mended, name);
  if (!json) return tl::unexpected{json.error()};
  ReadContext context{name, {}};
  const Node root{*json, "", context};
  ConfigReader reader{root, folder, planner, takes};
  const Json made = reader.read();
  if (context.error) return tl::unexpected{*context.error};
  ConfiguredScenario configured;
  configured.mapping = reader.mapping();
  if (mended != text) configured.mapping.insert(configured.mapping.begin(), "a comma before a closing bracket, which JSON does not have, is left out");
  configured.scenario = read_scenario_node(Node{made, "", context}, folder);
  if (!context.error) return configured;
  // What is wrong with the made scenario is wrong with its map: everything else was looked at above.
  InputError error = *context.error;
  if (error.field.starts_with("map")) error.field = map_key;
  return tl::unexpected{error};
}

}  // namespace waywright
