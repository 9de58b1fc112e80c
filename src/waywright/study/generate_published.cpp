#include "waywright/core/elementary.hpp"
#include "waywright/map/field_worlds.hpp"
#include "waywright/map/published_maps.hpp"
#include "waywright/map/whale_maps.hpp"
#include "waywright/study/generate.hpp"

namespace waywright {
namespace {

Vehicle point_robot() {
  Vehicle point;
  point.name = "a point that turns on the spot";
  point.footprint.disc = 0.0;
  point.drive = Differential{0.5};
  return point;
}

}  // namespace

std::optional<Scenario> published_scenario(std::string_view name) {
  Scenario scenario;
  PublishedTask task;
  if (auto hall = whale_map(name)) {
    scenario.name = hall->name + ", " + hall->about;
    scenario.map = std::move(hall->map);
    task = hall->task;
  } else if (auto world = field_world(name)) {
    scenario.name = world->name + ", " + world->about;
    scenario.map = std::move(world->map);
    task = world->tasks.front();
  } else if (auto cells = published_map(name)) {
    scenario.name = cells->name;
    scenario.map.grids.push_back(std::move(cells->grid));
    task = cells->tasks.front();
  } else {
    return std::nullopt;
  }
  scenario.map_source = R"({"kind":"generate","name":")" + std::string{name} + "\"}";  // a map's name needs no escapes
  scenario.vehicle = point_robot();
  const Vec2 way = task.goal - task.start;
  scenario.start = make_pose(task.start, arc_tangent(way.y, way.x));
  scenario.mission = make_pose(task.goal, scenario.start.heading);
  scenario.planner.name = "astar";
  return scenario;
}

}  // namespace waywright
