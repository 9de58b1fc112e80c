// What a planner's parameters hold, by name.
#pragma once

#include <cstdint>
#include <string>

#include "waywright/scenario/scenario.hpp"

namespace waywright {

/// @pre the parameters are complete and checked against the planner's description (complete_parameters): there is one of this name and kind
inline double number_of(const Parameters& p, const char* name) { return std::get<double>(p.at(name)); }
inline std::int64_t whole_number_of(const Parameters& p, const char* name) { return static_cast<std::int64_t>(number_of(p, name)); }
inline bool flag_of(const Parameters& p, const char* name) { return std::get<bool>(p.at(name)); }
inline const std::string& word_of(const Parameters& p, const char* name) { return std::get<std::string>(p.at(name)); }

}  // namespace waywright
