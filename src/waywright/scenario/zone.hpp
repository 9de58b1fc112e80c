// Areas of the floor with a rule. Plain values; what they mean stands in docs/formats.md, their geometry in zone_rules.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

enum class ZoneType { forbidden, directed, preferred, penalty, speed_limit };
inline constexpr std::array zone_types{ZoneType::forbidden, ZoneType::directed, ZoneType::preferred, ZoneType::penalty, ZoneType::speed_limit};
const char* to_string(ZoneType type);
/// In one line: what holds in such a zone, and what a scenario tells of it.
const char* meaning_of(ZoneType type);

struct Zone {
  ZoneType type = ZoneType::forbidden;
  std::string name;        ///< for sentences; may be empty
  Ring area;               ///< counter-clockwise
  double direction = 0.0;  ///< directed: rad, (−π, π]
  double factor = 1.0;     ///< preferred: least_preference to under 1; penalty: over 1 to most_penalty
  double speed = 1.0;      ///< speed_limit: m/s, least_zone_speed or more
};

inline constexpr double least_preference = 0.01;
inline constexpr double most_penalty = 1000.0;
inline constexpr double least_zone_speed = 0.001;  ///< m/s
inline constexpr double most_zone_speed = 1000.0;  ///< m/s
inline constexpr std::size_t most_zones = 1000;
inline constexpr std::size_t most_zone_corners = 1000;  ///< of one

/// How sentences name it: zone "crossing", or zone 2 where it has no name.
std::string title_of(const Zone& zone, std::size_t index);

}  // namespace waywright
