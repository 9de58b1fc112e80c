#include "waywright/study/short_names.hpp"

#include <algorithm>

namespace waywright {
namespace {

bool is_outside(const Contestant& c) { return c.planner.empty(); }

bool names_setting(const Contestant& c, const std::string& setting) { return std::find(c.settings.begin(), c.settings.end(), setting) != c.settings.end(); }

bool has_parameter(const Contestant& c, const std::string& setting) {
  const PlannerDescription* planner = find_planner(c.planner);
  const std::string key = setting.substr(0, setting.find('='));
  return planner != nullptr && std::any_of(planner->parameters.begin(), planner->parameters.end(), [&](const ParameterDescription& p) { return p.name == key; });
}

std::string joined(const std::vector<std::string>& parts, const char* between) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : between) + part;
  return text;
}

}  // namespace

ShortNames short_names(const std::vector<Contestant>& contestants) {
  ShortNames result;
  for (const Contestant& c : contestants) result.names.push_back(c.label);
  if (contestants.size() < 2) return result;

  std::vector<std::string> shared;
  bool all_have_them = true;
  for (const Contestant& c : contestants) {
    for (const std::string& setting : c.settings) {
      if (std::find(shared.begin(), shared.end(), setting) != shared.end()) continue;
      const auto could = [&](const Contestant& other) { return has_parameter(other, setting); };
      const auto number = std::count_if(contestants.begin(), contestants.end(), could);
      if (number < 2 || !std::all_of(contestants.begin(), contestants.end(), [&](const Contestant& other) { return !could(other) || names_setting(other, setting); })) continue;
      shared.push_back(setting);
      all_have_them = all_have_them && number == static_cast<std::ptrdiff_t>(contestants.size());
    }
  }

  std::vector<std::vector<std::string>> own;
  for (const Contestant& c : contestants) {
    auto& left = own.emplace_back(c.settings);
    std::erase_if(left, [&](const std::string& setting) { return std::find(shared.begin(), shared.end(), setting) != shared.end(); });
  }
  // Who has nothing of its own is called by its planner.
  const bool one_planner = std::all_of(contestants.begin(), contestants.end(), [&](const Contestant& c) { return !is_outside(c) && c.planner == contestants.front().planner; }) &&
                           std::none_of(own.begin(), own.end(), [](const auto& settings) { return settings.empty(); });
  if (!one_planner && shared.empty()) return result;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const Contestant& c = contestants[i];
    const std::string settings = joined(own[i], ":");
    names.push_back(is_outside(c) ? c.label : one_planner ? settings : settings.empty() ? c.planner : c.planner + ":" + settings);
  }
  std::vector<std::string> sorted = names;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return result;  // the same settings in another order
  result.names = std::move(names);
  if (one_planner) {
    result.shared = contestants.front().planner;
    result.heading = "settings";
  }
  if (!shared.empty()) result.shared += (one_planner ? " with " : all_have_them ? "with " : "with, where a planner has it, ") + joined(shared, ", ");
  return result;
}

}  // namespace waywright
