#include <fmt/format.h>

#include "waywright/planner/ompl/ompl_planner.hpp"
#include "waywright/scenario/parameter_values.hpp"

namespace waywright {
namespace {

/// OMPL's own parameters, by its names and with its defaults. Those are left out that do nothing in the library's release, that would end a search before its
/// work is done (stop_on_each_solution_improvement), that test less than whole motions (intermediate_states), or that need the library's own sampler.
using Own = std::vector<ParameterDescription>;

ParameterDescription range_parameter() {
  return {.name = "range", .default_value = 0.0, .summary = "longest motion that a tree grows by at once; 0: a fifth of the extent searched", .unit = "m", .low = 0.0, .high = 1e4};
}
ParameterDescription goal_bias() {
  return {.name = "goal_bias", .default_value = 0.05, .summary = "share of the draws that are the goal", .low = 0.0, .high = 1.0};
}
ParameterDescription rewire_factor(double factor, double high) {
  return {.name = "rewire_factor", .default_value = factor, .summary = "neighbours looked at, over the least number that converges", .low = 1.0, .high = high};
}
ParameterDescription flag(const char* name, bool value, const char* summary) { return {.name = name, .default_value = value, .summary = summary}; }
ParameterDescription whole(const char* name, double value, const char* summary, double low, double high) {
  return {.name = name, .default_value = value, .summary = summary, .low = low, .high = high, .whole = true};
}
ParameterDescription share(const char* name, double value, const char* summary) { return {.name = name, .default_value = value, .summary = summary, .low = 0.0, .high = 1.0}; }

Own of_trees() {
  return {range_parameter(),
          goal_bias(),
          rewire_factor(1.1, 2.0),
          flag("use_k_nearest", true, "the nearest so many are neighbours; else those within a radius"),
          flag("delay_collision_checking", true, "test neighbours in the order of their cost, until one is free"),
          share("prune_threshold", 0.05, "gain in cost, as a share, after which the tree is pruned"),
          whole("number_sampling_attempts", 100, "draws that are tried for one that can shorten the path", 10, 1e5)};
}

Own own_parameters(SamplingPlanner planner) {
  switch (planner) {
    case SamplingPlanner::rrt_connect: return {range_parameter()};
    case SamplingPlanner::rrt_star: {
      Own own = of_trees();
      own.push_back(flag("tree_pruning", false, "take out of the tree what cannot shorten the path"));
      own.push_back(flag("new_state_rejection", false, "leave out new states that cannot shorten the path"));
      own.push_back(flag("sample_rejection", false, "draw again where a draw cannot shorten the path"));
      own.push_back(flag("use_admissible_heuristic", true, "prune by a bound of the cost from the start; else by the cost in the tree"));
      return own;
    }
    case SamplingPlanner::informed_rrt_star: {
      Own own = of_trees();
      own.push_back(flag("ordered_sampling", false, "take draws in the order of what they promise, a batch at a time"));
      own.push_back(whole("ordering_batch_size", 1, "draws of such a batch", 1, 1e6));
      return own;
    }
    case SamplingPlanner::bit_star:
      return {rewire_factor(1.1, 3.0),
              whole("samples_per_batch", 100, "states drawn at a time", 1, 1e6),
              flag("use_k_nearest", true, "the nearest so many are neighbours; else those within a radius"),
              flag("use_graph_pruning", true, "take out of the graph what cannot shorten the path"),
              share("prune_threshold_as_fractional_cost_change", 0.05, "gain in cost, as a share, after which it is pruned"),
              flag("drop_unconnected_samples_on_prune", false, "pruning takes out all states outside of the tree"),
              flag("find_approximate_solutions", false, "where no way is found, tell the one nearest to the goal")};
    case SamplingPlanner::ait_star:
      return {rewire_factor(1.0, 3.0), whole("samples_per_batch", 100, "states drawn at a time", 1, 1000),
              flag("use_k_nearest", true, "the nearest so many are neighbours; else those within a radius"), flag("use_graph_pruning", true, "take out of the graph what cannot shorten the path"),
              flag("find_approximate_solutions", true, "where no way is found, tell the one nearest to the goal")};
    case SamplingPlanner::prm_star: return {};
    case SamplingPlanner::kpiece: break;
  }
  return {range_parameter(), goal_bias(), share("border_fraction", 0.9, "share of the draws from cells at the border of what was explored"),
          {.name = "failed_expansion_score_factor", .default_value = 0.5, .summary = "what a cell's score is multiplied by where a motion from it failed", .low = 1e-3, .high = 1.0},
          share("min_valid_path_fraction", 0.2, "free share of a motion from which on its beginning is kept")};
}

/// So that a plan takes about a second: planners that draw in batches spend far more time on each placement.
std::int64_t usual_checks(SamplingPlanner planner) {
  switch (planner) {
    case SamplingPlanner::rrt_star:
    case SamplingPlanner::informed_rrt_star: return 10000;
    case SamplingPlanner::bit_star: return 3000;
    case SamplingPlanner::ait_star: return 1500;
    default: return OmplOptions{}.checks;
  }
}

std::vector<ParameterDescription> parameters_of(SamplingPlanner planner) {
  const OmplOptions defaults;
  std::vector<ParameterDescription> all = space_parameters("reeds_shepp for a tricycle, plane for a disc or a free goal, else turns");
  for (ParameterDescription& own : own_parameters(planner)) all.push_back(std::move(own));
  const std::vector<ParameterDescription> more{
      resolution_parameter(),
      {.name = "checks",
       .default_value = static_cast<double>(usual_checks(planner)),
       .summary = "footprint placements that may be tested; budget.samples takes its place",
       .low = 1,
       .high = 1e9,
       .whole = true},
      {.name = "goal_straight",
       .default_value = defaults.goal_straight,
       .summary = "length of the straight run forwards into the goal; 0: as it comes",
       .unit = "m",
       .low = 0.0,
       .high = 20.0},
      {.name = "simplify", .default_value = defaults.simplify, .summary = "shorten the path found"},
      {.name = "shortcuts",
       .default_value = static_cast<double>(defaults.shortcuts),
       .summary = "shortcuts tried on the path found",
       .low = 0,
       .high = 1e6,
       .whole = true},
  };
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::string text_of(const ParameterValue& value, bool is_whole) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "1" : "0";
  const double number = std::get<double>(value);
  return is_whole ? fmt::format("{}", static_cast<std::int64_t>(number)) : fmt::format("{}", number);
}

OmplOptions options_of(SamplingPlanner planner, const Parameters& p) {
  OmplOptions options;
  const SpaceOptions space = space_options(p);
  options.space = space.space;
  options.radius_factor = space.radius_factor;
  options.radius_without_limit = space.radius_without_limit;
  options.turn_cost = space.turn_cost;
  options.resolution = space.resolution;
  options.checks = whole_number_of(p, "checks");
  options.goal_straight = number_of(p, "goal_straight");
  options.simplify = flag_of(p, "simplify");
  options.shortcuts = static_cast<int>(number_of(p, "shortcuts"));
  for (const ParameterDescription& own : own_parameters(planner)) options.library[own.name] = text_of(p.at(own.name), own.whole);
  return options;
}

const char* summary_of(SamplingPlanner planner) {
  switch (planner) {
    case SamplingPlanner::rrt_connect: return "RRTConnect by OMPL: two trees that grow towards each other; the first way found, shortened";
    case SamplingPlanner::rrt_star: return "RRT* by OMPL: a tree that is rewired while it grows; uses all of its work to shorten the way";
    case SamplingPlanner::informed_rrt_star: return "Informed RRT* by OMPL: the same, drawing only what can shorten the way once there is one";
    case SamplingPlanner::bit_star: return "BIT* by OMPL: batches of states, searched in the order of what they promise";
    case SamplingPlanner::ait_star: return "AIT* by OMPL: the same with a search from the goal that learns where ways are blocked";
    case SamplingPlanner::prm_star: return "PRM* by OMPL: a roadmap of motions driven both ways, grown by counted work instead of time";
    case SamplingPlanner::kpiece: break;
  }
  return "KPIECE by OMPL: a tree that grows from the border of the cells that it has explored; the first way found, shortened";
}

}  // namespace

std::vector<PlannerDescription> ompl_planner_descriptions() {
  std::vector<PlannerDescription> all;
  for (const SamplingPlanner planner : {SamplingPlanner::rrt_connect, SamplingPlanner::rrt_star, SamplingPlanner::informed_rrt_star, SamplingPlanner::bit_star, SamplingPlanner::ait_star,
                                        SamplingPlanner::prm_star, SamplingPlanner::kpiece}) {
    PlannerDescription d;
    d.name = OmplPlanner{planner, {}, 0}.name();
    d.summary = summary_of(planner);
    d.parameters = parameters_of(planner);
    d.make = [planner](const Parameters& p, std::uint64_t seed) -> AnyPlanner { return OmplPlanner{planner, options_of(planner, p), seed}; };
    d.counts_samples = [](const Parameters&) { return true; };
    d.takes_free_goals = true;
    all.push_back(std::move(d));
  }
  return all;
}

}  // namespace waywright
