// Trees and roadmaps among positions with headings: ours against OMPL's RRT* and PRM* with the same motions, tests, ends and shortcuts, one thread, in turn. What each is allowed
// grows from line to line (samples; OMPL's: footprint placements). CPU time, as the machine may have other work. Prints the table of docs/trees.md.
// usage: state_trees [SEEDS [SCENARIO]]
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "waywright/io/scenario_io.hpp"
#include "waywright/planner/registry.hpp"

namespace {

using namespace waywright;

struct Contestant {
  const char* name;
  std::vector<std::int64_t> samples;
};

struct Scene {
  const char* file;
  const char* space;
};

double now() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void run(const Scene& scene, const Contestant& contestant, std::int64_t samples, int seeds) {
  Scenario scenario = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + scene.file).value();
  scenario.budget = {};
  scenario.budget.samples = samples;
  const Problem problem = Problem::prepare(std::move(scenario)).value();
  const PlannerDescription& description = *find_planner(contestant.name);
  const Parameters parameters = complete_parameters(description, {{"space", std::string{scene.space}}}).value();
  double ms = 0.0, driven = 0.0;
  std::int64_t motions = 0;
  int solved = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const AnyPlanner planner = description.make(parameters, static_cast<std::uint64_t>(seed)).prepared(problem);
    Budget budget{problem.scenario().budget};
    const double begin = now();
    const PlanningResult result = planner.plan(problem, budget);
    ms += (now() - begin) / seeds;
    motions += budget.evaluations() / seeds;
    if (!result) continue;
    ++solved;
    driven += length(result->path);
  }
  fmt::print("| {} | {} | {} | {} | {} of {} | {:.1f} | {} | {} |\n", scene.file, scene.space, contestant.name, samples, solved, seeds, ms, motions,
             solved > 0 ? fmt::format("{:.2f}", driven / solved) : std::string{"–"});
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 10;
  const std::string only = argc > 2 ? argv[2] : "";
  fmt::print("| scenario | space | planner | samples | solved | CPU ms | motions tested | m driven |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const Scene& scene : {Scene{"rrt_woa/wheelchair_3.json", "turns"}, Scene{"rrt_woa/wheelchair_5.json", "turns"}, Scene{"rrt_woa/wheelchair_5.json", "dubins"},
                             Scene{"dock_cluttered.json", "reeds_shepp"}, Scene{"park_parallel.json", "reeds_shepp"}}) {
    if (!only.empty() && only != scene.file) continue;
    for (const Contestant& contestant : {Contestant{"rrt", {10'000}}, Contestant{"rrt_star", {1000, 3000, 10'000}}, Contestant{"ompl_rrt_star", {10'000, 50'000, 200'000}},
                                         Contestant{"prm", {1000, 5000}}, Contestant{"ompl_prm_star", {10'000, 50'000}}}) {
      if (std::string{scene.space} == "dubins" && std::string{contestant.name} == "ompl_prm_star") continue;
      for (const std::int64_t samples : contestant.samples) run(scene, contestant, samples, seeds);
    }
  }
}
