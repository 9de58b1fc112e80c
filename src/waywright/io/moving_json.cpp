#include "waywright/io/moving_json.hpp"

#include <fmt/format.h>

#include "waywright/io/vehicle_io.hpp"

namespace waywright {
namespace {

constexpr double shortest_step = 1e-6;      // s between points of a track
constexpr std::size_t most_points = 20'000;  // of all tracks of a scenario

MovingObstacle::Place read_place(const Node& node) {
  MovingObstacle::Place place;
  const bool has_heading = node.is_array() && node.json().size() == 4;
  if (!has_heading && !node.is_array_of(3, "[t, x, y] or [t, x, y, heading]")) return place;
  const auto coordinate = [&](std::size_t i) { return node.at(i).number(-largest_coordinate, largest_coordinate); };
  place.t = node.at(std::size_t{0}).number(0.0, latest_time);
  place.pose = {coordinate(1), coordinate(2), has_heading ? wrap(coordinate(3)) : 0.0};
  return place;
}

std::vector<MovingObstacle::Place> read_track(const Node& node) {
  std::vector<MovingObstacle::Place> track;
  if (node.is_array() && node.json().empty()) node.fail("a track without points", "at least one [t, x, y] or [t, x, y, heading]");
  if (node.is_array() && node.json().size() > most_track_points) node.fail(fmt::format("the track has {} points", node.json().size()), fmt::format("at most {}", most_track_points));
  if (node.failed()) return track;
  for (const Node& point : node.elements()) {
    track.push_back(read_place(point));
    if (node.failed()) return track;
    if (track.size() < 2) continue;
    const MovingObstacle::Place &a = track[track.size() - 2], &b = track.back();
    if (!(b.t >= a.t + shortest_step)) {
      point.at(std::size_t{0}).fail(fmt::format("{:g} s is not after the {:g} s of the point before", b.t, a.t), "times that rise by at least a microsecond");
      return track;
    }
    const double speed = distance(a.pose.position(), b.pose.position()) / (b.t - a.t);
    if (speed > fastest_obstacle) {
      point.fail(fmt::format("it is reached at {:g} m/s", speed), fmt::format("at most {:g} m/s", fastest_obstacle));
      return track;
    }
  }
  return track;
}

MovingObstacle read_one(const Node& node, std::vector<std::string>& notes) {
  MovingObstacle obstacle;
  if (!node.is_object()) {
    node.fail(fmt::format("it is {}", kind_of(node.json())), "an object");
    return obstacle;
  }
  if (!node.is_object_of({"name", "footprint", "track", "velocity", "spread", "seen", "range", "free_for", "patience"})) return obstacle;
  if (node.has("name")) obstacle.name = node.at("name").text();
  obstacle.footprint = read_footprint(node.at("footprint"), notes, largest_coordinate);
  if (node.has("track")) obstacle.track = read_track(node.at("track"));
  if (node.has("velocity")) obstacle.velocity = node.at("velocity").point(fastest_obstacle);
  const auto read = [&](const char* field, double& value, double high) {
    if (node.has(field)) value = node.at(field).number(0.0, high);
  };
  read("spread", obstacle.spread, fastest_obstacle);
  if (node.has("seen")) obstacle.seen = node.at("seen").number(-latest_time, 0.0);
  read("range", obstacle.range, 1e3);
  read("free_for", obstacle.free_for, latest_time);
  read("patience", obstacle.patience, latest_time);
  return obstacle;
}

}  // namespace

std::vector<MovingObstacle> read_moving(const Node& node, std::vector<std::string>& notes) {
  std::vector<MovingObstacle> moving;
  if (node.is_array() && node.json().size() > most_moving) {
    node.fail(fmt::format("there are {} obstacles", node.json().size()), fmt::format("at most {}", most_moving));
    return moving;
  }
  std::size_t points = 0;
  for (const Node& one : node.elements()) {
    moving.push_back(read_one(one, notes));
    if (node.failed()) break;
    points += moving.back().track.size();
    if (points > most_points) {
      node.fail("the tracks have too many points", fmt::format("at most {} in all", most_points));
      break;
    }
  }
  return moving;
}

Json moving_to_json(const std::vector<MovingObstacle>& moving) {
  Json all = Json::array();
  for (const MovingObstacle& obstacle : moving) {
    Json j = Json::object();
    if (!obstacle.name.empty()) j["name"] = obstacle.name;
    j["footprint"] = footprint_to_json(obstacle.footprint);
    Json track = Json::array();
    for (const auto& [t, pose] : obstacle.track) track.push_back(Json::array({t, pose.x, pose.y, pose.heading}));
    j["track"] = std::move(track);
    j["velocity"] = to_json(obstacle.velocity);
    j["spread"] = obstacle.spread;
    if (obstacle.seen != 0.0) j["seen"] = obstacle.seen;
    j["range"] = obstacle.range;
    j["free_for"] = obstacle.free_for;
    j["patience"] = obstacle.patience;
    all.push_back(std::move(j));
  }
  return all;
}

}  // namespace waywright
