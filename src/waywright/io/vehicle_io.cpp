#include "waywright/io/vehicle_io.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "waywright/io/files.hpp"
#include "waywright/io/scenario_io.hpp"

namespace waywright {
namespace {

constexpr double most = 1e6;
constexpr std::uint64_t largest_vehicle_file = 1 << 20;

Footprint read_footprint(const Node& node, std::vector<std::string>& notes) {
  Footprint footprint;
  if (node.is_object()) {
    if (node.is_object_of({"disc"})) footprint.disc = node.at("disc").number(0.0, 1e3);
    return footprint;
  }
  footprint.polygon = read_ring(node, notes);
  if (!node.failed() && footprint.radius() > 1e3) node.fail("the footprint is larger than 1 km", "corners within 1000 m of the origin");
  return footprint;
}

Json footprint_to_json(const Footprint& footprint) {
  if (footprint.is_disc()) return Json{{"disc", footprint.disc}};
  return to_json(footprint.polygon);
}

Drive read_drive(const Node& node) {
  const std::string type = node.at("type").text();
  if (type == "tricycle") {
    Tricycle tricycle;
    if (!node.is_object_of({"type", "wheelbase", "max_steering", "max_steering_rate", "steered_axle"})) return tricycle;
    tricycle.wheelbase = node.at("wheelbase").number_above(0.0, 1e3);
    const Node steering = node.at("max_steering");
    tricycle.max_steering = steering.number_above(0.0, 0.5 * pi);
    if (!node.failed() && tricycle.max_steering >= 0.5 * pi) steering.fail("it is a right angle", "above 0, under π/2");
    if (node.has("max_steering_rate")) tricycle.max_steering_rate = node.at("max_steering_rate").number_above(0.0, 1e3);
    if (node.has("steered_axle")) {
      const std::string axle = node.at("steered_axle").text();
      if (!node.failed() && axle != "rear" && axle != "front") {
        node.at("steered_axle").fail(fmt::format("\"{}\" is not known", axle), "rear, front");
      }
      tricycle.steered_axle = axle == "front" ? SteeredAxle::front : SteeredAxle::rear;
    }
    return tricycle;
  }
  if (type == "differential") {
    if (!node.is_object_of({"type", "track"})) return Differential{};
    return Differential{node.at("track").number_above(0.0, 1e3)};
  }
  if (type == "mecanum") {
    if (!node.is_object_of({"type", "wheel_radius", "half_length", "half_width"})) return Mecanum{};
    return Mecanum{node.at("wheel_radius").number_above(0.0, 1e3), node.at("half_length").number_above(0.0, 1e3),
                   node.at("half_width").number_above(0.0, 1e3)};
  }
  if (!node.failed()) node.at("type").fail(fmt::format("\"{}\" is not known", type), "tricycle, differential, mecanum");
  return Differential{};
}

Json drive_to_json(const Drive& drive) {
  if (const auto* t = std::get_if<Tricycle>(&drive)) {
    Json j{{"type", "tricycle"}, {"wheelbase", t->wheelbase}, {"max_steering", t->max_steering}};
    if (t->max_steering_rate) j["max_steering_rate"] = *t->max_steering_rate;
    j["steered_axle"] = t->steered_axle == SteeredAxle::rear ? "rear" : "front";
    return j;
  }
  if (const auto* d = std::get_if<Differential>(&drive)) return {{"type", "differential"}, {"track", d->track}};
  const auto& m = std::get<Mecanum>(drive);
  return {{"type", "mecanum"}, {"wheel_radius", m.wheel_radius}, {"half_length", m.half_length}, {"half_width", m.half_width}};
}

Limits read_limits(const Node& node) {
  Limits limits;
  if (!node.is_object_of({"speed", "reverse_speed", "acceleration", "deceleration", "lateral_acceleration", "angular_speed",
                          "angular_acceleration", "curvature", "curvature_rate"})) {
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
    if (value) j[field] = *value;
  };
  optional("lateral_acceleration", limits.lateral_acceleration);
  optional("angular_speed", limits.angular_speed);
  optional("angular_acceleration", limits.angular_acceleration);
  optional("curvature", limits.curvature);
  optional("curvature_rate", limits.curvature_rate);
  return j;
}

}  // namespace

Json to_json(Vec2 p) { return Json::array({p.x, p.y}); }
Json to_json(const Pose& p) { return Json::array({p.x, p.y, p.heading}); }
Json to_json(const std::vector<Vec2>& points) {
  Json j = Json::array();
  for (const Vec2 p : points) j.push_back(to_json(p));
  return j;
}

Ring read_ring(const Node& node, std::vector<std::string>& notes) {
  Ring ring;
  for (const Node& corner : node.elements()) {
    ring.push_back(corner.point());
    if (node.failed()) return {};
  }
  if (node.failed()) return {};
  if (ring.empty()) {
    node.fail("the polygon is empty", "at least 3 corners [x, y]");
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
  if (!node.is_object_of({"name", "footprint", "forks", "loads", "mass", "drive", "limits", "control_point", "meta"})) return vehicle;
  if (node.has("name")) vehicle.name = node.at("name").text();
  vehicle.footprint = read_footprint(node.at("footprint"), notes);
  if (node.has("forks")) vehicle.forks = read_ring(node.at("forks"), notes);
  if (node.has("loads")) {
    const Node loads = node.at("loads");
    if (!loads.is_object()) loads.fail(fmt::format("it is {}", kind_of(loads.json())), "an object of loads by name");
    if (loads.is_object()) {
      for (const auto& [name, value] : loads.json().items()) {
        const Node load{value, loads.path() + "." + name, loads.context()};
        if (!load.is_object_of({"footprint", "mass"})) break;
        vehicle.loads[name] = Load{read_footprint(load.at("footprint"), notes), load.has("mass") ? load.at("mass").number(0.0, most) : 0.0};
      }
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
  if (vehicle.forks) j["forks"] = to_json(*vehicle.forks);
  if (!vehicle.loads.empty()) {
    for (const auto& [name, load] : vehicle.loads) {
      j["loads"][name] = Json{{"footprint", footprint_to_json(load.footprint)}, {"mass", load.mass}};
    }
  }
  j["mass"] = vehicle.mass;
  j["drive"] = drive_to_json(vehicle.drive);
  j["limits"] = limits_to_json(vehicle.limits);
  j["control_point"] = to_json(vehicle.control_point);
  return j;
}

Parsed<Vehicle> read_vehicle(const std::filesystem::path& file) {
  auto text = read_file(file, largest_vehicle_file);
  if (!text) return tl::unexpected{text.error()};
  auto json = parse_json(*text, file.string());
  if (!json) return tl::unexpected{json.error()};
  ReadContext context{file.string(), {}, 0};
  std::vector<std::string> notes;
  Vehicle vehicle = read_vehicle_node(Node{*json, "", context}, notes);
  if (context.error) return tl::unexpected{*context.error};
  return vehicle;
}

}  // namespace waywright
