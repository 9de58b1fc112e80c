// Contestants named by what differs, for tables and pictures.
#pragma once

#include <string>
#include <vector>

#include "waywright/study/compare.hpp"

namespace waywright {

struct ShortNames {
  std::string shared;              ///< "waypoint_clothoid with objective=metres, optimizer=de"; empty where nothing is
  const char* heading = "planner";  ///< of the names: "settings" where the planner is shared
  std::vector<std::string> names;  ///< of each contestant, unique
};

/// A planner that all have, and settings that everybody names whose planner has the parameter, are taken out of the names and told once. Outside
/// programs have neither. One contestant alone keeps its label.
ShortNames short_names(const std::vector<Contestant>& contestants);

}  // namespace waywright
