// A scenario between two places of a map's lanes: what `map --scenario` writes.
#include "map_scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "waywright/core/angle.hpp"
#include "waywright/core/spelling.hpp"
#include "waywright/io/json_reader.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/scenario/lane_zones.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright::app {
namespace {

constexpr double usual_width = 1.0;      // m, of lanes' zones
constexpr std::size_t most_named = 30;   // in a refusal
// Of a corridor's width, the disc about a vehicle that turns in it: a cell is a fortieth of the width, strips are up to 1.5 cells narrower on either side, and ways from cell to
// cell want one to either side where they lead across a bend.
constexpr double corridor_share = 2.0 * (0.5 - (1.5 + 1.0) / 40.0);
constexpr double steps_a_metre = 20.0;    // to which widths are rounded up
constexpr double usual_cell = 0.05;      // m, of planners over cells, where the map has none

tl::unexpected<InputError> refuse(const std::filesystem::path& file, const char* field, std::string problem, std::string allowed) {
  return tl::unexpected{InputError{file.string(), field, std::move(problem), std::move(allowed)}};
}

std::string places_of(const LaneGraph& graph) {
  std::string names;
  for (std::size_t i = 0; i < std::min(graph.places.size(), most_named); ++i) names += (i == 0 ? "" : ", ") + graph.places[i].name;
  if (graph.places.size() > most_named) names += fmt::format(" and {} more: see map without --scenario", graph.places.size() - most_named);
  return names;
}

/// What an end may be called.
std::vector<std::string> names_of(const LaneGraph& graph) {
  std::vector<std::string> names;
  for (const LanePlace& place : graph.places) names.push_back(place.name);
  for (const LaneStation& station : graph.stations) names.push_back(station.name);
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

/// Has the disc about the vehicle room all along a route?
bool turns_anywhere(const LaneGraph& graph, const LaneRoute& route, const Problem& problem) {
  const Footprint disc{{}, problem.footprint().radius()};
  const std::vector<CellGrid>& grids = problem.scenario().map.grids;
  const double beside = 0.7072 * (grids.empty() ? usual_cell : grids.front().cell);  // to the next cell's middle
  const auto is_free = [&](Vec2 p) { return problem.world().is_free(disc, make_pose(p, 0.0), problem.required_clearance() + beside); };
  for (const LaneRoute::Step& step : route.steps) {
    const Polyline& course = graph.lanes[step.lane].course;
    for (std::size_t i = 0; i + 1 < course.size(); ++i) {
      const int parts = std::max(1, static_cast<int>(std::ceil(distance(course[i], course[i + 1]) / usual_cell)));
      for (int k = 0; k <= parts; ++k) {
        if (!is_free(course[i] + (static_cast<double>(k) / parts) * (course[i + 1] - course[i]))) return false;
      }
    }
  }
  return true;
}

/// m that a radian of turning on the spot is worth: a stop for a quarter turn loses the time of braking and of gaining speed again.
double cost_of_turning(const Limits& limits) {
  const double lost = 0.5 * limits.speed * limits.speed * (1.0 / limits.acceleration + 1.0 / limits.deceleration);
  return std::min(100.0, std::ceil(10.0 * lost / (0.5 * std::numbers::pi)) / 10.0);
}

/// They keep to directions and weigh factors. Ways at any angle follow lanes better than moves from cell to cell, where the disc about the vehicle has room.
PlannerChoice planner_for(const LaneGraph& graph, const std::optional<LaneRoute>& route, const Problem& problem, double preference) {
  if (!problem.vehicle().can_turn_on_the_spot()) return {"clearance_optimal", {}};
  if (problem.footprint().is_disc() || (route && turns_anywhere(graph, *route, problem))) return {"theta_star", {}};
  return {"astar", {{"turn_cost", preference * cost_of_turning(problem.vehicle().limits)}}};
}

/// How a user called one end, and which place that is.
std::string title_of_end(const std::string& asked, const LanePlace& place) { return one_line(asked) == place.name ? place.name : one_line(asked); }

}  // namespace

Parsed<Vehicle> vehicle_on_lanes(const std::filesystem::path& file, const LaneArguments& arguments, const LaneGraph& graph, std::vector<std::string>& doubts) {
  if (arguments.vehicle) return read_vehicle(*arguments.vehicle);
  const auto sized = std::find_if(graph.vehicles.begin(), graph.vehicles.end(), [](const LaneVehicle& v) { return v.length > 0.0 && v.width > 0.0; });
  if (sized == graph.vehicles.end()) return refuse(file, "--vehicle", "the map tells no vehicle with a size (an Open-RMF building never does), and what drives there has to be known", "--vehicle FILE.json beside it, as examples/vehicles has them");
  doubts.push_back(fmt::format("the vehicle is {}, {:g} x {:g} m as the model has it, taken to turn on the spot: --vehicle names another", sized->name, sized->length, sized->width));
  return vehicle_of(*sized);
}

double corridor_for(const Vehicle& vehicle) {
  const double width = 2.0 * vehicle.footprint.radius() / corridor_share;
  return std::max(usual_width, std::ceil(width * steps_a_metre) / steps_a_metre);
}

Parsed<Scenario> scenario_along_lanes(const std::filesystem::path& file, const LaneArguments& arguments, const LaneGraph& graph, Map map, std::string record, std::vector<std::string>& doubts) {
  if (graph.empty()) return refuse(file, "--scenario", "the map has no lanes and places", "an openTCS plant model (.xml) or an Open-RMF building (.building.yaml)");
  std::vector<std::size_t> ends;
  for (const auto& [name, option] : {std::pair{arguments.from, "--from"}, std::pair{arguments.to, "--to"}}) {
    if (name.empty()) return refuse(file, option, "it names no place", places_of(graph));
    const auto place = place_named(graph, name);
    if (!place) return refuse(file, option, fmt::format("there is no place \"{}\"{}", shortened(name), meant_instead(name, names_of(graph))), places_of(graph));
    ends.push_back(*place);
  }
  if (ends[0] == ends[1]) return refuse(file, "--to", "both ends are the same place", "two places");

  Scenario scenario;
  auto vehicle = vehicle_on_lanes(file, arguments, graph, doubts);
  if (!vehicle) return tl::unexpected{vehicle.error()};
  scenario.vehicle = std::move(*vehicle);

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
  const std::string from = title_of_end(arguments.from, graph.places[ends[0]]), to = title_of_end(arguments.to, graph.places[ends[1]]);
  Json about{{"from", from}, {"to", to}, {"width", rules.width}};
  if (route) {
    for (const std::size_t place : route->places) about["route"].push_back(graph.places[place].name);
    about["route_length"] = route->length;
  } else {
    doubts.push_back(fmt::format("no lanes lead from {} to {}", from, to));
  }
  // For what a plan says of them and its picture shows: to a tenth of a millimetre.
  const auto rounded = [](double metres) { return std::round(1e4 * metres) / 1e4; };
  for (const Lane& lane : graph.lanes) {
    Json course = Json::array();
    for (const Vec2 p : lane.course) course.push_back(Json::array({rounded(p.x), rounded(p.y)}));
    about["courses"].push_back(std::move(course));
    about["one_way"].push_back(!lane.is_both_ways);
  }
  scenario.meta = Json{{"lanes", about}}.dump(-1, ' ', false, Json::error_handler_t::replace);
  scenario.name = fmt::format("{} to {}", from, to);
  scenario.start = pose_at(graph, ends[0], false, route);
  scenario.mission = pose_at(graph, ends[1], true, route);
  scenario.zones = std::move(zones->zones);
  scenario.map = std::move(map);
  scenario.map.notes.clear();  // `map` tells them, the record keeps them; each plan need not repeat them
  scenario.map_source = std::move(record);
  const auto problem = Problem::prepare(scenario);
  if (!problem) return tl::unexpected{problem.error()};
  if (const auto failure = problem->check_ends()) doubts.push_back(failure->reason);
  scenario.planner = planner_for(graph, route, *problem, arguments.prefer.value_or(1.0));
  return scenario;
}

}  // namespace waywright::app
