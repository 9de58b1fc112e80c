#include "waywright/io/vehicle_io.hpp"

#include <fmt/format.h>

#include <cmath>

#include "waywright/io/files.hpp"
#include "waywright/io/scenario_io.hpp"

namespace waywright {
namespace {

constexpr double most = 1e6;                      // of speeds, accelerations, curvatures, masses
constexpr double most_torque = 1e9;               // N m
constexpr double longest = 1e3;                   // m
constexpr std::size_t most_forks = 16;            // polygons
constexpr std::uint64_t largest_file = 16 << 20;  // bytes
constexpr std::size_t most_corners =
    100'000;  // of one polygon
constexpr std::size_t most_outline_corners = 500;  // of what drives: it is cut into convex parts, and asked about at every pose

Ring read_outline(const Node& node, std::vector<std::string>& notes) {
  if (node.is_array() && node.json().size() > most_outline_corners) {
    node.fail(fmt::format("the polygon has {} corners", node.json().size()), fmt::format("at most {}", most_outline_corners));
    return {};
  }
  return read_ring(node, notes);
}

/// One polygon, or a list of polygons.
std::vector<Ring> read_forks(const Node& node, std::vector<std::string>& notes) {
  const Json& json = node.json();
  const bool is_list = json.is_array() && !json.empty() && json[0].is_array() && !json[0].empty() && json[0][0].is_array();
  if (!is_list) return {read_outline(node, notes)};
  if (json.size() > most_forks) {
    node.fail(fmt::format("there are {} polygons", json.size()), fmt::format("at most {}", most_forks));
    return {};
  }
  std::vector<Ring> forks;
  for (const Node& fork : node.elements()) {
    forks.push_back(read_outline(fork, notes));
    if (node.failed()) return {};
  }
  return forks;
}

Drive read_drive(const Node& node) {
  if (!node.is_object()) node.fail(fmt::format("it is {}", kind_of(node.json())), "an object whose type is tricycle, differential or mecanum");
  const std::string type = node.at("type").word({"tricycle", "differential", "mecanum"});
  if (node.failed()) return Differential{};
  const auto extent = [&](const char* field) { return node.at(field).number_above(0.0, longest); };
  if (type == "tricycle") {
    Tricycle tricycle;
    if (!node.is_object_of({"type", "wheelbase", "max_steering", "max_steering_rate", "steered_axle"}))
      return tricycle;
    tricycle.wheelbase = extent("wheelbase");
    tricycle.max_steering = node.at("max_steering").number_between(0.0, 0.5 * pi);
    if (node.has("max_steering_rate"))
      tricycle.max_steering_rate = node.at("max_steering_rate").number_above(0.0, 1e3);
    if (node.has("steered_axle") && node.at("steered_axle").word({"rear", "front"}) == "front") {
      tricycle.steered_axle = SteeredAxle::front;
    }
    return tricycle;
  }
  if (type == "differential") {
    if (!node.is_object_of({"type", "track"})) return Differential{};
    return Differential{extent("track")};
  }
  Mecanum mecanum;
  if (!node.is_object_of({"type", "wheel_radius", "half_length", "half_width", "max_wheel_speed", "max_torque", "wheel_inertia", "rolling_arm"})) return mecanum;
  mecanum.wheel_radius = extent("wheel_radius");
  mecanum.half_length = extent("half_length");
  mecanum.half_width = extent("half_width");
  if (node.has("max_wheel_speed")) mecanum.max_wheel_speed = node.at("max_wheel_speed").number_above(0.0, most);
  if (node.has("max_torque")) mecanum.max_torque = node.at("max_torque").number_above(0.0, most_torque);
  if (node.has("wheel_inertia")) mecanum.wheel_inertia = node.at("wheel_inertia").number(0.0, most);
  if (node.has("rolling_arm") && !node.failed()) mecanum.rolling_arm = node.at("rolling_arm").number(0.0, mecanum.wheel_radius);
  return mecanum;
}

Json drive_to_json(const Drive& drive) {
  if (const auto* t = std::get_if<Tricycle>(&drive)) {
    Json j{{"type", "tricycle"}, {"wheelbase", t->wheelbase}, {"max_steering", t->max_steering}};
    if (t->max_steering_rate) j["max_steering_rate"] = *t->max_steering_rate;
    j["steered_axle"] = t->steered_axle == SteeredAxle::rear ? "rear" : "front";
    return j;
  }
  if (const auto* d = std::get_if<Differential>(&drive))
    return {{"type", "differential"}, {"track", d->track}};
  const auto& m = std::get<Mecanum>(drive);
  Json j{{"type", "mecanum"}, {"wheel_radius", m.wheel_radius}, {"half_length", m.half_length}, {"half_width", m.half_width}};
  if (m.max_wheel_speed) j["max_wheel_speed"] = *m.max_wheel_speed;
  if (m.max_torque) j["max_torque"] = *m.max_torque;
  if (m.wheel_inertia > 0.0) j["wheel_inertia"] = m.wheel_inertia;
  if (m.rolling_arm > 0.0) j["rolling_arm"] = m.rolling_arm;
  return j;
}

Limits read_limits(const Node& node) {
  Limits limits;
  if (!node.is_object_of({"speed", "reverse_speed", "acceleration", "deceleration", "lateral_acceleration",
                          "angular_speed", "angular_acceleration", "curvature", "curvature_rate"})) {
    return limits;
  }
  const auto required = [&](const char* field, double fallback) {
    return node.has(field) ? node.at(field).number_above(0.0, most) : fallback;
  };
  const auto optional = [&](const char* field, std::optional<double>& value) {
    if (node.has(field)) value = node.at(field).number_above(0.0, most);
  };
  limits.speed = required("speed", limits.speed);
  limits.reverse_speed = required("reverse_speed", limits.speed);
  limits.acceleration = required("acceleration", limits.acceleration);
  limits.deceleration = required("deceleration", limits.acceleration);
  optional("lateral_acceleration", limits.lateral_acceleration);
  optional("angular_speed", limits.angular_speed);
  optional("angular_acceleration", limits.angular_acceleration);
  optional("curvature", limits.curvature);
  optional("curvature_rate", limits.curvature_rate);
  return limits;
}

Json limits_to_json(const Limits& limits) {
  Json j{{"speed", limits.speed},
         {"reverse_speed", limits.reverse_speed},
         {"acceleration", limits.acceleration},
         {"deceleration", limits.deceleration}};
  const auto optional = [&](const char* field, const std::optional<double>& value) {
    if (value && std::isfinite(*value)) j[field] = *value;  // an infinite limit is none
  };
  optional("lateral_acceleration", limits.lateral_acceleration);
  optional("angular_speed", limits.angular_speed);
  optional("angular_acceleration", limits.angular_acceleration);
  optional("curvature", limits.curvature);
  optional("curvature_rate", limits.curvature_rate);
  return j;
}

}  // namespace

Footprint read_footprint(const Node& node, std::vector<std::string>& notes, double reach) {
  Footprint footprint;
  if (node.is_object()) {
    if (node.is_object_of({"disc"})) footprint.disc = node.at("disc").number(0.0, reach);
    return footprint;
  }
  if (!node.is_array()) {
    node.fail(fmt::format("it is {}", kind_of(node.json())), "a polygon [[x, y], ...] or {\"disc\": radius}");
    return footprint;
  }
  footprint.polygon = read_outline(node, notes);
  if (!node.failed() && footprint.radius() > reach) {
    node.fail(fmt::format("it reaches {:g} m from the origin", footprint.radius()),
              fmt::format("at most {:g} m", reach));
  }
  return footprint;
}

Json footprint_to_json(const Footprint& footprint) {
  if (footprint.is_disc()) return Json{{"disc", footprint.disc}};
  return to_json(footprint.polygon);
}

Json to_json(Vec2 p) { return Json::array({p.x, p.y}); }
Json to_json(const Pose& p) { return Json::array({p.x, p.y, p.heading}); }
Json to_json(const std::vector<Vec2>& points) {
  Json j = Json::array();
  for (const Vec2 p : points) j.push_back(to_json(p));
  return j;
}

Ring read_ring(const Node& node, std::vector<std::string>& notes, double limit) {
  Ring ring = node.points(limit);
  if (node.failed()) return {};
  if (ring.empty()) {
    node.fail("the polygon is empty", "at least 3 corners [x, y]");
    return {};
  }
  if (ring.size() > most_corners) {
    node.fail(fmt::format("the polygon has {} corners", ring.size()),
              fmt::format("at most {}", most_corners));
    return {};
  }
  RingRepair repair = repair_ring(std::move(ring));
  if (repair.refused) {
    node.fail(*repair.refused, "a simple polygon of at least 3 corners with an area");
    return {};
  }
  for (const std::string& mended : repair.mended) notes.push_back(node.path() + ": " + mended);
  return repair.ring;
}

Vehicle read_vehicle_node(const Node& node, std::vector<std::string>& notes) {
  Vehicle vehicle;
  if (!node.is_object_of({"name", "footprint", "forks", "loads", "mass", "drive", "limits", "control_point"}))
    return vehicle;
  if (node.has("name")) vehicle.name = node.at("name").text();
  vehicle.footprint = read_footprint(node.at("footprint"), notes);
  if (node.has("forks")) vehicle.forks = read_forks(node.at("forks"), notes);
  if (node.has("loads")) {
    for (const auto& [name, load] : node.at("loads").members("an object of loads by name")) {
      if (!load.is_object_of({"footprint", "mass"})) break;
      vehicle.loads[name] = {read_footprint(load.at("footprint"), notes),
                             load.has("mass") ? load.at("mass").number(0.0, most) : 0.0};
    }
  }
  if (node.has("mass")) vehicle.mass = node.at("mass").number(0.0, most);
  vehicle.drive = read_drive(node.at("drive"));
  if (node.has("limits")) vehicle.limits = read_limits(node.at("limits"));
  if (node.has("control_point")) vehicle.control_point = node.at("control_point").pose();
  return vehicle;
}

Json vehicle_to_json(const Vehicle& vehicle) {
  Json j{{"name", vehicle.name}, {"footprint", footprint_to_json(vehicle.footprint)}};
  if (vehicle.forks.size() == 1) j["forks"] = to_json(vehicle.forks.front());
  if (vehicle.forks.size() > 1) {
    Json forks = Json::array();
    for (const Ring& fork : vehicle.forks) forks.push_back(to_json(fork));
    j["forks"] = std::move(forks);
  }
  if (!vehicle.loads.empty()) {
    Json::object_t
        loads;  // appended without looking for the name each time: there may be many, and they differ
    for (const auto& [name, load] : vehicle.loads) {
      loads.emplace_back(name, Json{{"footprint", footprint_to_json(load.footprint)}, {"mass", load.mass}});
    }
    j["loads"] = std::move(loads);
  }
  j["mass"] = vehicle.mass;
  j["drive"] = drive_to_json(vehicle.drive);
  j["limits"] = limits_to_json(vehicle.limits);
  j["control_point"] = to_json(vehicle.control_point);
  return j;
}

Parsed<Vehicle> read_vehicle_file(const std::filesystem::path& file, const std::string& name,
                                  std::vector<std::string>& notes) {
  auto text = read_file(file, largest_file);
  if (!text) return tl::unexpected{text.error()};
  auto json = parse_json(*text, file.string());
  if (!json) return tl::unexpected{json.error()};
  ReadContext context{file.string(), {}};
  std::vector<std::string> mended;
  Vehicle vehicle = read_vehicle_node(Node{*json, "", context}, mended);
  if (context.error) return tl::unexpected{*context.error};
  for (const std::string& note : mended) notes.push_back(name + ": " + note);
  return vehicle;
}

Parsed<Vehicle> read_vehicle(const std::filesystem::path& file) {
  std::vector<std::string> notes;
  return read_vehicle_file(file, file.filename().string(), notes);
}

}  // namespace waywright
