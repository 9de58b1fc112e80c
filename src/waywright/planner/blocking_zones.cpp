#include "waywright/planner/blocking_zones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace waywright {
namespace {

constexpr std::size_t most_named = 4;

bool is_rule(const Zone& zone) { return zone.type == ZoneType::forbidden || zone.type == ZoneType::directed; }

/// Is the footprint too near to it anywhere?
bool stands_in(const Zone& zone, const Problem& problem, const std::vector<Sample>& samples) {
  World area;
  area.add_obstacle(zone.area, "");
  area.build();
  return std::any_of(samples.begin(), samples.end(), [&](const Sample& s) { return !area.is_free(problem.footprint(), s.pose(), problem.required_clearance()); });
}

bool is_against(const Zone& zone, const std::vector<Sample>& samples) {
  const Box box = bounding_box(zone.area);
  return std::any_of(samples.begin(), samples.end(), [&](const Sample& s) {
    return s.direction != 0 && box.contains({s.x, s.y}) && contains(zone.area, {s.x, s.y}) && dot(unit(s.course), unit(zone.direction)) < -zone_course;
  });
}

}  // namespace

std::string blocking_zones_words(const Problem& problem, const PlannerDescription& planner, const Parameters& complete, const std::atomic<bool>* cancel) {
  const std::vector<Zone>& zones = problem.scenario().zones;
  if (std::none_of(zones.begin(), zones.end(), is_rule)) return {};
  Scenario scenario = problem.scenario();
  scenario.zones.erase(std::remove_if(scenario.zones.begin(), scenario.zones.end(), is_rule), scenario.zones.end());
  const auto without = Problem::prepare(std::move(scenario));
  if (!without) return {};
  Budget budget{problem.scenario().budget, cancel};
  const PlanningResult found = planner.make(complete, problem.scenario().seed).prepared(*without).plan(*without, budget);
  if (!found) return {};
  const Path path = without->whole_path(found->path, found->begins_in_motion);
  constexpr double tolerance = 1e-3;  // m: for words
  if (!can_be_sampled(path, problem.footprint().radius(), tolerance)) return {};
  const std::vector<Sample> samples = sample(path, problem.footprint().radius(), tolerance);
  std::vector<std::string> met;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    if (zones[i].type == ZoneType::forbidden && stands_in(zones[i], problem, samples)) met.push_back(title_of(zones[i], i) + " (forbidden)");
    if (zones[i].type == ZoneType::directed && is_against(zones[i], samples)) met.push_back(title_of(zones[i], i) + " (directed, against the way)");
  }
  if (met.empty()) return {};
  std::string names;
  const std::size_t named = std::min(met.size(), most_named);
  for (std::size_t i = 0; i < named; ++i) names += (i == 0 ? "" : i + 1 == met.size() ? " and " : ", ") + met[i];
  if (met.size() > named) names += fmt::format(" and {} more", met.size() - named);
  return fmt::format("{} stand{} in the way: without forbidden and directed zones there is one of {:.3f} m", names, met.size() == 1 ? "s" : "", length(path));
}

}  // namespace waywright
