// A scenario between two places of a map's lanes: what `map --scenario` writes.
#include "map_scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "waywright/core/angle.hpp"
#include "waywright/io/json_reader.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/scenario/lane_zones.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright::app {
namespace {

constexpr double usual_width = 1.0;      // m, of lanes' zones
constexpr std::size_t most_named = 30;   // in a refusal

tl::unexpected<InputError> refuse(const std::filesystem::path& file, const char* field, std::string problem, std::string allowed) {
  return tl::unexpected{InputError{file.string(), field, std::move(problem), std::move(allowed)}};
}

std::string places_of(const LaneGraph& graph) {
  std::string names;
  for (std::size_t i = 0; i < std::min(graph.places.size(), most_named); ++i) names += (i == 0 ? "" : ", ") + graph.places[i].name;
  if (graph.places.size() > most_named) names += fmt::format(" and {} more: see map without --scenario", graph.places.size() - most_named);
  return names;
}

/// The box about it, on wheels that turn on the spot: how it steers a plant model does not tell.
Vehicle vehicle_of(const LaneVehicle& box) {
  Vehicle vehicle;
  vehicle.name = box.name;
  const double front = 0.5 * box.length - box.reference.x, back = -0.5 * box.length - box.reference.x;
  const double left = 0.5 * box.width - box.reference.y, right = -0.5 * box.width - box.reference.y;
  vehicle.footprint.polygon = {{back, right}, {front, right}, {front, left}, {back, left}};
  vehicle.drive = Differential{box.width};
  if (box.speed) vehicle.limits.speed = vehicle.limits.reverse_speed = *box.speed;
  return vehicle;
}

/// Where a vehicle looks that leaves a place by a step of a route, or arrives by it.
double heading_of(const Lane& lane, bool is_backwards, bool at_end) {
  if (!is_backwards) return at_end ? last_heading(lane) : first_heading(lane);
  return wrap((at_end ? first_heading(lane) : last_heading(lane)) + std::numbers::pi);
}

Pose pose_at(const LaneGraph& graph, std::size_t place, bool at_end, const std::optional<LaneRoute>& route) {
  const LanePlace& there = graph.places[place];
  if (there.heading) return make_pose(there.at, *there.heading);
  if (route && !route->steps.empty()) {
    const LaneRoute::Step& step = at_end ? route->steps.back() : route->steps.front();
    return make_pose(there.at, heading_of(graph.lanes[step.lane], step.is_backwards, at_end));
  }
  for (const Lane& lane : graph.lanes) {
    if ((at_end ? lane.to : lane.from) == place) return make_pose(there.at, heading_of(lane, false, at_end));
    if (lane.is_both_ways && (at_end ? lane.from : lane.to) == place) return make_pose(there.at, heading_of(lane, true, at_end));
  }
  return make_pose(there.at, 0.0);
}

}  // namespace

Parsed<Scenario> scenario_along_lanes(const std::filesystem::path& file, const LaneArguments& arguments, const LaneGraph& graph, Map map, std::string record, std::vector<std::string>& doubts) {
  if (graph.empty()) return refuse(file, "--scenario", "the map has no lanes and places", "an openTCS plant model (.xml) or an Open-RMF building (.building.yaml)");
  std::vector<std::size_t> ends;
  for (const auto& [name, option] : {std::pair{arguments.from, "--from"}, std::pair{arguments.to, "--to"}}) {
    if (name.empty()) return refuse(file, option, "it names no place", places_of(graph));
    const auto place = place_named(graph, name);
    if (!place) return refuse(file, option, fmt::format("there is no place \"{}\"", shortened(name)), places_of(graph));
    ends.push_back(*place);
  }
  if (ends[0] == ends[1]) return refuse(file, "--to", "both ends are the same place", "two places");

  Scenario scenario;
  if (arguments.vehicle) {
    auto read = read_vehicle(*arguments.vehicle);
    if (!read) return tl::unexpected{read.error()};
    scenario.vehicle = std::move(*read);
  } else {
    const auto sized = std::find_if(graph.vehicles.begin(), graph.vehicles.end(), [](const LaneVehicle& v) { return v.length > 0.0 && v.width > 0.0; });
    if (sized == graph.vehicles.end()) return refuse(file, "--vehicle", "the map tells no vehicle with a size", "a vehicle.json");
    scenario.vehicle = vehicle_of(*sized);
    doubts.push_back(fmt::format("the vehicle is {}, {:g} x {:g} m as the model has it, taken to turn on the spot: --vehicle names another", sized->name, sized->length, sized->width));
  }

  LaneRules rules;
  rules.width = arguments.lane_width.value_or(arguments.corridor.value_or(usual_width));
  if (!(rules.width > 0.0)) return refuse(file, "--lane-width", "it is not over 0", "metres");
  if (arguments.prefer && !(*arguments.prefer >= least_preference && *arguments.prefer < 1.0)) return refuse(file, "--prefer", fmt::format("{:g} is no factor that prefers", *arguments.prefer), "from 0.01 to under 1");
  rules.preference = arguments.prefer;
  rules.vehicle_speed = scenario.vehicle.limits.speed;
  auto zones = lane_zones(graph, rules);
  if (!zones) return refuse(file, "--lane-width", zones.error().problem, zones.error().allowed);
  doubts.insert(doubts.end(), zones->notes.begin(), zones->notes.end());

  const auto route = shortest_route(graph, ends[0], ends[1]);
  const std::string& from = graph.places[ends[0]].name;
  const std::string& to = graph.places[ends[1]].name;
  Json about{{"from", from}, {"to", to}, {"width", rules.width}};
  if (route) {
    for (const std::size_t place : route->places) about["route"].push_back(graph.places[place].name);
    about["route_length"] = route->length;
  } else {
    doubts.push_back(fmt::format("no lanes lead from {} to {}", from, to));
  }
  scenario.meta = Json{{"lanes", about}}.dump(-1, ' ', false, Json::error_handler_t::replace);
  scenario.name = fmt::format("{} to {}", from, to);
  scenario.start = pose_at(graph, ends[0], false, route);
  scenario.mission = pose_at(graph, ends[1], true, route);
  scenario.zones = std::move(zones->zones);
  // They keep to directions and weigh factors. Ways at any angle follow lanes better than moves from cell to cell, where the disc around the vehicle has room.
  const Footprint& footprint = scenario.vehicle.footprint;
  const bool is_round = footprint.is_disc() || (arguments.corridor && 2.0 * footprint.radius() < 0.9 * *arguments.corridor);
  scenario.planner.name = !scenario.vehicle.can_turn_on_the_spot() ? "clearance_optimal" : is_round ? "theta_star" : "astar";
  scenario.map = std::move(map);
  scenario.map_source = std::move(record);
  const auto problem = Problem::prepare(scenario);
  if (!problem) return tl::unexpected{problem.error()};
  if (const auto failure = problem->check_ends()) doubts.push_back(failure->reason);
  return scenario;
}

}  // namespace waywright::app
