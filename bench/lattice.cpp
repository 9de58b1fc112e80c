// `clearance_optimal` on examples, beside OMPL's RRTConnect on the same problems in the same run: medians of times, and what the paths are like. Prints the table of
// docs/performance.md. usage: lattice [repetitions]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/plan.hpp"
#include "waywright/planner/registry.hpp"

namespace {

using namespace waywright;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

struct Row {
  Plan plan;
  double prepare = 0.0, time = 0.0;  // s, medians
};

Row measured(Scenario scenario, PlannerChoice planner, int repetitions) {
  scenario.planner = std::move(planner);
  std::vector<double> prepare, time;
  Row row;
  for (int i = 0; i < repetitions; ++i) {
    scenario.seed = static_cast<std::uint64_t>(1 + i);
    row.plan = *solve(*Problem::prepare(scenario));
    prepare.push_back(row.plan.timing.prepare);
    time.push_back(row.plan.timing.plan);
  }
  row.prepare = median(prepare);
  row.time = median(time);
  return row;
}

}  // namespace

int main(int argc, char** argv) {
  const int repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 9;
  fmt::print("| scenario | planner | prepare ms | plan ms | expansions | length m | changes | driven s | least / mean clearance m |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const char* name : {"dock_left", "dock_cluttered", "dock_insertion", "dock_warehouse", "goal_pose", "grid_tugger", "grid_warehouse"}) {
    const auto scenario = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + name + ".json");
    if (!scenario) return 2;
    const std::pair<const char*, PlannerChoice> contestants[]{
        {"clearance_optimal", {"clearance_optimal", {}}},
        {"with gap 0.2", {"clearance_optimal", {{"gap", 0.2}}}},
        {"ompl_rrt_connect", {"ompl_rrt_connect", {}}},
    };
    for (const auto& [title, planner] : contestants) {
      const Row row = measured(*scenario, planner, repetitions);
      if (row.plan.status != Status::solved) {
        fmt::print("| {} | {} | {:.0f} | {:.1f} | {} | {} | | | |\n", name, title, row.prepare * 1e3, row.time * 1e3, row.plan.effort.expansions, to_string(row.plan.status));
        continue;
      }
      const Metrics& m = row.plan.metrics;
      fmt::print("| {} | {} | {:.0f} | {:.1f} | {} | {:.2f} | {} | {:.1f} | {:.3f} / {:.3f} |\n", name, title, row.prepare * 1e3, row.time * 1e3, row.plan.effort.expansions, m.length,
                 m.direction_changes, m.travel_time, m.min_clearance, m.mean_clearance);
    }
  }
  return 0;
}
