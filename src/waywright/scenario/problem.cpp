#include "waywright/scenario/problem.hpp"
#include "waywright/core/elementary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

/// Any point of the footprint moves by at most this when the pose is off by the error: translation plus the chord of the
/// rotation about the origin.
double margin_of(const PoseError& error, double radius) {
  return norm({error.lateral, error.longitudinal}) + 2.0 * radius * sin_cos(0.5 * std::min(error.heading, pi)).sin;
}

std::optional<InputError> check_station(const Scenario& scenario, const Station& station) {
  const auto refuse = [](std::string field, std::string problem, std::string allowed) {
    return InputError{"", std::move(field), std::move(problem), std::move(allowed)};
  };
  const Shelf& shelf = station.shelf;
  for (const Vec2 corner : shelf.outline()) {
    const Vec2 inside = nearest_in(station.area, corner);
    if (distance(inside, corner) <= 1e-9 * (1.0 + norm(corner))) continue;
    return refuse("station.shelf",
                  fmt::format("the shelf's corner at ({:.3f}, {:.3f}) is {:.3f} m outside the station's area", corner.x,
                              corner.y, distance(inside, corner)),
                  "a shelf that lies inside station.area");
  }
  if (shelf.gap < scenario.clearance) {
    return refuse("station.shelf.gap",
                  fmt::format("{} m is under the clearance of {} m that the footprint must keep", shelf.gap,
                              scenario.clearance),
                  "a gap of at least the clearance");
  }
  const double station_width = least_width(station.area);
  const double vehicle_width = scenario.vehicle.footprint.least_width();
  if (station_width <= vehicle_width) {
    return refuse("station.area",
                  fmt::format("the station is {:.3f} m wide at its narrowest and the vehicle's least width is {:.3f} m",
                              station_width, vehicle_width),
                  "a station that the vehicle fits into");
  }
  return std::nullopt;
}

Failure end_failure(const World& world, const Contact& contact, const Pose& pose, bool start, double required) {
  Failure failure;
  failure.pose = pose;
  failure.point = contact.point;
  const char* end = start ? "start" : "goal";
  if (contact.outside) {
    failure.status = start ? Status::start_outside : Status::goal_outside;
    failure.reason = fmt::format("at the {} pose ({:.3f}, {:.3f}, {:.4f} rad) the footprint is not inside {}", end, pose.x,
                                 pose.y, pose.heading, world.source_name(contact.source));
    return failure;
  }
  failure.status = start ? Status::start_in_collision : Status::goal_in_collision;
  const std::string where = fmt::format("{} at ({:.3f}, {:.3f})", world.source_name(contact.source), contact.point.x,
                                        contact.point.y);
  if (contact.clearance == 0.0) {
    failure.reason = fmt::format("at the {} pose ({:.3f}, {:.3f}, {:.4f} rad) the footprint touches {}", end, pose.x,
                                 pose.y, pose.heading, where);
  } else {
    failure.reason = fmt::format(
        "at the {} pose ({:.3f}, {:.3f}, {:.4f} rad) the footprint is {:.4f} m from {}, and {:.4f} m are required "
        "(clearance and pose error)",
        end, pose.x, pose.y, pose.heading, contact.clearance, where, required);
  }
  return failure;
}

}  // namespace

Parsed<Problem> Problem::prepare(Scenario scenario) {
  Problem problem;
  problem.scenario_ = std::move(scenario);
  const Scenario& given = problem.scenario_;
  problem.world_ = World{given.map};
  if (const auto* station = std::get_if<Station>(&given.mission)) {
    if (auto error = check_station(given, *station)) return tl::unexpected{*error};
    problem.world_.add_boundary(station->area, "the station's area");
    problem.world_.add_obstacle(station->shelf.outline(), "the shelf");
    problem.goal_ = station->shelf.docked(given.vehicle.footprint.front());
  } else {
    problem.goal_ = std::get<Pose>(given.mission);
  }
  problem.world_.build();
  problem.pose_error_margin_ = margin_of(given.pose_error, given.vehicle.footprint.radius());
  return problem;
}

std::optional<Failure> Problem::check_ends() const {
  const double required = required_clearance();
  for (const bool is_start : {true, false}) {
    const Pose& pose = is_start ? start() : goal();
    const Contact contact = world_.clearance(vehicle().footprint, pose, required + 1.0);
    if (contact.clearance == 0.0 || contact.clearance < required - 1e-9) {  // rounding of the distance itself
      return end_failure(world_, contact, pose, is_start, required);
    }
  }
  return std::nullopt;
}

}  // namespace waywright
