#include "waywright/planner/grid/safe_planner.hpp"

namespace waywright {
namespace {

std::vector<ParameterDescription> common() {
  return {
      {.name = "form", .default_value = std::string{"corrected"},
       .summary = "corrected: danger counts as cost, and each move is tested for the vehicle; published: as printed, from cell to cell and past corners, for comparison",
       .choices = {"corrected", "published"}},
      {.name = "resolution", .default_value = 0.0, .summary = "size of a cell; 0: the map's own cells, else 0.05, doubled until there are at most four million", .unit = "m", .low = 0, .high = 100},
  };
}

std::vector<ParameterDescription> with_danger() {
  std::vector<ParameterDescription> all = common();
  all.push_back({.name = "danger_radius", .default_value = 0.0,
                 .summary = "blocked cells within it are dangerous; 0: 1.5 times the radius of the disc that is searched, at least 1.5 cells", .unit = "m", .low = 0, .high = 100});
  all.push_back({.name = "danger_weight", .default_value = 1.0, .summary = "a metre costs 1 + danger_weight times the danger coefficient, of form corrected", .low = 0, .high = 100});
  return all;
}

PlannerDescription description(const char* name, const char* summary, PublishedMethod method, std::vector<ParameterDescription> parameters) {
  PlannerDescription d{name, summary, std::move(parameters), [name = std::string{name}, method](const Parameters& p, std::uint64_t) -> AnyPlanner {
                         const auto number = [&](const char* key, double otherwise) { return p.contains(key) ? std::get<double>(p.at(key)) : otherwise; };
                         SafePlannerOptions options;
                         options.method = method;
                         options.is_published = std::get<std::string>(p.at("form")) == "published";
                         options.neighbours = static_cast<Neighbours>(static_cast<int>(number("neighbours", 8.0)));
                         options.resolution = number("resolution", 0.0);
                         options.danger_radius = number("danger_radius", 0.0);
                         options.danger_weight = number("danger_weight", 1.0);
                         options.local_radius = number("local_radius", 3.0);
                         options.regularise = p.contains("regularise") && std::get<bool>(p.at("regularise"));
                         return SafePlanner{name, options};
                       }};
  d.counts_expansions = true;
  d.turns_on_the_spot = true;
  d.heeds_zones = [](const Parameters& p) { return std::get<std::string>(p.at("form")) == "corrected"; };
  d.takes_free_goals = method == PublishedMethod::danger;  // the others aim at a point from the beginning
  return d;
}

}  // namespace

std::vector<PlannerDescription> safe_planner_descriptions() {
  std::vector<ParameterDescription> danger = with_danger(), block = common(), safe = with_danger();
  danger.push_back({.name = "neighbours", .default_value = 8.0, .summary = "moves from a cell: 4 along rows and columns, 8 with diagonals, 16 with knight's moves", .low = 4, .high = 16, .whole = true,
                    .values = {4, 8, 16}});
  block.push_back({.name = "local_radius", .default_value = 3.0, .summary = "so far before and behind an obstacle on the line the search begins and ends", .unit = "m", .low = 0.1, .high = 100});
  safe.push_back({.name = "regularise", .default_value = false, .summary = "rectangles in place of obstacles that are not convex"});
  return {
      description("danger_astar", "S_A*: A* that keeps away from obstacles by the safe-A* publication's danger coefficient; of a disc, or the disc around the footprint", PublishedMethod::danger,
                  std::move(danger)),
      description("block_astar", "the straight line to the goal, with A* around each obstacle on it", PublishedMethod::line, std::move(block)),
      description("safe_astar", "SHA*: 16 moves and danger up to where a boundary point sees the goal, then straight", PublishedMethod::boundary, std::move(safe)),
  };
}

}  // namespace waywright
