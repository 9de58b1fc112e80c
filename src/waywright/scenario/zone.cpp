#include "waywright/scenario/zone.hpp"

#include <fmt/format.h>

#include "waywright/core/result.hpp"

namespace waywright {

const char* to_string(ZoneType type) {
  switch (type) {
    case ZoneType::forbidden: return "forbidden";
    case ZoneType::directed: return "directed";
    case ZoneType::preferred: return "preferred";
    case ZoneType::penalty: return "penalty";
    case ZoneType::speed_limit: return "speed_limit";
  }
  return "";
}

const char* meaning_of(ZoneType type) {
  switch (type) {
    case ZoneType::forbidden: return "the whole footprint keeps out, with the clearance that is asked for, as of an obstacle";
    case ZoneType::directed: return "one way: the course of the vehicle's origin is at most 90 degrees off `direction` (rad); turning on the spot is allowed";
    case ZoneType::preferred: return "a metre of the origin's path costs `factor` metres, under 1 (0.01 at least); overlapping zones multiply";
    case ZoneType::penalty: return "a metre of the origin's path costs `factor` metres, over 1 (1000 at most); overlapping zones multiply";
    case ZoneType::speed_limit: return "at most `speed` (m/s) while any part of the footprint is in it";
  }
  return "";
}

std::string title_of(const Zone& zone, std::size_t index) {
  return zone.name.empty() ? fmt::format("zone {}", index) : fmt::format("zone \"{}\"", one_line(zone.name));
}

}  // namespace waywright
