// Parameters against their description: one place for JSON, command line and listings.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "waywright/core/spelling.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {
namespace {

std::string range_of(const ParameterDescription& p) { return fmt::format("{} to {}{}{}", p.low, p.high, p.unit.empty() ? "" : " ", p.unit); }

std::vector<std::string> names_of(const PlannerDescription& planner) {
  std::vector<std::string> names;
  for (const ParameterDescription& p : planner.parameters) names.push_back(p.name);
  return names;
}

/// What is said of a parameter that the planner does not have.
InputError unknown_parameter(const PlannerDescription& planner, std::string field, const std::string& name) {
  const std::vector<std::string> names = names_of(planner);
  return InputError{"", std::move(field), fmt::format("{} has no such parameter{}", planner.name, meant_instead(name, names)), names.empty() ? "none" : list_of_words(names)};
}

const ParameterDescription* find(const PlannerDescription& planner, const std::string& name) {
  const auto it = std::find_if(planner.parameters.begin(), planner.parameters.end(),
                               [&](const ParameterDescription& p) { return p.name == name; });
  return it == planner.parameters.end() ? nullptr : &*it;
}

std::optional<InputError> check(const ParameterDescription& p, const ParameterValue& value) {
  const std::string field = "planner." + p.name;
  if (value.index() != p.default_value.index()) {
    const char* kind = p.default_value.index() == 0 ? "true or false" : p.default_value.index() == 1 ? "a number" : "a word";
    return InputError{"", field, "it has the wrong type", kind};
  }
  if (const auto* number = std::get_if<double>(&value)) {
    if (!(*number >= p.low && *number <= p.high)) {
      return InputError{"", field, fmt::format("{} is out of range", *number), range_of(p)};
    }
    if (!p.values.empty() && std::find(p.values.begin(), p.values.end(), *number) == p.values.end()) {
      return InputError{"", field, fmt::format("{} is not one of them", *number), fmt::format("{}", fmt::join(p.values, ", "))};
    }
    if (p.whole && std::floor(*number) != *number) {
      return InputError{"", field, fmt::format("{} is not a whole number", *number), range_of(p)};
    }
  }
  if (const auto* word = std::get_if<std::string>(&value)) {
    if (std::find(p.choices.begin(), p.choices.end(), *word) == p.choices.end()) {
      return InputError{"", field, fmt::format("\"{}\" is not known{}", *word, meant_instead(*word, p.choices)), list_of_words(p.choices)};
    }
  }
  return std::nullopt;
}

/// What is said of a planner's name that is not known, with the name that may have been meant.
InputError unknown_planner(const std::string& name, std::string field) {
  std::vector<std::string> names;
  for (const PlannerDescription& p : planners()) names.push_back(p.name);
  return InputError{"", std::move(field), fmt::format("\"{}\" is not known{}", name, meant_instead(name, names)), list_of_words(names)};
}

}  // namespace

Parsed<Parameters> complete_parameters(const PlannerChoice& choice) {
  const PlannerDescription* planner = find_planner(choice.name);
  if (planner == nullptr) {
    return tl::unexpected{unknown_planner(choice.name, "planner.name")};
  }
  return complete_parameters(*planner, choice.parameters);
}

Parsed<Parameters> complete_parameters(const PlannerDescription& planner, const Parameters& given) {
  Parameters complete;
  for (const ParameterDescription& p : planner.parameters) complete[p.name] = p.default_value;
  for (const auto& [name, value] : given) {
    const ParameterDescription* p = find(planner, name);
    if (p == nullptr) {
      return tl::unexpected{unknown_parameter(planner, "planner." + name, name)};
    }
    if (auto error = check(*p, value)) return tl::unexpected{*error};
    complete[name] = value;
  }
  return complete;
}

Parsed<void> check_mission(const std::string& planner, const Scenario& scenario) {
  const PlannerDescription* description = find_planner(planner);
  if (description == nullptr) return {};
  const auto passes = [&](const PlannerDescription& p) { return scenario.waypoints.empty() || p.passes_waypoints; };
  const auto ends = [&](const PlannerDescription& p) { return !std::holds_alternative<FreeGoal>(scenario.mission) || p.takes_free_goals; };
  // Whoever takes goals with a free heading drives straight lines with turns on the spot to them.
  const bool needs_turns = std::holds_alternative<FreeGoal>(scenario.mission);
  const auto drives = [&](const PlannerDescription& p) { return scenario.vehicle.can_turn_on_the_spot() || !(p.turns_on_the_spot || needs_turns); };
  const auto able = [&](const auto& can) {
    std::string names;
    for (const PlannerDescription& p : planners()) {
      if (can(p)) names += (names.empty() ? "" : ", ") + p.name;
    }
    return names;
  };
  const auto refuse = [&](const char* what, std::string who) { return tl::unexpected{InputError{"", "planner.name", fmt::format("{} {}", planner, what), std::move(who)}}; };
  if (needs_turns && !scenario.vehicle.can_turn_on_the_spot()) {
    return tl::unexpected{InputError{"", "goal", "it leaves the heading free, which planners take for vehicles that turn on the spot, and a tricycle cannot", "a pose [x, y, heading]"}};
  }
  if (!passes(*description)) return refuse("does not plan through waypoints", able(passes));
  if (!ends(*description)) return refuse("plans to a goal pose, and this goal leaves the heading free", able(ends));
  if (const auto space = scenario.planner.parameters.find("space"); scenario.planner.name == planner && space != scenario.planner.parameters.end() && !scenario.vehicle.can_turn_on_the_spot()) {
    const auto* word = std::get_if<std::string>(&space->second);
    if (word != nullptr && (*word == "plane" || *word == "turns")) {
      return tl::unexpected{InputError{"", "planner.space", fmt::format("in the space \"{}\" {} plans straight lines with turns on the spot, which a tricycle cannot drive", *word, planner), "reeds_shepp, dubins"}};
    }
  }
  if (!drives(*description)) {
    return refuse("plans straight lines with turns on the spot, which a tricycle cannot drive", able([&](const PlannerDescription& p) { return drives(p) && passes(p) && ends(p); }));
  }
  return {};
}

Parsed<void> check_budget(const std::string& planner, const Parameters& complete, const BudgetLimits& budget) {
  const PlannerDescription* description = find_planner(planner);
  const bool counts_samples = description != nullptr && description->counts_samples && description->counts_samples(complete);
  const bool counts_expansions = description != nullptr && description->counts_expansions;
  const char* allowed = counts_expansions ? "evaluations, expansions, seconds" : counts_samples ? "evaluations, samples, seconds" : "evaluations, seconds";
  if (budget.expansions && !counts_expansions) return tl::unexpected{InputError{"", "budget.expansions", fmt::format("{} counts no expansions", planner), allowed}};
  if (budget.samples && !counts_samples) {
    return tl::unexpected{InputError{"", "budget.samples", fmt::format("{} counts no samples", planner), allowed}};
  }
  return {};
}

Parsed<void> set_parameter(const PlannerDescription& planner, Parameters& parameters, const std::string& key_value) {
  const auto equals = key_value.find('=');
  if (equals == std::string::npos || equals == 0) {
    return tl::unexpected{InputError{"", "--set", fmt::format("\"{}\" is not KEY=VALUE", key_value), ""}};
  }
  const std::string key = key_value.substr(0, equals);
  const std::string text = key_value.substr(equals + 1);
  const ParameterDescription* p = find(planner, key);
  if (p == nullptr) {
    return tl::unexpected{unknown_parameter(planner, "--set " + key, key)};
  }
  ParameterValue value;
  if (std::holds_alternative<bool>(p->default_value)) {
    if (text != "true" && text != "false") {
      return tl::unexpected{InputError{"", "--set " + key, fmt::format("\"{}\" is not a truth value", text), "true, false"}};
    }
    value = text == "true";
  } else if (std::holds_alternative<double>(p->default_value)) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !std::isfinite(number)) {
      return tl::unexpected{InputError{"", "--set " + key, fmt::format("\"{}\" is not a number", text),
                                       range_of(*p)}};
    }
    value = number;
  } else {
    value = text;
  }
  if (auto error = check(*p, value)) {
    error->field = "--set " + key;
    return tl::unexpected{*error};
  }
  parameters[key] = value;
  return {};
}

}  // namespace waywright
