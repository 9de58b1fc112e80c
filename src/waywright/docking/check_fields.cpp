#include "waywright/docking/check_fields.hpp"

#include <fmt/format.h>

#include <cmath>

namespace waywright {
namespace {

constexpr double largest_coordinate = 1e6;  // m
constexpr double longest = 1e3;             // m, of vehicles
constexpr std::size_t most_corners = 1000;  // of a footprint

class Checker {
 public:
  std::optional<InputError> error;

  void number(const char* field, double value, double low, double high, bool low_allowed = true) {
    if (error || (std::isfinite(value) && value <= high && (low_allowed ? value >= low : value > low))) return;
    refuse(field, fmt::format("{} is out of range", value), fmt::format("{}{} to {}", low_allowed ? "" : "above ", low, high));
  }
  void number(const char* field, const std::optional<double>& value, double low, double high) {
    if (value) number(field, *value, low, high, false);
  }
  void point(const char* field, Vec2 p) {
    number(field, p.x, -largest_coordinate, largest_coordinate);
    number(field, p.y, -largest_coordinate, largest_coordinate);
  }
  void pose(const char* field, Pose& p) {
    point(field, p.position());
    number(field, p.heading, -1e6, 1e6);
    if (!error) p.heading = wrap(p.heading);
  }
  void ring(const char* field, Ring& ring) {
    for (const Vec2 p : ring) point(field, p);
    if (error) return;
    RingRepair repair = repair_ring(std::move(ring));
    if (repair.refused) return refuse(field, *repair.refused, "a simple polygon of at least 3 corners with an area");
    ring = std::move(repair.ring);
  }
  void rings(const char* field, std::vector<Ring>& rings) {
    for (Ring& one : rings) ring(field, one);
  }
  void footprint(const char* field, Footprint& footprint) {
    if (footprint.is_disc()) return number(field, footprint.disc, 0.0, longest);
    if (footprint.polygon.size() > most_corners) {
      return refuse(field, fmt::format("the polygon has {} corners", footprint.polygon.size()), fmt::format("at most {}", most_corners));
    }
    ring(field, footprint.polygon);
    if (!error) number(field, footprint.radius(), 0.0, longest);
  }

 private:
  void refuse(const char* field, std::string problem, std::string allowed) {
    if (!error) error = InputError{"", field, std::move(problem), std::move(allowed)};
  }
};

void check_drive(Checker& check, const Drive& drive) {
  if (const auto* t = std::get_if<Tricycle>(&drive)) {
    check.number("vehicle.drive.wheelbase", t->wheelbase, 0.0, longest, false);
    check.number("vehicle.drive.max_steering", t->max_steering, 0.0, 0.4999 * pi, false);
    check.number("vehicle.drive.max_steering_rate", t->max_steering_rate, 0.0, 1e3);
  } else if (const auto* d = std::get_if<Differential>(&drive)) {
    check.number("vehicle.drive.track", d->track, 0.0, longest, false);
  } else {
    check.error = InputError{"", "vehicle.drive", "a mecanum drive does not dock by a pattern", "tricycle, differential"};
  }
}

void check_limits(Checker& check, const Limits& limits) {
  constexpr double most = 1e6;
  check.number("vehicle.limits.speed", limits.speed, 0.0, most, false);
  check.number("vehicle.limits.reverse_speed", limits.reverse_speed, 0.0, most, false);
  check.number("vehicle.limits.acceleration", limits.acceleration, 0.0, most, false);
  check.number("vehicle.limits.deceleration", limits.deceleration, 0.0, most, false);
  check.number("vehicle.limits.lateral_acceleration", limits.lateral_acceleration, 0.0, most);
  check.number("vehicle.limits.angular_speed", limits.angular_speed, 0.0, most);
  check.number("vehicle.limits.angular_acceleration", limits.angular_acceleration, 0.0, most);
  check.number("vehicle.limits.curvature", limits.curvature, 0.0, most);
  check.number("vehicle.limits.curvature_rate", limits.curvature_rate, 0.0, most);
}

void check_zones(Checker& check, std::vector<Zone>& zones) {
  if (zones.size() > most_zones && !check.error) check.error = InputError{"", "zones", fmt::format("there are {} zones", zones.size()), fmt::format("at most {}", most_zones)};
  for (Zone& zone : zones) {
    check.ring("zones.area", zone.area);
    switch (zone.type) {
      case ZoneType::forbidden: break;
      case ZoneType::directed:
        check.number("zones.direction", zone.direction, -1e6, 1e6);
        if (!check.error) zone.direction = wrap(zone.direction);
        break;
      case ZoneType::preferred: check.number("zones.factor", zone.factor, least_preference, 1.0); break;
      case ZoneType::penalty: check.number("zones.factor", zone.factor, 1.0, most_penalty); break;
      case ZoneType::speed_limit: check.number("zones.speed", zone.speed, least_zone_speed, most_zone_speed); break;
    }
  }
}

void check_station(Checker& check, Station& station) {
  check.ring("station.area", station.area);
  Shelf& shelf = station.shelf;
  check.point("station.shelf.center", shelf.center);
  check.number("station.shelf.heading", shelf.heading, -1e6, 1e6);
  check.number("station.shelf.size", shelf.depth, 0.0, 1e4, false);
  check.number("station.shelf.size", shelf.width, 0.0, 1e4, false);
  check.number("station.shelf.gap", shelf.gap, 0.0, 1e4);
  check.number("station.shelf.slot", shelf.slot, -0.5 * shelf.width, 0.5 * shelf.width);
  if (check.error) return;
  shelf.heading = wrap(shelf.heading);
  if (!station.insertion) return;
  check.number("station.insertion.depth", station.insertion->depth, 0.0, shelf.depth, false);
  for (const auto& [right, left] : station.insertion->pockets) {
    check.number("station.insertion.pockets", right, -0.5 * shelf.width, 0.5 * shelf.width);
    check.number("station.insertion.pockets", left, right, 0.5 * shelf.width, false);
  }
}

}  // namespace

std::optional<InputError> check_fields(Scenario& scenario) {
  if (!scenario.moving.empty()) return InputError{"", "moving", "a docking session knows nothing of obstacles that move", "none"};
  Checker check;
  check.rings("map.boundary", scenario.map.boundaries);
  check.rings("map.obstacles", scenario.map.obstacles);
  for (const Polyline& line : scenario.map.lines) {
    for (const Vec2 p : line) check.point("map.lines", p);
  }
  for (const Vec2 p : scenario.map.points) check.point("map.points", p);
  check.footprint("vehicle.footprint", scenario.vehicle.footprint);
  check.rings("vehicle.forks", scenario.vehicle.forks);
  for (auto& [name, load] : scenario.vehicle.loads) check.footprint("vehicle.loads", load.footprint);
  check_drive(check, scenario.vehicle.drive);
  check_limits(check, scenario.vehicle.limits);
  check.pose("start", scenario.start);
  check.number("start.speed", scenario.start_motion.speed, -1e3, 1e3);
  check.number("start.curvature", scenario.start_motion.curvature, -1e3, 1e3);
  check_zones(check, scenario.zones);
  check.number("clearance", scenario.clearance, 0.0, 1e3);
  check.number("pose_error.lateral", scenario.pose_error.lateral, 0.0, 1e3);
  check.number("pose_error.longitudinal", scenario.pose_error.longitudinal, 0.0, 1e3);
  check.number("pose_error.heading", scenario.pose_error.heading, 0.0, pi);
  if (auto* station = std::get_if<Station>(&scenario.mission)) {
    check_station(check, *station);
  } else if (!check.error) {
    check.error = InputError{"", "station", "the mission is not a station", "a station with a shelf"};
  }
  return check.error;
}

}  // namespace waywright
