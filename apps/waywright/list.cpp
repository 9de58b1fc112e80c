#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "commands.hpp"
#include "waywright/core/spelling.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/map/published_maps.hpp"
#include "waywright/map/field_worlds.hpp"
#include "waywright/map/whale_maps.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/waypoint/waypoint_clothoid.hpp"

namespace waywright::app {
namespace {

std::string line(const std::string& name, const std::string& summary) { return fmt::format("{:<28} {}\n", name, summary); }

std::string value_words(const ParameterValue& value) {
  if (const auto* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
  if (const auto* d = std::get_if<double>(&value)) return fmt::format("{}", *d);
  return std::get<std::string>(value);
}

std::string planner_words(const PlannerDescription& planner) {
  std::string text = planner.name + ": " + planner.summary + "\n";
  for (const ParameterDescription& p : planner.parameters) {
    std::string range;
    if (!p.values.empty()) range = fmt::format("{}", fmt::join(p.values, ", "));
    else if (std::holds_alternative<double>(p.default_value)) range = fmt::format("{} to {}{}", p.low, p.high, p.unit.empty() ? "" : " " + p.unit);
    if (std::holds_alternative<bool>(p.default_value)) range = "true, false";
    for (const std::string& c : p.choices) range += (range.empty() ? "" : ", ") + c;
    text += fmt::format("  {:<22} {} (default {}; {})\n", p.name, p.summary, value_words(p.default_value), range);
  }
  return text;
}

std::string vehicles() {
  std::string text;
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator{examples_folder() / "vehicles", error}) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    if (auto vehicle = read_vehicle(file)) text += line(file.filename().string(), vehicle->name);
  }
  return text;
}

}  // namespace

int list(const std::string& what) {
  std::string text;
  const bool all = what.empty();
  const auto heading = [&](const char* name) {
    if (all) text += fmt::format("{}{}:\n", text.empty() ? "" : "\n", name);
  };
  bool known = false;
  std::vector<std::string> names;  // that could have been asked for
  const auto section = [&](const char* name, auto fill) {
    names.emplace_back(name);
    if (!all && what != name) return;
    known = true;
    heading(name);
    fill();
  };
  section("planners", [&] {
    for (const PlannerDescription& p : planners()) text += line(p.name, p.summary);
  });
  section("optimizers", [&] {
    for (const OptimizerDescription& o : optimizers()) text += line(o.name, o.summary);
  });
  section("objectives", [&] {
    text += line("normalised", "0.7 × change of curvature + 0.3 × length, each over the reference path's (docking, cost B)");
    text += line("exponential", "exponentials of the differences to the reference path (docking, cost A)");
    for (const WaypointObjective o : waypoint_objectives) text += line(to_string(o), meaning_of(o) + " (waypoints)");
  });
  section("vehicles", [&] { text += vehicles(); });
  section("maps", [&] {
    text += line("polygons", "boundary, obstacles, lines, points in metres");
    text += line("ros", "ROS map_server yaml with pgm or png");
    text += line("image", "pgm or png with a resolution");
    text += line("dxf", "floor plan from CAD");
    text += line("svg", "drawing of straight lines");
    text += line("rmf", "walls of an Open-RMF building");
    text += line("opentcs", "lanes of an openTCS plant model");
    text += line("cells", "occupancy cells inlined by run lengths");
    text += line("movingai", "a map of MovingAI's benchmarks");
    text += line("generate", fmt::format("a map of a publication, as reconstructed: {}; {}; {}", fmt::join(published_map_names(), ", "), fmt::join(whale_map_names(), ", "), fmt::join(field_world_names(), ", ")));
  });
  section("zones", [&] {
    for (const ZoneType zone : zone_types) text += line(to_string(zone), meaning_of(zone));
  });
  section("generators", [&] {
    text += line("station", "a docking station with random shape, shelf, clutter, vehicle and start");
    text += line("stations", "a site of docking stations: a table, and the map of their hall beside it");
    text += line("warehouse", "a ROS map of a 60 × 40 m warehouse with racks and aisles");
    text += line("SA-CONVEX … WOA-5", "the first task on a publication's map (see list maps), for a point");
  });
  if (const PlannerDescription* planner = find_planner(what)) {
    text = planner_words(*planner);
    known = true;
  }
  if (!known) {
    for (const PlannerDescription& p : planners()) names.push_back(p.name);
    return complain({"", "list", fmt::format("\"{}\" is not known{}", what, meant_instead(what, names)),
                     "planners, optimizers, objectives, vehicles, maps, zones, generators, or a planner's name"});
  }
  return print(text) ? solved : not_solved;
}

}  // namespace waywright::app
