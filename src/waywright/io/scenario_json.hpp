#pragma once

#include <filesystem>

#include "waywright/io/json_reader.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

/// The whole scenario object; what is wrong is in the context.
Scenario read_scenario_node(const Node& node, const std::filesystem::path& folder);
Json scenario_to_json(const Scenario& scenario);

Json parameters_to_json(const Parameters& parameters);

/// Checks `format` ("waywright-<what>/1"): a newer number gets its own sentence.
void check_format(const Node& node, const char* what);

/// Text of a JSON value: objects one field a line, arrays of plain values on one line.
std::string pretty(const Json& json, int indent = 2);

}  // namespace waywright
