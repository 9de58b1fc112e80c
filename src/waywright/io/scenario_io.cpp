#include "waywright/io/scenario_io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "waywright/io/files.hpp"
#include "waywright/io/map_json.hpp"
#include "waywright/io/mission_json.hpp"
#include "waywright/io/moving_json.hpp"
#include "waywright/io/scenario_json.hpp"
#include "waywright/io/vehicle_io.hpp"
#include "waywright/io/zones_json.hpp"
#include "waywright/scenario/zone_rules.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();

constexpr double fastest = 1e3;  // m/s
constexpr double sharpest = 1e3;  // 1/m
constexpr double most_angle = 1e3;    // rad
constexpr double fastest_turn = 1e3;  // rad/s

void read_start(const Node& node, Scenario& scenario) {
  if (!node.is_object()) {
    scenario.start = node.pose();
    return;
  }
  if (!node.is_object_of({"pose", "speed", "curvature", "course", "angular_velocity"})) return;
  scenario.start = node.at("pose").pose();
  if (node.has("speed")) scenario.start_motion.speed = node.at("speed").number(-fastest, fastest);
  if (node.has("curvature")) scenario.start_motion.curvature = node.at("curvature").number(-sharpest, sharpest);
  if (node.has("course")) scenario.start_motion.course = node.at("course").number(-most_angle, most_angle);
  if (node.has("angular_velocity")) {
    if (!scenario.start_motion.course) return node.at("angular_velocity").fail("it is given without course", "start.course beside it; what faces along its way turns with the way");
    scenario.start_motion.angular_velocity = node.at("angular_velocity").number(-fastest_turn, fastest_turn);
  }
}

PoseError read_pose_error(const Node& node) {
  PoseError error;
  if (!node.is_object_of({"lateral", "longitudinal", "heading"})) return error;
  if (node.has("lateral")) error.lateral = node.at("lateral").number(0.0, 1e3);
  if (node.has("longitudinal")) error.longitudinal = node.at("longitudinal").number(0.0, 1e3);
  if (node.has("heading")) error.heading = node.at("heading").number(0.0, pi);
  return error;
}

BudgetLimits read_budget(const Node& node) {
  BudgetLimits budget;
  if (!node.is_object_of({"evaluations", "expansions", "samples", "seconds"})) return budget;
  const auto work = [&](const char* field, std::optional<std::int64_t>& value) {
    if (node.has(field)) value = node.at(field).integer(1, 1'000'000'000'000);
  };
  work("evaluations", budget.evaluations);
  work("expansions", budget.expansions);
  work("samples", budget.samples);
  if (node.has("seconds")) budget.seconds = node.at("seconds").number_above(0.0, 1e6);
  return budget;
}

Vehicle read_vehicle_field(const Node& node, const fs::path& folder, std::vector<std::string>& notes) {
  if (node.is_object()) return read_vehicle_node(node, notes);
  if (!node.json().is_string()) node.fail(fmt::format("it is {}", kind_of(node.json())), "a vehicle, or the name of a file that holds one");
  if (node.failed()) return {};
  const std::string name = node.file_name();
  if (node.failed()) return {};
  auto vehicle = read_vehicle_file(folder / name, name, notes);
  if (vehicle) return *vehicle;
  fail_by_file(node, vehicle.error());
  return {};
}

Json budget_to_json(const BudgetLimits& budget) {
  Json j = Json::object();
  if (budget.evaluations) j["evaluations"] = *budget.evaluations;
  if (budget.expansions) j["expansions"] = *budget.expansions;
  if (budget.samples) j["samples"] = *budget.samples;
  if (budget.seconds && std::isfinite(*budget.seconds)) j["seconds"] = *budget.seconds;
  return j;
}

}  // namespace

void check_format(const Node& node, const char* what) {
  const std::string wanted = fmt::format("waywright-{}/", what);
  if (node.is_object() && !node.has("format")) return node.at("format").fail("", wanted + "1");
  const std::string format = node.at("format").text();
  if (node.failed() || format == wanted + "1") return;
  const std::string_view number = std::string_view{format}.substr(std::min(wanted.size(), format.size()));
  const bool newer = format.rfind(wanted, 0) == 0 && !number.empty() && number[0] != '0' &&
                     std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
  node.at("format").fail(
      newer ? fmt::format("\"{}\" was written by a newer version; this one reads /1", shortened(format))
            : fmt::format("\"{}\" is not a format that can be read here", shortened(format)),
      wanted + "1");
}

std::optional<std::string> heading_doubt(double radians) {
  constexpr double degrees = 180.0 / pi;
  if (!(std::abs(radians) > two_pi)) return std::nullopt;
  return fmt::format("{:g} rad is more than a whole turn and is taken as {:.4f} rad ({:.1f}°); headings are in radians: {:g}° would be {:.4f}", radians, wrap(radians), wrap(radians) * degrees, radians,
                     wrap(std::fmod(radians, 360.0) / degrees));
}

std::vector<std::string> outline_doubts(const Map& drawing, Vec2 start) {
  std::vector<std::string> sentences;
  for (std::size_t i = 0; i < drawing.obstacles.size(); ++i) {
    const Ring& ring = drawing.obstacles[i];
    if (!contains(ring, start)) continue;
    const Box box = bounding_box(ring);
    sentences.push_back(fmt::format("the start lies inside of obstacle {}, a closed outline of {:.1f} m² (x {:.2f} to {:.2f}, y {:.2f} to {:.2f} m), which is solid; if it is the outline of a room, name its layer "
                                    "as boundary_layer", i, std::abs(signed_area(ring)), box.low.x, box.high.x, box.low.y, box.high.y));
  }
  return sentences;
}

namespace {

/// Of zones that lie off everything that the map shows and the mission names.
void doubt_zones(const Scenario& scenario, std::vector<std::string>& notes) {
  const Map& map = scenario.map;
  std::vector<Vec2> points = map.points;
  const auto add = [&](const std::vector<Vec2>& more) { points.insert(points.end(), more.begin(), more.end()); };
  for (const auto* rings : {&map.boundaries, &map.obstacles, &map.lines}) {
    for (const auto& ring : *rings) add(ring);
  }
  for (const CellGrid& grid : map.grids) {
    for (const double column : {0.0, static_cast<double>(grid.columns)}) add({grid.corner(column, 0.0), grid.corner(column, grid.rows)});
  }
  if (points.empty()) return;  // without a map nothing is off it
  points.push_back(scenario.start.position());
  const auto add_goal = [&](const Mission& mission) {
    if (const auto* pose = std::get_if<Pose>(&mission)) points.push_back(pose->position());
    if (const auto* station = std::get_if<Station>(&mission)) add(station->area);
    if (const auto* free = std::get_if<FreeGoal>(&mission)) add(free->area);
  };
  if (scenario.legs.empty()) add_goal(scenario.mission);
  for (const Leg& leg : scenario.legs) add_goal(leg.mission);
  const Box box = bounding_box(points);
  std::vector<std::string> off;
  for (std::size_t i = 0; i < scenario.zones.size(); ++i) {
    if (!meet(box, bounding_box(scenario.zones[i].area))) off.push_back(title_of(scenario.zones[i], i));
  }
  if (off.empty()) return;
  constexpr std::size_t most_named = 4;
  std::string names;
  for (std::size_t i = 0; i < off.size() && i < most_named; ++i) names += (i == 0 ? "" : ", ") + off[i];
  if (off.size() > most_named) names += fmt::format(" and {} more", off.size() - most_named);
  std::string sentence = fmt::format("zones: {} {} off the map and the mission, which reach from ({:.2f}, {:.2f}) to ({:.2f}, {:.2f})", names, off.size() == 1 ? "lies" : "lie", box.low.x,
                                     box.low.y, box.high.x, box.high.y);
  // A plan's scenario has it among its notes already.
  if (std::find(notes.begin(), notes.end(), sentence) == notes.end()) notes.push_back(std::move(sentence));
}

}  // namespace

Scenario read_scenario_node(const Node& node, const fs::path& folder, const Site* site, const std::vector<std::string>& noted) {
  Scenario scenario;
  check_format(node, "scenario");  // first: a newer one may well have fields that are unknown here
  if (node.failed() || !node.is_object_of({"format", "name", "meta", "map", "vehicle", "start", "goal",
                                           "waypoints", "waypoint_radius", "station", "legs", "order", "clearance", "pose_error", "zones",
                                           "moving", "budget", "planner", "seed", "carried_load"})) {
    return scenario;
  }
  if (node.has("name")) scenario.name = node.at("name").text();
  if (node.has("meta")) {
    const Node meta = node.at("meta");
    if (!meta.is_object()) meta.fail(fmt::format("it is {}", kind_of(meta.json())), "an object");
    scenario.meta = meta.json().dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  if (node.failed()) return scenario;
  Json source = Json::object();
  if (site == nullptr) scenario.map = read_map_node(node.at("map"), folder, source);
  if (node.failed()) return scenario;
  std::vector<std::string>& notes = scenario.map.notes;
  const std::size_t notes_of_map = notes.size();
  if (site == nullptr) {
    scenario.vehicle = read_vehicle_field(node.at("vehicle"), folder, notes);
  } else {
    scenario.vehicle = site->vehicle;
    notes = site->notes;
    source = Json::parse(site->map_source, nullptr, false);
    if (!source.is_object()) source = Json::object();
  }
  if (node.failed()) return scenario;
  notes.insert(notes.end(), noted.begin(), noted.end());
  read_start(node.at("start"), scenario);
  doubt_pose(node.at("start").has("pose") ? node.at("start").at("pose") : node.at("start"), notes);
  read_whole_mission(node, scenario);
  if (site == nullptr && !node.failed() && node.at("map").has("dxf")) {
    for (std::string& sentence : outline_doubts(scenario.map, scenario.start.position())) notes.push_back("map: " + std::move(sentence));
  }
  if (node.has("carried_load")) scenario.carried_load = node.at("carried_load").text();
  if (node.has("clearance")) scenario.clearance = node.at("clearance").number(0.0, 1e3);
  if (node.has("pose_error")) scenario.pose_error = read_pose_error(node.at("pose_error"));
  if (node.has("zones")) scenario.zones = read_zones(node.at("zones"), notes);
  if (site == nullptr && !node.failed()) doubt_zones(scenario, notes);
  if (node.has("moving")) scenario.moving = read_moving(node.at("moving"), notes);
  if (!node.failed() && !scenario.moving.empty() && !scenario.legs.empty()) {
    node.at("moving").fail("a mission in legs has no place for it yet, since a leg knows nothing of the time before it", "an empty array, or a mission of one goal or station");
  }
  if (node.has("budget")) scenario.budget = read_budget(node.at("budget"));
  if (scenario.legs.empty()) scenario.planner.name = usual_planner(scenario.mission, scenario.waypoints, scenario.vehicle);
  if (node.has("planner")) scenario.planner = read_planner(node.at("planner"));
  if (node.has("seed")) scenario.seed = static_cast<std::uint64_t>(node.at("seed").integer(0, most));
  if (notes.size() > notes_of_map) source["notes"] = notes;
  scenario.map_source = source.dump(-1, ' ', false, Json::error_handler_t::replace);
  return scenario;
}

Parameters read_parameters(const Node& node) {
  Parameters parameters;
  for (const auto& [name, field] : node.members("an object of parameters by name")) {
    if (name == "name") continue;
    const Json& value = field.json();
    if (value.is_boolean())
      parameters[name] = value.get<bool>();
    else if (value.is_number())
      parameters[name] = field.number(-1e300, 1e300);
    else if (value.is_string())
      parameters[name] = value.get<std::string>();
    else
      field.fail(fmt::format("it is {}", kind_of(value)), "a number, text, true or false");
  }
  return parameters;
}

Json parameters_to_json(const Parameters& parameters, const std::string* name) {
  Json::object_t j;  // appended without looking for the field each time: names differ
  if (name != nullptr) j.emplace_back("name", *name);
  for (const auto& [field, value] : parameters) {
    std::visit([&, &key = field](const auto& v) { j.emplace_back(key, Json(v)); }, value);
  }
  return j;
}

Json scenario_to_json(const Scenario& scenario) {
  Json map = map_to_json(scenario.map);
  Json source = Json::parse(scenario.map_source, nullptr, false);
  if (source.is_object()) map["source"] = std::move(source);
  Json j{{"format", "waywright-scenario/1"}, {"name", scenario.name}};
  Json meta = Json::parse(scenario.meta, nullptr, false);
  if (meta.is_object()) j["meta"] = std::move(meta);
  j["map"] = std::move(map);
  j["vehicle"] = vehicle_to_json(scenario.vehicle);
  const StartMotion& motion = scenario.start_motion;
  if (motion.speed == 0.0 && motion.curvature == 0.0 && !motion.course) {
    j["start"] = to_json(scenario.start);
  } else {
    j["start"] = {{"pose", to_json(scenario.start)}, {"speed", motion.speed}, {"curvature", motion.curvature}};
    if (motion.course) {
      j["start"]["course"] = *motion.course;
      j["start"]["angular_velocity"] = motion.angular_velocity;
    }
  }
  mission_to_json(scenario, j);
  if (!scenario.carried_load.empty()) j["carried_load"] = scenario.carried_load;
  j["clearance"] = scenario.clearance;
  j["pose_error"] = {{"lateral", scenario.pose_error.lateral},
                     {"longitudinal", scenario.pose_error.longitudinal},
                     {"heading", scenario.pose_error.heading}};
  j["zones"] = zones_to_json(scenario.zones);
  if (!scenario.moving.empty()) j["moving"] = moving_to_json(scenario.moving);
  j["budget"] = budget_to_json(scenario.budget);
  j["planner"] = parameters_to_json(scenario.planner.parameters, &scenario.planner.name);
  j["seed"] = scenario.seed;
  return j;
}

Parsed<Scenario> parse_scenario(const std::string& text, const std::string& name, const fs::path& folder) {
  auto json = parse_json(text, name);
  if (!json) return tl::unexpected{json.error()};
  ReadContext context{name, {}};
  Scenario scenario = read_scenario_node(Node{*json, "", context}, folder);
  if (context.error) return tl::unexpected{*context.error};
  return scenario;
}

Parsed<Scenario> read_scenario(const fs::path& file) {
  auto text = read_file(file, largest_json);
  if (!text) return tl::unexpected{text.error()};
  return parse_scenario(*text, file.string(), file.parent_path());
}

Parsed<Site> read_site(const fs::path& map_file, const fs::path& vehicle_file) {
  Site site;
  auto map = read_map(map_file, {}, {}, &site.map_source);
  if (!map) {
    // Beside a table of stations there is no option for what a drawing leaves open.
    InputError error = map.error();
    constexpr std::string_view option = "give unit (--unit)";
    if (const std::size_t at = error.problem.find(option); at != std::string::npos) error.problem.replace(at, option.size(), fmt::format("convert it with `waywright map {} --unit UNIT -o map.json`", map_file.string()));
    return tl::unexpected{error};
  }
  site.map = std::move(*map);
  site.notes = site.map.notes;
  auto vehicle = read_vehicle_file(vehicle_file, vehicle_file.filename().string(), site.notes);
  if (!vehicle) return tl::unexpected{vehicle.error()};
  site.vehicle = std::move(*vehicle);
  return site;
}

std::string scenario_json(const Scenario& scenario, int indent) {
  return pretty(scenario_to_json(scenario), indent);
}

}  // namespace waywright
