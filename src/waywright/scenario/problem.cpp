#include "waywright/scenario/problem.hpp"
#include "waywright/core/elementary.hpp"
#include "waywright/geometry/boolean.hpp"
#include "waywright/path/remainder.hpp"
#include "waywright/scenario/blocked_region.hpp"
#include "waywright/scenario/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace waywright {
namespace {

/// Any point of the footprint moves by at most this when the pose is off by the error: translation plus the chord of the
/// rotation about the origin.
double margin_of(const PoseError& error, double radius) {
  return norm({error.lateral, error.longitudinal}) + 2.0 * radius * sin_cos(0.5 * std::min(error.heading, pi)).sin;
}

InputError refuse(std::string field, std::string problem, std::string allowed) {
  return InputError{"", std::move(field), std::move(problem), std::move(allowed)};
}

/// The vehicle's footprint with the load that it carries.
std::variant<Footprint, InputError> carried_footprint(const Scenario& scenario) {
  const Footprint& own = scenario.vehicle.footprint;
  if (scenario.carried_load.empty()) return own;
  const auto load = scenario.vehicle.loads.find(scenario.carried_load);
  if (load == scenario.vehicle.loads.end()) {
    std::string names;
    for (const auto& [name, unused] : scenario.vehicle.loads) names += (names.empty() ? "" : ", ") + name;
    return refuse("carried_load", fmt::format("the vehicle has no load \"{}\"", scenario.carried_load),
                  names.empty() ? "no load: vehicle.loads is empty" : names);
  }
  const Footprint& carried = load->second.footprint;
  const auto both = joined(polygon_around(own), polygon_around(carried));
  if (!both) {
    return refuse("vehicle.loads." + scenario.carried_load + ".footprint", "load and vehicle do not make one simple polygon",
                  "a load that overlaps the vehicle's footprint and leaves no hole");
  }
  return Footprint{*both, 0.0};
}

std::optional<InputError> check_station(const Scenario& scenario, const Station& station) {
  const Shelf& shelf = station.shelf;
  const double station_width = least_width(station.area);
  const double vehicle_width = scenario.vehicle.footprint.least_width();
  if (station_width <= vehicle_width) {
    return refuse("station.area",
                  fmt::format("the station is {:.3f} m wide at its narrowest and the vehicle's least width is {:.3f} m",
                              station_width, vehicle_width),
                  "a station that the vehicle fits into");
  }
  const Box box = bounding_box(station.area);
  for (const Vec2 corner : shelf.outline()) {
    const Vec2 inside = nearest_in(station.area, corner);
    if (distance(inside, corner) <= 1e-9 * (1.0 + norm(corner))) continue;
    return refuse("station.shelf",
                  fmt::format("the shelf's corner at ({:.3f}, {:.3f}) is {:.3f} m outside the station's area, which is {:.2f} × {:.2f} m", corner.x,
                              corner.y, distance(inside, corner), box.high.x - box.low.x, box.high.y - box.low.y),
                  "a shelf that lies inside station.area");
  }
  if (shelf.gap < scenario.clearance) {
    return refuse("station.shelf.gap",
                  fmt::format("{} m is under the clearance of {} m that the footprint must keep", shelf.gap,
                              scenario.clearance),
                  "a gap of at least the clearance");
  }
  return std::nullopt;
}

/// That stands for the goal.
Pose pose_of(const Mission& mission) {
  if (const auto* pose = std::get_if<Pose>(&mission)) return *pose;
  const Box box = bounding_box(std::get<FreeGoal>(mission).area);
  return make_pose(0.5 * (box.low + box.high), 0.0);
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

std::optional<InputError> Problem::set_station(const Station& station) {
  if (auto error = check_station(scenario_, station)) return error;
  driven_back_ = station.manoeuvre == Manoeuvre::undock;
  world_.add_boundary(station.area, "the station's area");
  const std::size_t shelf = world_.add_obstacle(station.shelf.outline(), "the shelf");
  goal_ = station.shelf.docked(footprint_.front());
  if (!station.insertion) return std::nullopt;
  auto made = make_pocket_motion(vehicle(), station, goal_);
  if (auto* error = std::get_if<InputError>(&made)) return *error;
  pocket_ = std::move(std::get<PocketMotion>(made));
  pocket_->shelf_source = shelf;
  return std::nullopt;
}

std::optional<InputError> Problem::set_motion() {
  rest_ = scenario_.start;
  const StartMotion& given = scenario_.start_motion;
  if (given.speed == 0.0) {
    if (given.angular_velocity != 0.0) return refuse("start.angular_velocity", "the vehicle stands and turns on the spot, and nothing is planned from that", "0 where start.speed is 0");
    return std::nullopt;
  }
  if (driven_back_) return refuse("start.speed", "the way out of the shelf begins at rest, and start is where it ends", "0");
  EntryMotion motion{std::abs(given.speed), given.speed < 0.0 ? -1 : 1, given.curvature, {}, given.curvature};
  if (given.course) {
    if (!vehicle().moves_any_way()) return refuse("start.course", "the vehicle's drive has it face along its way", "a vehicle that can drive in any direction (mecanum), or none");
    if (given.speed < 0.0) return refuse("start.speed", "it is along start.course, and negative", "0 or more beside start.course");
    motion.course = wrap(*given.course);
    motion.turning = given.angular_velocity / motion.speed;
  }
  const Limits& limits = vehicle().limits;
  const double most = motion.direction < 0 ? limits.reverse_speed : limits.speed;
  constexpr double measured = 1e-3;  // share of the speed
  if (motion.speed > most * (1.0 + measured)) {
    return refuse("start.speed", fmt::format("{} m/s is over the vehicle's limit in that direction", motion.speed), fmt::format("at most {} m/s", most));
  }
  if (std::abs(motion.curvature) > vehicle().max_curvature()) {
    return refuse("start.curvature", fmt::format("{} 1/m is over the vehicle's limit", motion.curvature),
                  fmt::format("at most {} 1/m to either side", vehicle().max_curvature()));
  }
  double deceleration = limits.deceleration;
  if (limits.angular_acceleration) deceleration = std::min(deceleration, *limits.angular_acceleration / std::abs(motion.turning));
  constexpr double reserve = 1e-9;  // share of it, for rounding
  const double distance = motion.speed * motion.speed / (2.0 * deceleration) * (1.0 + reserve);
  const double course = motion.course ? *motion.course : motion.direction < 0 ? wrap(rest_.heading + pi) : rest_.heading;
  constexpr double shortest = 1e-6;  // m: what stops within it stands
  constexpr double least_turning = 1e-3;  // rad
  if (distance < shortest) {
    if (std::abs(motion.turning) * distance > least_turning && motion.course) return refuse("start.angular_velocity", "the vehicle all but stands and turns on the spot, and nothing is planned from that", "less beside such a start.speed");
    return std::nullopt;
  }
  constexpr double longest = 1e4;  // m
  if (!(distance <= longest)) {
    return refuse("start.speed", fmt::format("stopping from {} m/s takes {:.3g} m", motion.speed, distance), "what can be stopped within 10 km");
  }
  if (motion.curvature == 0.0) {
    stopping_ = Piece{Line{rest_.position(), rest_.position() + distance * unit(course)}, motion.direction};
  } else {
    stopping_ = Piece{Arc{make_pose(rest_.position(), course), motion.curvature, distance}, motion.direction};
  }
  if (motion.course) stopping_->heading = HeadingAlong{scenario_.start.heading, motion.turning * distance};
  rest_ = end_pose(*stopping_);
  if (motion.turning == 0.0) rest_.heading = scenario_.start.heading;
  motion_ = motion;
  return std::nullopt;
}

std::optional<InputError> Problem::check_waypoints() const {
  const std::vector<Vec2>& waypoints = scenario_.waypoints;
  if (waypoints.empty()) return std::nullopt;
  if (std::holds_alternative<Station>(scenario_.mission)) return refuse("waypoints", "they are given beside a station", "waypoints on the way to a goal");
  constexpr double apart = 1e-3;  // m
  Vec2 before = rest_.position();
  for (std::size_t i = 0; i <= waypoints.size(); ++i) {
    const Vec2 here = i < waypoints.size() ? waypoints[i] : goal_.position();
    if (distance(before, here) < apart + (i < waypoints.size() && i > 0 ? 2.0 : 1.0) * scenario_.waypoint_radius) {
      const std::string field = i < waypoints.size() ? fmt::format("waypoints[{}]", i) : "goal";
      return refuse(field, fmt::format("it is {:.4f} m from {}", distance(before, here), i == 0 ? std::string{"the start"} : fmt::format("waypoints[{}]", i - 1)),
                    "places more than 1 mm apart, beyond the waypoint radius of both");
    }
    before = here;
  }
  return std::nullopt;
}

Parsed<Problem> Problem::prepare(Scenario scenario, const World* of_map) {
  Problem problem;
  problem.scenario_ = std::move(scenario);
  const Scenario& given = problem.scenario_;
  if (!given.legs.empty()) return tl::unexpected{refuse("legs", "a mission of several legs is not one problem", "one goal or station")};
  auto footprint = carried_footprint(given);
  if (auto* error = std::get_if<InputError>(&footprint)) return tl::unexpected{*error};
  problem.footprint_ = std::move(std::get<Footprint>(footprint));
  problem.world_ = of_map != nullptr ? *of_map : World{given.map};
  if (const auto* station = std::get_if<Station>(&given.mission)) {
    if (auto error = problem.set_station(*station)) return tl::unexpected{*error};
  } else {
    problem.goal_ = pose_of(given.mission);
  }
  for (std::size_t i = 0; i < given.zones.size(); ++i) {
    if (given.zones[i].type == ZoneType::forbidden) problem.world_.add_obstacle(given.zones[i].area, title_of(given.zones[i], i));
  }
  problem.zones_ = ZoneRules{given.zones};
  if (problem.driven_back_) {
    std::vector<Zone> other_way = given.zones;
    for (Zone& z : other_way) z.direction = wrap(z.direction + pi);
    problem.zones_driven_back_ = ZoneRules{other_way};
  }
  if (auto error = problem.set_motion()) return tl::unexpected{*error};
  if (auto error = problem.check_waypoints()) return tl::unexpected{*error};
  problem.world_.build();
  problem.pose_error_margin_ = margin_of(given.pose_error, problem.footprint_.radius());
  return problem;
}

bool Problem::is_goal(const Pose& end, double position_tolerance, double heading_tolerance) const {
  if (const FreeGoal* free = free_goal()) {
    const Vec2 nearest = free->is_point() ? free->area.front() : contains(free->area, end.position()) ? end.position() : nearest_in(free->area, end.position());
    return distance(nearest, end.position()) <= position_tolerance;
  }
  const Pose& last = last_pose();
  return distance(last.position(), end.position()) <= position_tolerance && std::abs(shorter_turn(last.heading, end.heading)) <= heading_tolerance;
}

Piece Problem::pocket_stretch() const {
  const Vec2 outer = pocket_->outer.position(), inner = pocket_->inner.position();
  return driven_back_ ? Piece{Line{inner, outer}, -1} : Piece{Line{outer, inner}, 1};
}

Path Problem::whole_path(Path planned, bool begins_in_motion) const {
  if (driven_back_) planned = reversed(planned);
  if (stopping_ && !begins_in_motion) planned.pieces.insert(planned.pieces.begin(), *stopping_);
  if (pocket_) planned.pieces.insert(driven_back_ ? planned.pieces.begin() : planned.pieces.end(), pocket_stretch());
  return planned;
}

std::optional<std::size_t> Problem::pocket_piece(const Path& path) const {
  constexpr double tolerance = 1e-6;  // m
  if (!pocket_ || path.pieces.empty()) return std::nullopt;
  const std::size_t index = driven_back_ ? 0 : path.pieces.size() - 1;
  const Piece& piece = path.pieces[index];
  const auto* line = std::get_if<Line>(&piece.curve);
  if (line == nullptr || piece.direction != (driven_back_ ? -1 : 1)) return std::nullopt;
  const Vec2 outer = driven_back_ ? line->to : line->from;
  const Vec2 inner = driven_back_ ? line->from : line->to;
  const bool as_it_must = distance(outer, pocket_->outer.position()) <= tolerance && distance(inner, pocket_->inner.position()) <= tolerance;
  return as_it_must ? std::optional{index} : std::nullopt;
}

/// A vehicle that is faster than its limits allow where it is on a bend can go nowhere within them.
std::optional<Failure> Problem::check_motion() const {
  if (!motion_) return std::nullopt;
  constexpr double slack = 1e-3;  // share of the speed: what is measured
  const Limits& limits = vehicle().limits;
  const double bend = std::abs(motion_->curvature);
  double most = std::numeric_limits<double>::infinity();
  if (limits.lateral_acceleration) most = std::min(most, std::sqrt(*limits.lateral_acceleration / bend));
  if (limits.angular_speed) most = std::min(most, *limits.angular_speed / std::abs(motion_->turning));
  const char* wheels = "";
  if (const auto* mecanum = std::get_if<Mecanum>(&vehicle().drive); mecanum != nullptr && mecanum->max_wheel_speed) {
    most = std::min(most, mecanum->max_speed(motion_->course ? *motion_->course - scenario_.start.heading : 0.0, 0.0, motion_->turning));
    wheels = " and of its wheels' speed";
  }
  if (motion_->speed <= most * (1.0 + slack)) return std::nullopt;
  Failure failure;
  failure.status = Status::no_path;
  failure.pose = scenario_.start;
  failure.reason = fmt::format("the vehicle begins at {:.4f} m/s with a curvature of {:.4f} 1/m{}, where its limits of lateral acceleration and angular speed{} allow {:.4f} m/s",
                               motion_->speed, motion_->curvature, motion_->course ? fmt::format(" and turns by {:.4f} rad/m", motion_->turning) : std::string{}, wheels, most);
  return failure;
}

std::optional<Failure> Problem::check_ends() const {
  const double required = required_clearance();
  for (const bool is_start : {true, false}) {
    if (!is_start && free_goal() != nullptr) {
      // Whether one of many poses is free, the search finds; not where not even the largest disc in the footprint is, whatever it faces.
      const Footprint inside{{}, footprint_.inner_radius()};
      if (!free_goal()->is_point()) {
        if (auto blocked = blocked_region(world_, free_goal()->area, inside.disc, required)) return blocked;
      }
      if (!free_goal()->is_point() || !(inside.disc > 0.0)) break;
      const Contact contact = world_.clearance(inside, goal(), required + 1.0);
      if (contact.clearance == 0.0 || contact.clearance < required - 1e-9) return end_failure(world_, contact, goal(), false, required);
      break;
    }
    const Pose& pose = is_start ? scenario_.start : goal();
    const Contact contact = world_.clearance(footprint_, pose, required + 1.0);
    if (contact.clearance == 0.0 || contact.clearance < required - 1e-9) {  // rounding of the distance itself
      return end_failure(world_, contact, pose, is_start != driven_back_, required);
    }
  }
  if (auto failure = check_motion()) return failure;
  return check_pocket();
}

std::optional<Problem::BlockedStop> Problem::blocked_stop() const {
  if (!motion_) return std::nullopt;
  constexpr double step = 0.02;  // m; between them the proof decides
  const double required = required_clearance();
  const double whole = length(*stopping_);
  const double steps = std::min(std::ceil(whole / step), 1e4);
  for (double i = 1.0; i <= steps; ++i) {
    const Pose pose = i == steps ? rest_ : start_pose(remainder(Path{{*stopping_}}, whole * i / steps));
    const Contact contact = world_.clearance(footprint_, pose, required + 1.0);
    if (contact.clearance == 0.0 || contact.clearance < required - 1e-9) return BlockedStop{whole * i / steps, pose, contact};
  }
  return std::nullopt;
}

std::optional<Failure> Problem::check_stop() const {
  const auto blocked = blocked_stop();
  if (!blocked) return std::nullopt;
  Failure failure = end_failure(world_, blocked->contact, blocked->pose, true, required_clearance());
  failure.status = Status::no_path;
  failure.reason = fmt::format("the vehicle cannot come to rest in time: {:.2f} m on, {}", blocked->driven, failure.reason);
  return failure;
}

/// The pose with the forks in.
std::optional<Failure> Problem::check_pocket() const {
  if (!pocket_) return std::nullopt;
  const double required = required_clearance();
  const PocketContacts contacts = contacts_at(*pocket_, world_, footprint_, pocket_->inner, required + 1.0);
  if (contacts.vehicle.clearance == 0.0 || contacts.vehicle.clearance < required - 1e-9) {
    return end_failure(contacts.is_shelf ? pocket_->shelf : world_, contacts.vehicle, pocket_->inner, driven_back_, required);
  }
  if (contacts.forks.clearance > pose_error_margin_) return std::nullopt;
  Failure failure = end_failure(pocket_->beside_pockets, contacts.forks, pocket_->inner, driven_back_, pose_error_margin_);
  failure.reason = fmt::format(
      "with the forks in, at ({:.3f}, {:.3f}), they are {:.4f} m from {} at ({:.3f}, {:.3f}), and more than {:.4f} m are needed "
      "(pose error)",
      pocket_->inner.x, pocket_->inner.y, contacts.forks.clearance, pocket_->beside_pockets.source_name(contacts.forks.source),
      contacts.forks.point.x, contacts.forks.point.y, pose_error_margin_);
  return failure;
}

}  // namespace waywright
