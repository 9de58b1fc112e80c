#include "waywright/io/mission_json.hpp"

#include <fmt/format.h>

#include "waywright/io/map_json.hpp"
#include "waywright/io/scenario_json.hpp"
#include "waywright/io/vehicle_io.hpp"
#include "waywright/scenario/legs.hpp"

namespace waywright {
namespace {

constexpr double longest = 1e4;  // m, of shelves and gaps
constexpr std::size_t most_pockets = 1000;
constexpr std::size_t most_waypoints = 1000;
constexpr std::size_t most_region_corners = 500;

void doubt(const Node& heading, std::vector<std::string>& notes) {
  if (heading.failed() || !heading.json().is_number()) return;
  if (const auto sentence = heading_doubt(heading.json().get<double>())) notes.push_back(heading.path() + ": " + *sentence);
}

Shelf read_shelf(const Node& node) {
  Shelf shelf;
  if (!node.is_object_of({"center", "heading", "size", "gap", "slot"})) return shelf;
  shelf.center = node.at("center").point();
  shelf.heading = wrap(node.at("heading").number(-1e6, 1e6));
  const Node size = node.at("size");
  if (!size.is_array_of(2, "[depth, width]")) return shelf;
  shelf.depth = size.at(std::size_t{0}).number_above(0.0, longest);
  shelf.width = size.at(1).number_above(0.0, longest);
  if (node.failed()) return shelf;
  if (node.has("gap")) shelf.gap = node.at("gap").number(0.0, longest);
  if (node.has("slot")) shelf.slot = node.at("slot").number(-0.5 * shelf.width, 0.5 * shelf.width);
  return shelf;
}

Insertion read_insertion(const Node& node, const Shelf& shelf) {
  Insertion insertion;
  if (!node.is_object_of({"depth", "pockets"})) return insertion;
  insertion.depth = node.at("depth").number_above(0.0, shelf.depth);
  const Node pockets = node.at("pockets");
  for (const Node& pocket : pockets.elements()) {
    if (!pocket.is_array_of(2, "[y0, y1]")) return insertion;
    const auto edge = [&](std::size_t i) { return pocket.at(i).number(-0.5 * shelf.width, 0.5 * shelf.width); };
    insertion.pockets.push_back({edge(0), edge(1)});
    if (node.failed()) return insertion;
    const auto [right, left] = insertion.pockets.back();
    if (!(right < left)) pocket.fail(fmt::format("[{}, {}] has no width", right, left), "[y0, y1] with y0 < y1");
  }
  if (insertion.pockets.empty()) pockets.fail("there is no pocket", "at least one [y0, y1]");
  if (insertion.pockets.size() > most_pockets) {
    pockets.fail(fmt::format("there are {} pockets", insertion.pockets.size()), fmt::format("at most {}", most_pockets));
  }
  return insertion;
}

Station read_station(const Node& node, std::vector<std::string>& notes) {
  Station station;
  if (!node.is_object_of({"area", "shelf", "manoeuvre", "insertion"})) return station;
  if (node.has("manoeuvre") && node.at("manoeuvre").word({"dock", "undock"}) == "undock") station.manoeuvre = Manoeuvre::undock;
  station.area = read_ring(node.at("area"), notes);
  if (!node.failed()) station.shelf = read_shelf(node.at("shelf"));
  if (node.has("insertion") && !node.failed()) station.insertion = read_insertion(node.at("insertion"), station.shelf);
  if (!node.failed()) doubt(node.at("shelf").at("heading"), notes);
  return station;
}

std::vector<Vec2> read_waypoints(const Node& node) {
  if (node.is_array() && node.json().empty()) return {};
  std::vector<Vec2> waypoints = node.points();
  if (waypoints.size() > most_waypoints) node.fail(fmt::format("it has {} points", waypoints.size()), fmt::format("at most {}", most_waypoints));
  return waypoints;
}

/// Which of these mission fields the object has; exactly one of them must be there.
std::string only_mission(const Node& node, std::initializer_list<const char*> fields, const char* allowed) {
  std::vector<std::string> given;
  for (const char* mission : fields) {
    if (node.has(mission)) given.emplace_back(mission);
  }
  if (given.size() == 1) return given.front();
  const std::string within = node.path().empty() ? "" : node.path() + ".";
  std::string names;
  for (const std::string& name : given) names += (names.empty() ? "" : ", ") + within + name;
  node.context().fail(given.empty() ? within + "goal" : names, given.empty() ? "the mission is missing" : "more than one mission is given", allowed);
  return {};
}

Mission read_goal(const Node& goal, std::vector<std::string>& notes) {
  if (goal.is_object()) {
    FreeGoal free;
    if (!goal.is_object_of({"region"})) return free;
    const Node region = goal.at("region");
    if (region.is_array() && region.json().size() > most_region_corners) region.fail(fmt::format("the polygon has {} corners", region.json().size()), fmt::format("at most {}", most_region_corners));
    free.area = read_ring(region, notes);
    return free;
  }
  if (goal.is_array() && goal.json().size() == 2) return FreeGoal{{goal.point()}};
  if (!goal.is_array() || goal.json().size() != 3) {
    goal.fail(goal.is_array() ? fmt::format("it has {} element{}", goal.json().size(), goal.json().size() == 1 ? "" : "s") : fmt::format("it is {}", kind_of(goal.json())),
              "[x, y, heading]; [x, y] with any heading; {\"region\": polygon}");
    return Pose{};
  }
  const Pose pose = goal.pose();
  doubt_pose(goal, notes);
  return pose;
}

void read_waypoints_of(const Node& node, std::vector<Vec2>& waypoints, double& radius) {
  if (node.has("waypoints")) waypoints = read_waypoints(node.at("waypoints"));
  if (!node.has("waypoint_radius")) return;
  radius = node.at("waypoint_radius").number(0.0, 1e3);
  if (waypoints.empty()) node.at("waypoint_radius").fail("there are no waypoints", "no such field");
}

/// The name of a load, or null where what is carried is left.
std::string read_load(const Node& node) {
  if (node.json().is_null()) return {};
  if (!node.json().is_string()) {
    node.fail(fmt::format("it is {}", kind_of(node.json())), "the name of a load, or null");
    return {};
  }
  std::string name = node.text();
  if (name.empty()) node.fail("the name is empty", "the name of a load, or null");
  return name;
}

Leg read_leg(const Node& node, std::vector<std::string>& notes) {
  Leg leg;
  if (!node.is_object_of({"name", "goal", "station", "waypoints", "waypoint_radius", "load", "planner"})) return leg;
  if (node.has("name")) leg.name = node.at("name").text();
  if (node.has("station")) {
    const Station station = read_station(node.at("station"), notes);
    const bool is_way_out = station.manoeuvre == Manoeuvre::undock;
    leg.mission = station;
    if (is_way_out) {
      const Node exit = node.at("goal");
      if (exit.missing()) exit.fail("", "a pose [x, y, heading]: where the way out of the station ends");
      leg.exit = exit.pose();
      doubt_pose(exit, notes);
    } else if (node.has("goal")) {
      node.at("goal").fail("it stands beside a station to dock at", "it goes with \"manoeuvre\": \"undock\"");
    }
  } else if (!only_mission(node, {"goal", "station"}, "one of goal, station; with \"undock\" both").empty()) {
    leg.mission = read_goal(node.at("goal"), notes);
  }
  if (!node.failed()) read_waypoints_of(node, leg.waypoints, leg.waypoint_radius);
  if (node.has("load")) leg.load = read_load(node.at("load"));
  if (node.has("planner")) leg.planner = read_planner(node.at("planner"));
  return leg;
}

void read_legs(const Node& whole, Scenario& scenario) {
  for (const char* field : {"waypoints", "waypoint_radius"}) {
    if (whole.has(field)) return whole.at(field).fail("it stands beside legs", "waypoints of a leg");
  }
  const Node legs = whole.at("legs");
  const std::vector<Node> nodes = legs.elements();
  if (legs.failed()) return;
  if (nodes.empty() || nodes.size() > most_legs) {
    return legs.fail(nodes.empty() ? "there is none" : fmt::format("there are {}", nodes.size()), fmt::format("1 to {}", most_legs));
  }
  for (const Node& node : nodes) {
    Leg leg = read_leg(node, scenario.map.notes);
    if (whole.failed()) return;
    if (!leg.planner && !whole.has("planner")) {
      if (std::string usual = usual_planner(leg.mission, leg.waypoints, scenario.vehicle); usual != PlannerChoice{}.name) leg.planner = PlannerChoice{std::move(usual), {}};
    }
    scenario.legs.push_back(std::move(leg));
  }
  if (!whole.has("order")) return;
  const std::string order = whole.at("order").word({"given", "best", "best_to_last"});
  scenario.order = order == "best" ? LegOrder::best : order == "best_to_last" ? LegOrder::best_to_last : LegOrder::given;
}

Json station_to_json(const Station& station) {
  const Shelf& shelf = station.shelf;
  Json j{{"area", to_json(station.area)},
         {"shelf",
          {{"center", to_json(shelf.center)},
           {"heading", shelf.heading},
           {"size", Json::array({shelf.depth, shelf.width})},
           {"gap", shelf.gap},
           {"slot", shelf.slot}}},
         {"manoeuvre", station.manoeuvre == Manoeuvre::dock ? "dock" : "undock"}};
  if (!station.insertion) return j;
  Json pockets = Json::array();
  for (const auto& [right, left] : station.insertion->pockets) pockets.push_back(Json::array({right, left}));
  j["insertion"] = {{"depth", station.insertion->depth}, {"pockets", std::move(pockets)}};
  return j;
}

void mission_to_json(const Mission& mission, const std::vector<Vec2>& waypoints, double radius, Json& j) {
  if (const auto* station = std::get_if<Station>(&mission)) {
    j["station"] = station_to_json(*station);
  } else if (const auto* free = std::get_if<FreeGoal>(&mission)) {
    j["goal"] = free->is_point() ? to_json(free->area.front()) : Json{{"region", to_json(free->area)}};
  } else {
    j["goal"] = to_json(std::get<Pose>(mission));
  }
  if (waypoints.empty()) return;
  Json points = Json::array();
  for (const Vec2 p : waypoints) points.push_back(to_json(p));
  j["waypoints"] = std::move(points);
  j["waypoint_radius"] = radius;
}

Json leg_to_json(const Leg& leg) {
  Json j = Json::object();
  if (!leg.name.empty()) j["name"] = leg.name;
  mission_to_json(leg.mission, leg.waypoints, leg.waypoint_radius, j);
  const auto* station = std::get_if<Station>(&leg.mission);
  if (station != nullptr && station->manoeuvre == Manoeuvre::undock) j["goal"] = to_json(leg.exit);
  if (leg.load) j["load"] = leg.load->empty() ? Json(nullptr) : Json(*leg.load);
  if (leg.planner) j["planner"] = parameters_to_json(leg.planner->parameters, &leg.planner->name);
  return j;
}

}  // namespace

void doubt_pose(const Node& pose, std::vector<std::string>& notes) {
  if (!pose.failed() && pose.is_array() && pose.json().size() == 3) doubt(pose.at(2), notes);
}

PlannerChoice read_planner(const Node& node) {
  PlannerChoice choice;
  if (node.is_object()) choice.name = node.at("name").text();
  choice.parameters = read_parameters(node);
  return choice;
}

std::string usual_planner(const Mission& mission, const std::vector<Vec2>& waypoints, const Vehicle& vehicle) {
  if (!waypoints.empty()) return planner_through_waypoints;
  const bool is_goal = std::holds_alternative<FreeGoal>(mission) || (std::holds_alternative<Pose>(mission) && vehicle.can_turn_on_the_spot() && vehicle.forks.empty());
  return is_goal ? planner_to_goals : PlannerChoice{}.name;
}

void read_whole_mission(const Node& node, Scenario& scenario) {
  if (node.failed()) return;
  const std::string mission = only_mission(node, {"goal", "station", "legs"}, "exactly one of goal, station, legs");
  std::vector<std::string>& notes = scenario.map.notes;
  if (mission == "legs") return read_legs(node, scenario);
  if (node.has("order")) return node.at("order").fail("there are no legs to be ordered", "a mission in legs");
  if (mission == "station") scenario.mission = read_station(node.at("station"), notes);
  if (mission == "goal") scenario.mission = read_goal(node.at("goal"), notes);
  if (!mission.empty()) read_waypoints_of(node, scenario.waypoints, scenario.waypoint_radius);
}

void mission_to_json(const Scenario& scenario, Json& json) {
  if (scenario.legs.empty()) return mission_to_json(scenario.mission, scenario.waypoints, scenario.waypoint_radius, json);
  Json legs = Json::array();
  for (const Leg& leg : scenario.legs) legs.push_back(leg_to_json(leg));
  json["legs"] = std::move(legs);
  if (scenario.order != LegOrder::given) json["order"] = scenario.order == LegOrder::best ? "best" : "best_to_last";
}

}  // namespace waywright
