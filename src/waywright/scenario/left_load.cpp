#include "waywright/scenario/left_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "waywright/map/world.hpp"
#include "waywright/scenario/outline.hpp"

namespace waywright {
namespace {

Ring placed(const Footprint& footprint, const Pose& pose) { return transformed(polygon_around(footprint), Frame{pose}); }

/// Do the two touch or overlap?
bool is_touching(const Ring& ring, const Footprint& footprint, const Pose& pose) {
  const Box box = bounding_box(ring);
  const Vec2 nearest{std::clamp(pose.x, box.low.x, box.high.x), std::clamp(pose.y, box.low.y, box.high.y)};
  if (distance(nearest, pose.position()) > footprint.radius() + 1e-6) return false;
  World world;
  world.add_obstacle(ring, "");
  world.build();
  return !world.is_free(footprint, pose, 0.0);
}

/// Where the leg ends, as far as that is known before.
std::optional<Pose> known_end(const Scenario& mission, const Leg& leg) {
  if (const auto* pose = std::get_if<Pose>(&leg.mission)) return *pose;
  const auto* station = std::get_if<Station>(&leg.mission);
  if (station == nullptr) return std::nullopt;
  if (station->manoeuvre == Manoeuvre::undock) return leg.exit;
  const Pose docked = station->shelf.docked(mission.vehicle.footprint.front());
  if (!station->insertion) return docked;
  return make_pose(docked.position() + (station->shelf.gap + station->insertion->depth) * unit(docked.heading), docked.heading);
}

}  // namespace

Ring outline_of(const Scenario& mission, const LeftLoad& load) {
  const auto known = mission.vehicle.loads.find(load.name);
  return known == mission.vehicle.loads.end() ? Ring{} : placed(known->second.footprint, load.pose);
}

std::string title_of(const LeftLoad& load) { return fmt::format("the load \"{}\" left where leg {} ends", load.name, load.leg + 1); }

bool is_taken_again(const Scenario& mission, std::size_t leg, const LeftLoad& load) {
  const Leg& taking = mission.legs[leg];
  if (taking.load.value_or("") != load.name) return false;
  const auto end = known_end(mission, taking);
  const auto known = mission.vehicle.loads.find(load.name);
  return end && known != mission.vehicle.loads.end() && is_touching(outline_of(mission, load), known->second.footprint, *end);
}

bool is_touching(const Scenario& mission, const LeftLoad& a, const LeftLoad& b) {
  const auto known = mission.vehicle.loads.find(b.name);
  return mission.vehicle.loads.contains(a.name) && known != mission.vehicle.loads.end() && is_touching(outline_of(mission, a), known->second.footprint, b.pose);
}

std::vector<LeftLoad> standing_on(const Scenario& mission, std::size_t leg, const std::vector<LeftLoad>& left) {
  std::vector<LeftLoad> standing;
  for (const LeftLoad& load : left) {
    if (load.is_clear && (leg >= mission.legs.size() || !is_taken_again(mission, leg, load))) standing.push_back(load);
  }
  return standing;
}

std::vector<LeftLoad> left_behind_on(const Scenario& mission, std::size_t leg, const std::vector<LeftLoad>& left) {
  std::vector<LeftLoad> behind;
  for (const LeftLoad& load : left) {
    if (!load.is_clear && !is_taken_again(mission, leg, load)) behind.push_back(load);
  }
  return behind;
}

std::vector<LeftLoad> left_after(const Scenario& mission, std::size_t leg, const std::vector<LeftLoad>& left, const std::string& carried, const Pose& end) {
  std::vector<LeftLoad> after;
  for (LeftLoad load : left) {
    if (is_taken_again(mission, leg, load)) continue;
    load.is_clear = load.is_clear || !is_touching(outline_of(mission, load), mission.vehicle.footprint, end);
    after.push_back(std::move(load));
  }
  const Leg& done = mission.legs[leg];
  if (!carried.empty() && done.load && *done.load != carried && mission.vehicle.loads.contains(carried)) after.push_back({carried, leg, end, false});
  return after;
}

}  // namespace waywright
