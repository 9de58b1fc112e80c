#include "waywright/scenario/legs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>

namespace waywright {
namespace {

constexpr double same_place = 1e-6;  // m and rad: the proof's own tolerance of ends

const Station* station_of(const Leg& leg) { return std::get_if<Station>(&leg.mission); }

/// What tells two shelves apart: where they stand and how large they are.
std::array<double, 5> place_of(const Shelf& shelf) { return {shelf.center.x, shelf.center.y, shelf.heading, shelf.depth, shelf.width}; }

struct NumberedShelf {
  const Shelf* shelf;
  std::size_t leg;
};

/// Of all legs' shelves each once, without those that are `own`.
std::vector<NumberedShelf> shelves_beside(const Scenario& mission, const Station* own) {
  std::vector<NumberedShelf> found;
  std::set<std::array<double, 5>> known;
  if (own != nullptr) known.insert(place_of(own->shelf));
  for (std::size_t i = 0; i < mission.legs.size(); ++i) {
    const Station* station = station_of(mission.legs[i]);
    if (station != nullptr && known.insert(place_of(station->shelf)).second) found.push_back({&station->shelf, i});
  }
  return found;
}

/// The map's world with the shelves of other legs and the loads that stand there, by their names.
World furnished(const Scenario& mission, const Station* own, const std::vector<LeftLoad>& standing, const World& of_map) {
  World world = of_map;
  for (const auto& [shelf, leg] : shelves_beside(mission, own)) world.add_obstacle(shelf->outline(), fmt::format("the shelf of leg {}", leg + 1));
  for (const LeftLoad& load : standing) world.add_obstacle(outline_of(mission, load), title_of(load));
  return world;
}

/// All but mission, start and load.
Scenario shared_part(const Scenario& mission) {
  Scenario scenario = mission;
  scenario.legs.clear();
  scenario.order = LegOrder::given;
  scenario.waypoints.clear();
  scenario.start_motion = {};
  return scenario;
}

/// Which leg the load changed at last before this one; empty: it is as at the beginning.
std::optional<std::size_t> load_changed_by(const Scenario& mission, std::size_t index) {
  for (std::size_t i = std::min(index, mission.legs.size()); i-- > 0;) {
    if (mission.legs[i].load) return i;
  }
  return std::nullopt;
}

bool is_region(const Leg& leg) {
  const auto* free = std::get_if<FreeGoal>(&leg.mission);
  return free != nullptr && !free->is_point();
}

bool is_way_out(const Leg& leg) { return station_of(leg) != nullptr && station_of(leg)->manoeuvre == Manoeuvre::undock; }

}  // namespace

LegBegin first_leg(const Scenario& mission) { return {0, mission.start, mission.carried_load, {}}; }

LegBegin next_leg(const Scenario& mission, const LegBegin& leg, const Pose& end) {
  return {leg.index + 1, end, mission.legs[leg.index].load.value_or(leg.load), left_after(mission, leg.index, leg.left, leg.load, end)};
}

bool is_standing(const Scenario& mission, const LegBegin& begin) {
  const Leg& leg = mission.legs[begin.index];
  const auto* goal = std::get_if<Pose>(&leg.mission);
  if (goal == nullptr || !leg.load || !leg.waypoints.empty() || (begin.index == 0 && mission.start_motion.speed != 0.0)) return false;
  return distance(goal->position(), begin.pose.position()) <= same_place && std::abs(shorter_turn(goal->heading, begin.pose.heading)) <= same_place;
}

std::string leg_label(const Scenario& mission, std::size_t index) {
  const std::string& name = mission.legs[index].name;
  return fmt::format("leg {} of {}{}", index + 1, mission.legs.size(), name.empty() ? "" : " (" + name + ")");
}

const PlannerChoice& planner_of(const Scenario& mission, const Leg& leg) { return leg.planner ? *leg.planner : mission.planner; }

InputError error_of_leg(const Scenario& mission, const LegBegin& leg, InputError error) {
  const std::string field = error.field;
  const std::size_t index = std::min(leg.index, mission.legs.size() - 1);
  if (field == "carried_load") {
    if (const auto taken = load_changed_by(mission, leg.index)) error.field = fmt::format("legs[{}].load", *taken);
    return error;
  }
  const bool is_own_planner = mission.legs[index].planner.has_value();
  for (const std::string_view of_leg : {"station", "goal", "waypoints", "waypoint_radius", "planner", "budget"}) {
    if (!field.starts_with(of_leg)) continue;
    if (of_leg == "budget" || (of_leg == "planner" && !is_own_planner)) {
      error.problem = fmt::format("{}: {}", leg_label(mission, index), error.problem);
    } else {
      error.field = fmt::format("legs[{}].{}", index, field);
    }
    break;
  }
  return error;
}

Scenario leg_scenario(const Scenario& mission, const LegBegin& begin) {
  const Leg& leg = mission.legs[begin.index];
  Scenario scenario = shared_part(mission);
  scenario.name = leg.name;
  scenario.mission = leg.mission;
  scenario.start = is_way_out(leg) ? leg.exit : begin.pose;
  if (begin.index == 0) scenario.start_motion = mission.start_motion;
  scenario.waypoints = leg.waypoints;
  scenario.waypoint_radius = leg.waypoint_radius;
  scenario.carried_load = begin.load;
  scenario.planner = planner_of(mission, leg);
  for (const auto& [shelf, unused] : shelves_beside(mission, station_of(leg))) scenario.map.obstacles.push_back(shelf->outline());
  for (const LeftLoad& load : standing_on(mission, begin.index, begin.left)) scenario.map.obstacles.push_back(outline_of(mission, load));
  return scenario;
}

Parsed<Problem> prepare_leg(const Scenario& mission, const LegBegin& begin, const World& of_map) {
  const Leg& leg = mission.legs[begin.index];
  const World world = furnished(mission, station_of(leg), standing_on(mission, begin.index, begin.left), of_map);
  auto problem = Problem::prepare(leg_scenario(mission, begin), &world);
  if (!problem) return tl::unexpected{error_of_leg(mission, begin, problem.error())};
  if (problem->is_driven_back()) {
    const Pose& shelf = problem->first_pose();
    const double apart = distance(shelf.position(), begin.pose.position());
    const double turned = std::abs(shorter_turn(shelf.heading, begin.pose.heading));
    if (apart > same_place || turned > same_place) {
      return tl::unexpected{InputError{"", fmt::format("legs[{}].station", begin.index),
                                       fmt::format("the way out of the shelf begins at ({:.7f}, {:.7f}, {:.7f}), and the vehicle stands at ({:.7f}, {:.7f}, {:.7f}) then, {:.3g} m "
                                                   "and {:.3g} rad away",
                                                   shelf.x, shelf.y, shelf.heading, begin.pose.x, begin.pose.y, begin.pose.heading, apart, turned),
                                       begin.index == 0 ? "a start in the shelf" : "a leg before it that ends in the shelf"}};
    }
  }
  return problem;
}

Pose end_of(const Problem& problem, const Path& path) { return problem.free_goal() != nullptr && !path.pieces.empty() ? end_pose(path) : problem.last_pose(); }

Parsed<void> check_legs(const Scenario& mission) {
  if (mission.legs.size() > most_legs) {
    return tl::unexpected{InputError{"", "legs", fmt::format("there are {}", mission.legs.size()), fmt::format("at most {}", most_legs)}};
  }
  Scenario without_map = mission;
  without_map.map = {};
  const World empty;
  LegBegin begin = first_leg(without_map);
  while (begin.index < mission.legs.size()) {
    auto problem = prepare_leg(without_map, begin, empty);
    // After a region nobody knows yet where this leg begins.
    if (!problem && begin.index > 0 && is_region(mission.legs[begin.index - 1]) && problem.error().field.starts_with(fmt::format("legs[{}].waypoints[0]", begin.index))) {
      Scenario direct = without_map;
      direct.legs[begin.index].waypoints.erase(direct.legs[begin.index].waypoints.begin());
      problem = prepare_leg(direct, begin, empty);
    }
    if (!problem) return tl::unexpected{problem.error()};
    const std::string taken = mission.legs[begin.index].load.value_or("");
    if (!taken.empty() && !begin.load.empty()) {
      const auto since = load_changed_by(mission, begin.index);
      return tl::unexpected{InputError{"", fmt::format("legs[{}].load", begin.index),
                                       fmt::format("\"{}\" is taken while \"{}\" is carried, {}", taken, begin.load, since ? fmt::format("since leg {}", *since + 1) : std::string{"from the beginning"}),
                                       "a load where none is carried: let a leg before it end with \"load\": null"}};
    }
    begin = next_leg(without_map, begin, problem->last_pose());
  }
  if (const auto last = check_last_load(without_map, begin, empty); !last) return tl::unexpected{last.error()};
  return {};
}

Failure told_of_load(const Scenario& mission, const LegBegin& leg, Failure failure) {
  const bool at_start = failure.status == Status::start_in_collision || failure.status == Status::start_outside;
  if (!at_start || leg.index == 0 || !mission.legs[leg.index - 1].load.value_or("").size()) return failure;
  failure.reason = fmt::format("the load \"{}\", taken where leg {} ends, does not fit there: {}", leg.load, leg.index, failure.reason);
  return failure;
}

Parsed<std::optional<Failure>> check_last_load(const Scenario& mission, const LegBegin& end, const World& of_map) {
  if (mission.legs.back().load.value_or("").empty()) return std::optional<Failure>{};
  const Station* station = station_of(mission.legs.back());
  const bool in_shelf = station != nullptr && station->insertion && station->manoeuvre == Manoeuvre::dock;
  Scenario standing = shared_part(mission);
  standing.carried_load = end.load;
  standing.start = end.pose;
  standing.mission = end.pose;
  if (in_shelf) {  // as the way out would begin
    Station out = *station;
    out.manoeuvre = Manoeuvre::undock;
    standing.mission = out;
  }
  const World world = furnished(mission, in_shelf ? station : nullptr, standing_on(mission, end.index, end.left), of_map);
  auto problem = Problem::prepare(standing, &world);
  if (problem && in_shelf) {  // only the pose in the shelf is asked for: the docked one of the loaded vehicle stands for the other end
    standing.start = problem->goal();
    problem = Problem::prepare(standing, &world);
  }
  if (!problem) return tl::unexpected{error_of_leg(mission, end, problem.error())};
  auto failure = problem->check_ends();
  if (!failure) return std::optional<Failure>{};
  failure->status = failure->status == Status::start_outside || failure->status == Status::goal_outside ? Status::goal_outside : Status::goal_in_collision;
  failure->reason = fmt::format("the load \"{}\", taken at its end, does not fit there: {}", end.load, failure->reason);
  return failure;
}

}  // namespace waywright
