// SHA* against A* over 16 neighbours with the same danger, prepared, on the publication's experiments; whole plans with the path made, not proven. In turn, one
// thread, medians. Prints the table of docs/performance.md.
// usage: safe_ways [repetitions]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "waywright/map/published_maps.hpp"
#include "waywright/planner/registry.hpp"

namespace {

using namespace waywright;

double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Contestant {
  const char* name;
  Parameters parameters;
  std::vector<Problem> problems{};
  std::vector<AnyPlanner> planners{};
  std::vector<double> seconds{};
  std::int64_t expansions = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 201;
  fmt::print("| map | A*, 16 neighbours, danger: ms, expansions | SHA*: ms, expansions | share of the time |\n| --- | --- | --- | --- |\n");
  double all_of_first = 0.0, all_of_second = 0.0;
  for (const std::string& name : published_map_names()) {
    const auto map = published_map(name);
    std::vector<Contestant> contestants{{"danger_astar", {{"neighbours", 16.0}}}, {"safe_astar", {}}};
    for (Contestant& c : contestants) {
      c.problems.reserve(map->tasks.size());
      for (const PublishedTask& task : map->tasks) {
        Scenario scenario;
        scenario.map.grids = {map->grid};
        scenario.vehicle.footprint = {{}, 0.0};
        scenario.vehicle.drive = Differential{0.6};
        scenario.start = make_pose(task.start, 0.0);
        scenario.mission = make_pose(task.goal, 0.0);
        scenario.planner = {c.name, c.parameters};
        auto problem = Problem::prepare(scenario);
        const auto parameters = complete_parameters(scenario.planner);
        if (!problem || !parameters) return 2;
        c.problems.push_back(std::move(*problem));
        c.planners.push_back(find_planner(c.name)->make(*parameters, 1).prepared(c.problems.back()));
      }
    }
    for (int i = -1; i < repetitions; ++i) {
      for (Contestant& c : contestants) {
        const double begin = now();
        c.expansions = 0;
        for (std::size_t k = 0; k < c.problems.size(); ++k) {
          Budget budget;
          if (!c.planners[k].plan(c.problems[k], budget)) return 1;
          c.expansions += budget.expansions();
        }
        if (i >= 0) c.seconds.push_back(now() - begin);
      }
    }
    const double first = 1e3 * median(contestants[0].seconds), second = 1e3 * median(contestants[1].seconds);
    all_of_first += first;
    all_of_second += second;
    fmt::print("| {}, {} | {:.3f}, {} | {:.3f}, {} | {:.2f} |\n", name, map->tasks.size() == 1 ? "one way" : fmt::format("{} ways", map->tasks.size()), first, contestants[0].expansions, second,
               contestants[1].expansions, second / first);
  }
  fmt::print("| all | {:.3f} | {:.3f} | {:.2f} |\n", all_of_first, all_of_second, all_of_second / all_of_first);
}
