#include "waywright/planner/tree/tree_planner.hpp"
#include "waywright/scenario/parameter_values.hpp"

namespace waywright {
namespace {

std::vector<ParameterDescription> tree_parameters(TreeMethod method) {
  constexpr double iterations = 10'000.0;
  std::vector<ParameterDescription> all{
      {.name = "iterations", .default_value = iterations, .summary = "samples drawn; budget.samples takes its place", .low = 1, .high = 1e7, .whole = true},
      {.name = "step", .default_value = 1.0, .summary = "longest edge that the tree grows by", .unit = "m", .low = 1e-3, .high = 1e4},
      {.name = "goal_threshold", .default_value = 1.0, .summary = "from so near the goal is looked for", .unit = "m", .low = 1e-3, .high = 1e4},
      {.name = "goal_bias", .default_value = 0.0, .summary = "share of the samples that are the goal", .low = 0, .high = 0.9},
      {.name = "shorten", .default_value = true, .summary = "leave out corners past which their neighbours see each other"},
  };
  if (method == TreeMethod::rrt || method == TreeMethod::rrt_star) {
    all[2].summary = "straight distance from which on the goal is looked for";
    all[4].summary = "leave out corners past which their neighbours see each other; with headings, try motions between places on the way";
    for (ParameterDescription& p : space_parameters("reeds_shepp for a tricycle, plane where a disc serves, else or where that fails turns")) all.push_back(std::move(p));
    all.push_back(resolution_parameter());
  }
  if (method == TreeMethod::rrt) return all;
  const std::vector<ParameterDescription> star{
      {.name = "radius", .default_value = 0.0, .summary = "within which better parents are looked for; 0: that of the proof of optimality, which shrinks as the tree grows", .unit = "m", .low = 0, .high = 1e4},
      {.name = "first_path", .default_value = false, .summary = "end with the first way, as published; else with the last sample"},
      {.name = "informed", .default_value = true, .summary = "once there is a way, draw only where a shorter one can lead past"},
  };
  all.insert(all.end(), star.begin(), star.end());
  if (method == TreeMethod::rrt_star) {
    all[all.size() - star.size()].summary += "; with headings as many nearest states as it asks for";
    return all;
  }
  const bool is_local = method == TreeMethod::woa_local;
  const std::vector<ParameterDescription> whales{
      {.name = "population", .default_value = 10.0, .summary = "agents of the whale optimisation algorithm", .low = 2, .high = 1000, .whole = true},
      {.name = "woa_iterations", .default_value = 10.0, .summary = "its iterations", .low = 1, .high = 1000, .whole = true},
      {.name = "a0", .default_value = is_local ? 2.0 : 4.0, .summary = "how far agents go at the beginning", .low = 0, .high = 100},
      {.name = "b", .default_value = 1.0, .summary = "how fast the spiral opens", .low = 0, .high = 20},
      {.name = "mu", .default_value = 0.5, .summary = "share of the moves that encircle or search; the others are spirals", .low = 0, .high = 1},
      {.name = "lambda", .default_value = 1.0, .summary = "|A| under it: encircle the best; else: search about another agent", .low = 0, .high = 1000},
      {.name = "bound", .default_value = 2.5, .summary = is_local ? "radius of the disc around the sample that is searched" : "that each coordinate of a corner may leave its place by", .unit = "m",
       .low = 1e-3, .high = 1e3},
  };
  all.insert(all.end(), whales.begin(), whales.end());
  if (is_local) {
    const std::vector<ParameterDescription> weights{
        {.name = "sample_weight", .default_value = 0.2, .summary = "of the distance to the sample, in radii", .low = 0, .high = 1e3},
        {.name = "goal_weight", .default_value = 1.0, .summary = "of the distance to the goal, in diagonals of the map", .low = 0, .high = 1e3},
        {.name = "near_weight", .default_value = 4.0, .summary = "of not being seen from the tree", .low = 0, .high = 1e3},
        {.name = "view_weight", .default_value = 2.0, .summary = "of not seeing the goal", .low = 0, .high = 1e3},
    };
    all.insert(all.end(), weights.begin(), weights.end());
  } else {
    all.push_back({.name = "rounds", .default_value = 12.0, .summary = "of dropping, inserting and moving corners; 0: corners are moved once, as published", .low = 0, .high = 1000, .whole = true});
  }
  return all;
}

PlannerDescription described(const char* name, const char* summary, TreeMethod method) {
  PlannerDescription d{name, summary, tree_parameters(method), [name = std::string{name}, method](const Parameters& p, std::uint64_t seed) -> AnyPlanner {
                         TreePlannerOptions options;
                         options.method = method;
                         options.tree.samples = whole_number_of(p, "iterations");
                         options.tree.step = number_of(p, "step");
                         options.tree.goal_threshold = number_of(p, "goal_threshold");
                         options.tree.goal_bias = number_of(p, "goal_bias");
                         options.shortens = flag_of(p, "shorten");
                         if (method == TreeMethod::rrt || method == TreeMethod::rrt_star) options.space = space_options(p);
                         options.tree.rewires = method != TreeMethod::rrt;
                         options.tree.first_path = method == TreeMethod::rrt || flag_of(p, "first_path");
                         if (options.tree.rewires) {
                           options.tree.radius = number_of(p, "radius");
                           options.tree.informed = flag_of(p, "informed");
                         }
                         if (method == TreeMethod::woa_local || method == TreeMethod::woa_global) {
                           const WhaleParameters whale{number_of(p, "a0"), number_of(p, "b"), number_of(p, "mu"), number_of(p, "lambda")};
                           const int population = static_cast<int>(number_of(p, "population")), iterations = static_cast<int>(number_of(p, "woa_iterations"));
                           if (method == TreeMethod::woa_local) {
                             options.steering = {population,
                                                 iterations,
                                                 number_of(p, "bound"),
                                                 number_of(p, "sample_weight"),
                                                 number_of(p, "goal_weight"),
                                                 number_of(p, "near_weight"),
                                                 number_of(p, "view_weight"),
                                                 whale};
                           } else {
                             options.refinement = {population, iterations, number_of(p, "bound"), whale};
                             options.rounds = static_cast<int>(number_of(p, "rounds"));
                           }
                         }
                         return TreePlanner{name, options, seed};
                       }};
  d.counts_samples = [](const Parameters&) { return true; };
  d.takes_free_goals = true;
  d.turns_on_the_spot = method == TreeMethod::woa_local || method == TreeMethod::woa_global;
  return d;
}

}  // namespace

std::vector<PlannerDescription> tree_planner_descriptions() {
  return {
      described("rrt", "RRT, shortened: in the plane of a disc, or the disc around the footprint; among headings of the footprint itself, with turns on the spot, Dubins or Reeds-Shepp curves", TreeMethod::rrt),
      described("rrt_star", "RRT*, with its gap to the shortest way: in the plane as rrt, or among headings of the footprint itself", TreeMethod::rrt_star),
      described("rrt_star_woa_local", "RRT* whose every extension is aimed by the whale optimisation algorithm", TreeMethod::woa_local),
      described("rrt_star_woa_global", "RRT*, and the whale optimisation algorithm on the way that it found", TreeMethod::woa_global),
  };
}

}  // namespace waywright
