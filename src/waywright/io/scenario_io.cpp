#include "waywright/io/scenario_io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "waywright/io/files.hpp"
#include "waywright/io/map_json.hpp"
#include "waywright/io/scenario_json.hpp"
#include "waywright/io/vehicle_io.hpp"

namespace waywright {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_scenario = 256ULL << 20;
constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();

void not_yet(const Node& node, const char* field) {
  if (node.has(field) && !(node.at(field).json().is_array() && node.at(field).json().empty())) {
    node.at(field).fail("it is not supported yet");
  }
}

Pose read_start(const Node& node) {
  if (!node.is_object()) return node.pose();
  if (!node.is_object_of({"pose", "speed", "curvature"})) return {};
  for (const char* field : {"speed", "curvature"}) {
    if (node.has(field) && node.at(field).number(-1e3, 1e3) != 0.0) node.at(field).fail("a moving start is not supported yet", "0");
  }
  return node.at("pose").pose();
}

Station read_station(const Node& node, std::vector<std::string>& notes) {
  Station station;
  if (!node.is_object_of({"area", "shelf", "manoeuvre", "insertion"})) return station;
  if (node.has("manoeuvre")) {
    const std::string manoeuvre = node.at("manoeuvre").text();
    if (manoeuvre == "undock") node.at("manoeuvre").fail("undocking is not supported yet", "dock");
    else if (!node.failed() && manoeuvre != "dock") node.at("manoeuvre").fail(fmt::format("\"{}\" is not known", manoeuvre), "dock");
  }
  not_yet(node, "insertion");
  station.area = read_ring(node.at("area"), notes);
  const Node shelf = node.at("shelf");
  if (node.failed() || !shelf.is_object_of({"center", "heading", "size", "gap", "slot"})) return station;
  station.shelf.center = shelf.at("center").point();
  station.shelf.heading = wrap(shelf.at("heading").number(-1e6, 1e6));
  const Node size = shelf.at("size");
  if (!size.is_array_of(2, "[depth, width]")) return station;
  station.shelf.depth = size.at(std::size_t{0}).number_above(0.0, 1e4);
  station.shelf.width = size.at(1).number_above(0.0, 1e4);
  if (shelf.has("gap")) station.shelf.gap = shelf.at("gap").number(0.0, 1e4);
  if (shelf.has("slot")) {
    const double half = 0.5 * station.shelf.width;
    station.shelf.slot = shelf.at("slot").number(-half, half);
  }
  return station;
}

Mission read_mission(const Node& node, std::vector<std::string>& notes) {
  const int given = (node.has("goal") ? 1 : 0) + (node.has("station") ? 1 : 0) + (node.has("legs") ? 1 : 0);
  if (given != 1) {
    node.context().fail("goal", given == 0 ? "the mission is missing" : "more than one mission is given", "exactly one of goal, station, legs");
    return Pose{};
  }
  not_yet(node, "legs");
  not_yet(node, "waypoints");
  if (node.has("station")) return read_station(node.at("station"), notes);
  if (!node.has("goal")) return Pose{};
  const Node goal = node.at("goal");
  if (goal.is_object()) {
    goal.fail("a goal region is not supported yet", "a pose [x, y, heading]");
    return Pose{};
  }
  if (goal.is_array() && goal.json().size() == 2) {
    goal.fail("a goal with free heading is not supported yet", "a pose [x, y, heading]");
    return Pose{};
  }
  return goal.pose();
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

PlannerChoice read_planner(const Node& node) {
  PlannerChoice choice;
  if (!node.is_object()) {
    node.fail(fmt::format("it is {}", kind_of(node.json())), "an object with a name and parameters");
    return choice;
  }
  choice.name = node.at("name").text();
  for (const auto& [key, value] : node.json().items()) {
    if (key == "name") continue;
    const Node field{value, node.path() + "." + key, node.context()};
    if (value.is_boolean()) choice.parameters[key] = value.get<bool>();
    else if (value.is_number()) choice.parameters[key] = field.number(-1e300, 1e300);
    else if (value.is_string()) choice.parameters[key] = value.get<std::string>();
    else field.fail(fmt::format("it is {}", kind_of(value)), "a number, text, true or false");
  }
  return choice;
}

Json budget_to_json(const BudgetLimits& budget) {
  Json j = Json::object();
  if (budget.evaluations) j["evaluations"] = *budget.evaluations;
  if (budget.expansions) j["expansions"] = *budget.expansions;
  if (budget.samples) j["samples"] = *budget.samples;
  if (budget.seconds) j["seconds"] = *budget.seconds;
  return j;
}

void write_pretty(const Json& json, int indent, int depth, std::string& out) {
  const auto line = [&](int d) {
    out += '\n';
    out.append(static_cast<std::size_t>(indent * d), ' ');
  };
  const bool simple_array = json.is_array() && std::none_of(json.begin(), json.end(), [](const Json& e) {
    return e.is_object() || (e.is_array() && std::any_of(e.begin(), e.end(), [](const Json& f) { return f.is_structured(); }));
  });
  if (json.is_object() && !json.empty()) {
    out += '{';
    bool first = true;
    for (const auto& [key, value] : json.items()) {
      if (!first) out += ',';
      first = false;
      line(depth + 1);
      out += Json(key).dump(-1, ' ', false, Json::error_handler_t::replace) + ": ";
      write_pretty(value, indent, depth + 1, out);
    }
    line(depth);
    out += '}';
  } else if (json.is_array() && !simple_array) {
    out += '[';
    for (std::size_t i = 0; i < json.size(); ++i) {
      if (i > 0) out += ',';
      line(depth + 1);
      write_pretty(json[i], indent, depth + 1, out);
    }
    line(depth);
    out += ']';
  } else {
    out += json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
}

}  // namespace

std::string pretty(const Json& json, int indent) {
  std::string out;
  write_pretty(json, indent, 0, out);
  out += '\n';
  return out;
}

void check_format(const Node& node, const char* what) {
  const std::string wanted = fmt::format("waywright-{}/", what);
  const std::string format = node.at("format").text();
  if (node.failed() || format == wanted + "1") return;
  const bool newer = format.rfind(wanted, 0) == 0 && format.size() > wanted.size() && format.size() < wanted.size() + 6 &&
                     std::all_of(format.begin() + static_cast<std::ptrdiff_t>(wanted.size()), format.end(),
                                 [](char c) { return c >= '0' && c <= '9'; }) &&
                     format.substr(wanted.size()) != "0";
  node.at("format").fail(newer ? fmt::format("\"{}\" was written by a newer version", format)
                               : fmt::format("\"{}\" is not a format that can be read", format.substr(0, 60)),
                         wanted + "1");
}

Scenario read_scenario_node(const Node& node, const fs::path& folder) {
  Scenario scenario;
  if (!node.is_object_of({"format", "name", "meta", "map", "vehicle", "start", "goal", "waypoints", "station", "legs", "clearance",
                          "pose_error", "zones", "moving", "budget", "planner", "seed"})) {
    return scenario;
  }
  check_format(node, "scenario");
  if (node.failed()) return scenario;
  if (node.has("name")) scenario.name = node.at("name").text();
  if (node.has("meta")) {
    if (!node.at("meta").is_object()) node.at("meta").fail("it is not an object", "an object with anything in it");
    scenario.meta = node.at("meta").json().dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  Json source = Json::object();
  scenario.map = read_map_node(node.at("map"), folder, source);
  if (node.failed()) return scenario;

  const Node vehicle = node.at("vehicle");
  if (vehicle.json().is_string()) {
    auto read = read_vehicle(folder / vehicle.text());
    if (!read) {
      if (!node.failed()) node.context().error = read.error();
      return scenario;
    }
    scenario.vehicle = std::move(*read);
  } else {
    scenario.vehicle = read_vehicle_node(vehicle, scenario.map.notes);
  }
  if (node.failed()) return scenario;
  scenario.start = read_start(node.at("start"));
  scenario.mission = read_mission(node, scenario.map.notes);
  if (node.has("clearance")) scenario.clearance = node.at("clearance").number(0.0, 1e3);
  if (node.has("pose_error")) {
    const Node error = node.at("pose_error");
    if (error.is_object_of({"lateral", "longitudinal", "heading"})) {
      if (error.has("lateral")) scenario.pose_error.lateral = error.at("lateral").number(0.0, 1e3);
      if (error.has("longitudinal")) scenario.pose_error.longitudinal = error.at("longitudinal").number(0.0, 1e3);
      if (error.has("heading")) scenario.pose_error.heading = error.at("heading").number(0.0, pi);
    }
  }
  not_yet(node, "zones");
  not_yet(node, "moving");
  if (node.has("budget")) scenario.budget = read_budget(node.at("budget"));
  if (node.has("planner")) scenario.planner = read_planner(node.at("planner"));
  if (node.has("seed")) scenario.seed = static_cast<std::uint64_t>(node.at("seed").integer(0, most));
  source["notes"] = scenario.map.notes;
  if (scenario.map.notes.empty()) source.erase("notes");
  scenario.map_source = source.dump();
  return scenario;
}

Json parameters_to_json(const Parameters& parameters) {
  Json j = Json::object();
  for (const auto& [name, value] : parameters) {
    std::visit([&, &key = name](const auto& v) { j[key] = v; }, value);
  }
  return j;
}

Json scenario_to_json(const Scenario& scenario) {
  Json map = map_to_json(scenario.map);
  map["source"] = Json::parse(scenario.map_source, nullptr, false);
  if (map["source"].is_discarded()) map.erase("source");
  Json j{{"format", "waywright-scenario/1"}, {"name", scenario.name}};
  Json meta = Json::parse(scenario.meta, nullptr, false);
  if (meta.is_object()) j["meta"] = std::move(meta);
  j["map"] = std::move(map);
  j["vehicle"] = vehicle_to_json(scenario.vehicle);
  j["start"] = to_json(scenario.start);
  if (const auto* station = std::get_if<Station>(&scenario.mission)) {
    const Shelf& shelf = station->shelf;
    j["station"] = {{"area", to_json(station->area)},
                    {"shelf", {{"center", to_json(shelf.center)}, {"heading", shelf.heading},
                               {"size", Json::array({shelf.depth, shelf.width})}, {"gap", shelf.gap}, {"slot", shelf.slot}}},
                    {"manoeuvre", "dock"}};
  } else {
    j["goal"] = to_json(std::get<Pose>(scenario.mission));
  }
  j["clearance"] = scenario.clearance;
  j["pose_error"] = {{"lateral", scenario.pose_error.lateral}, {"longitudinal", scenario.pose_error.longitudinal},
                     {"heading", scenario.pose_error.heading}};
  j["zones"] = Json::array();
  j["budget"] = budget_to_json(scenario.budget);
  Json planner{{"name", scenario.planner.name}};
  planner.update(parameters_to_json(scenario.planner.parameters));
  j["planner"] = std::move(planner);
  j["seed"] = scenario.seed;
  return j;
}

Parsed<Scenario> parse_scenario(const std::string& text, const std::string& name, const fs::path& folder) {
  auto json = parse_json(text, name);
  if (!json) return tl::unexpected{json.error()};
  ReadContext context{name, {}, 0};
  Scenario scenario = read_scenario_node(Node{*json, "", context}, folder);
  if (context.error) return tl::unexpected{*context.error};
  return scenario;
}

Parsed<Scenario> read_scenario(const fs::path& file) {
  auto text = read_file(file, largest_scenario);
  if (!text) return tl::unexpected{text.error()};
  return parse_scenario(*text, file.string(), file.parent_path());
}

std::string scenario_json(const Scenario& scenario, int indent) { return pretty(scenario_to_json(scenario), indent); }
std::string map_json(const Map& map) { return pretty(map_to_json(map)); }

}  // namespace waywright
