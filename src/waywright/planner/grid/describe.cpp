#include "waywright/planner/grid/grid_planner.hpp"

namespace waywright {
namespace {

Heuristic heuristic_of(const std::string& name) {
  for (const Heuristic h : heuristics) {
    if (name == to_string(h)) return h;
  }
  return Heuristic::free_way;
}

GridPlannerOptions options_of(const Parameters& p) {
  GridPlannerOptions options;
  options.neighbours = static_cast<Neighbours>(static_cast<int>(std::get<double>(p.at("neighbours"))));
  options.resolution = std::get<double>(p.at("resolution"));
  if (p.contains("turn_cost")) {
    options.costs.turn = std::get<double>(p.at("turn_cost"));
    const double reverse = std::get<double>(p.at("reverse_cost"));
    options.costs.reverse = reverse < 1.0 ? 0.0 : reverse;
  }
  options.heuristic = p.contains("heuristic") ? heuristic_of(std::get<std::string>(p.at("heuristic"))) : Heuristic::none;
  return options;
}

std::vector<ParameterDescription> parameters(bool has_heuristic) {
  constexpr HeadingCosts costs;
  std::vector<ParameterDescription> all{
      {.name = "neighbours", .default_value = 8.0, .summary = "moves from a cell: 4 along rows and columns, 8 with diagonals, 16 with knight's moves", .low = 4, .high = 16, .whole = true, .values = {4, 8, 16}},
      {.name = "resolution", .default_value = 0.0, .summary = "size of a cell; 0: the map's own cells, else 0.05, doubled until there are at most four million", .unit = "m", .low = 0,
       .high = 100},
      {.name = "turn_cost", .default_value = costs.turn, .summary = "metres that a radian of turning on the spot counts as, of footprints that are no disc", .unit = "m", .low = 0, .high = 100},
      {.name = "reverse_cost", .default_value = costs.reverse, .summary = "metres that a metre backwards counts as, of footprints that are no disc; under 1: never backwards", .low = 0,
       .high = 100},
  };
  if (!has_heuristic) return all;
  std::vector<std::string> names;
  for (const Heuristic h : heuristics) names.emplace_back(to_string(h));
  all.insert(all.begin() + 1, {.name = "heuristic", .default_value = std::string{to_string(Heuristic::free_way)},
                               .summary = "what is expected of the rest of the way; free_way: its length if nothing were in it", .choices = names});
  return all;
}

PlannerDescription theta_star_description() {
  std::vector<ParameterDescription> some = parameters(false);
  some.resize(2);  // neighbours and resolution: a disc has no headings
  PlannerDescription d{"theta_star", "ways at any angle over a grid by lazy Theta*, pulled taut, never longer than astar's; of a disc, or the disc around the footprint", std::move(some),
                       [](const Parameters& p, std::uint64_t) -> AnyPlanner {
                         GridPlannerOptions options = options_of(p);
                         options.heuristic = Heuristic::free_way;
                         options.any_angle = true;
                         return GridPlanner{"theta_star", options};
                       }};
  d.counts_expansions = true;
  d.turns_on_the_spot = true;
  d.heeds_zones = [](const Parameters&) { return true; };
  d.takes_free_goals = true;
  return d;
}

}  // namespace

std::vector<PlannerDescription> grid_planner_descriptions() {
  std::vector<PlannerDescription> all;
  for (const char* name : {"dijkstra", "astar"}) {
    const bool has_heuristic = std::string_view{name} == "astar";
    PlannerDescription d{name,
                         has_heuristic ? "shortest way over the cells of a grid, straight lines and turns on the spot, for vehicles that can; A* with a heuristic of choice"
                                       : "the same without a heuristic, searching outwards on all sides",
                         parameters(has_heuristic), [name = std::string{name}](const Parameters& p, std::uint64_t) -> AnyPlanner { return GridPlanner{name, options_of(p)}; }};
    d.counts_expansions = true;
    d.turns_on_the_spot = true;
    d.heeds_zones = [](const Parameters&) { return true; };
    d.takes_free_goals = true;
    all.push_back(std::move(d));
  }
  all.push_back(theta_star_description());
  return all;
}

}  // namespace waywright
