#include "waywright/io/zones_json.hpp"

#include <fmt/format.h>

#include "waywright/io/scenario_json.hpp"
#include "waywright/io/vehicle_io.hpp"

namespace waywright {
namespace {

Zone read_zone(const Node& node, std::vector<std::string>& notes) {
  Zone zone;
  if (!node.is_object()) {
    node.fail(fmt::format("it is {}", kind_of(node.json())), "an object");
    return zone;
  }
  const std::string type = node.at("type").word({"forbidden", "directed", "preferred", "penalty", "speed_limit"});
  if (node.failed()) return zone;
  for (const ZoneType t : zone_types) {
    if (type == to_string(t)) zone.type = t;
  }
  switch (zone.type) {
    case ZoneType::forbidden:
      if (!node.is_object_of({"type", "name", "area"})) return zone;
      break;
    case ZoneType::directed:
      if (!node.is_object_of({"type", "name", "area", "direction"})) return zone;
      zone.direction = wrap(node.at("direction").number(-1e6, 1e6));
      if (!node.failed()) {
        if (const auto doubt = heading_doubt(node.at("direction").json().get<double>())) notes.push_back(node.path() + ".direction: " + *doubt);
      }
      break;
    case ZoneType::preferred:
    case ZoneType::penalty: {
      if (!node.is_object_of({"type", "name", "area", "factor"})) return zone;
      const bool is_preferred = zone.type == ZoneType::preferred;
      const Node factor = node.at("factor");
      zone.factor = is_preferred ? factor.number(least_preference, 1.0) : factor.number(1.0, most_penalty);
      if (!node.failed() && zone.factor == 1.0) {
        factor.fail("1 changes nothing", is_preferred ? fmt::format("{} to under 1", least_preference) : fmt::format("over 1, at most {}", most_penalty));
      }
      break;
    }
    case ZoneType::speed_limit:
      if (!node.is_object_of({"type", "name", "area", "speed"})) return zone;
      zone.speed = node.at("speed").number(least_zone_speed, most_zone_speed);
      break;
  }
  if (node.has("name")) zone.name = node.at("name").text();
  const Node area = node.at("area");
  zone.area = read_ring(area, notes);
  if (!node.failed() && zone.area.size() > most_zone_corners) area.fail(fmt::format("the polygon has {} corners", zone.area.size()), fmt::format("at most {}", most_zone_corners));
  return zone;
}

}  // namespace

std::vector<Zone> read_zones(const Node& node, std::vector<std::string>& notes) {
  std::vector<Zone> zones;
  if (node.is_array() && node.json().size() > most_zones) {
    node.fail(fmt::format("there are {} zones", node.json().size()), fmt::format("at most {}", most_zones));
    return zones;
  }
  for (const Node& zone : node.elements()) {
    zones.push_back(read_zone(zone, notes));
    if (node.failed()) break;
  }
  return zones;
}

Json zones_to_json(const std::vector<Zone>& zones) {
  Json all = Json::array();
  for (const Zone& zone : zones) {
    Json j{{"type", to_string(zone.type)}};
    if (!zone.name.empty()) j["name"] = zone.name;
    j["area"] = to_json(zone.area);
    switch (zone.type) {
      case ZoneType::forbidden: break;
      case ZoneType::directed: j["direction"] = zone.direction; break;
      case ZoneType::preferred:
      case ZoneType::penalty: j["factor"] = zone.factor; break;
      case ZoneType::speed_limit: j["speed"] = zone.speed; break;
    }
    all.push_back(std::move(j));
  }
  return all;
}

}  // namespace waywright
