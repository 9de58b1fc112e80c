#include "waywright/study/run_cost.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace waywright {
namespace {

bool is_docking(const std::string& planner) { return planner.starts_with("pattern_docking"); }

/// The planner's objective, with the weights that it has.
std::string objective_words(const Plan& plan) {
  std::string words = is_docking(plan.planner) ? "docking" : plan.planner;
  const auto named = plan.parameters.find("objective");
  if (named != plan.parameters.end()) {
    if (const auto* word = std::get_if<std::string>(&named->second)) words += ", " + *word;
  }
  for (const auto& [name, value] : plan.parameters) {
    const auto* number = std::get_if<double>(&value);
    if (number != nullptr && name.ends_with("_weight")) words += fmt::format(", {} {:g}", name, *number);
  }
  return words;
}

}  // namespace

std::optional<RunCost> cost_of(const Plan& plan) {
  if (plan.samples.empty()) return std::nullopt;
  const auto chosen = std::find_if(plan.alternatives.begin(), plan.alternatives.end(), [](const Alternative& a) { return a.chosen && a.cost; });
  if (chosen == plan.alternatives.end()) return std::nullopt;
  return RunCost{chosen->is_length ? "length in m" : objective_words(plan), *chosen->cost};
}

}  // namespace waywright
