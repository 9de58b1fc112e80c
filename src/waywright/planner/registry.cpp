#include "waywright/planner/registry.hpp"

#include <algorithm>

#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/optimizer/pagmo/pagmo_optimizers.hpp"
#include "waywright/planner/docking/pattern_docking.hpp"
#include "waywright/planner/docking/published_docking.hpp"
#include "waywright/planner/field/field_planner.hpp"
#include "waywright/planner/field/global_local.hpp"
#include "waywright/planner/field/harmonic_planner.hpp"
#include "waywright/planner/field/wavefront_planner.hpp"
#include "waywright/planner/grid/grid_planner.hpp"
#include "waywright/planner/grid/safe_planner.hpp"
#include "waywright/planner/ompl/ompl_planner.hpp"
#include "waywright/planner/roadmap/prm_planner.hpp"
#include "waywright/planner/roadmap/visibility_planner.hpp"
#include "waywright/planner/roadmap/voronoi_planner.hpp"
#include "waywright/planner/spline/describe.hpp"
#include "waywright/planner/state_lattice/clearance_optimal.hpp"
#include "waywright/planner/tree/tree_planner.hpp"
#include "waywright/planner/waypoint/describe.hpp"
#include "waywright/scenario/parameter_values.hpp"

namespace waywright {
namespace {

SideChoice side_choice(const std::string& name) {
  return name == "left" ? SideChoice::left : name == "right" ? SideChoice::right : SideChoice::both;
}

DockingObjective objective_of(const std::string& name) {
  return name == "exponential" ? DockingObjective::exponential : DockingObjective::normalised;
}

std::shared_ptr<const Optimizer> optimizer_of(const std::string& name) {
  return std::shared_ptr<const Optimizer>{find_optimizer(name)->make()};
}

std::vector<std::string> optimizer_names() {
  std::vector<std::string> names;
  for (const OptimizerDescription& o : optimizers()) names.push_back(o.name);
  return names;
}

/// What both docking planners have.
std::vector<ParameterDescription> docking_parameters(const std::string& optimizer, double evaluations) {
  return {
      {.name = "optimizer", .default_value = optimizer, .summary = "searches the transition point", .choices = optimizer_names()},
      {.name = "evaluations", .default_value = evaluations, .summary = "candidate paths per side of the shelf", .low = 1, .high = 1e7,
       .whole = true},
      {.name = "population", .default_value = 20.0, .summary = "of optimisers that have one", .low = 2, .high = 1e4, .whole = true},
      {.name = "objective", .default_value = std::string{"normalised"}, .summary = "cost B or cost A of the publication",
       .choices = {"normalised", "exponential"}},
      {.name = "curvature_weight", .default_value = 0.7, .summary = "weight of the change of curvature", .low = 0, .high = 1e3},
      {.name = "length_weight", .default_value = 0.3, .summary = "weight of the length", .low = 0, .high = 1e3},
      {.name = "sides", .default_value = std::string{"both"}, .summary = "of the shelf to look at",
       .choices = {"both", "left", "right"}},
  };
}

PlannerDescription pattern_docking_description() {
  std::vector<ParameterDescription> parameters = docking_parameters("lattice_search", 600.0);
  const std::vector<ParameterDescription> more{
      {.name = "heading_range", .default_value = 1.0,
       .summary = "how far the heading at the transition may leave the perpendicular to the shelf's axis; 0 fixes it", .unit = "rad",
       .low = 0, .high = 1.5},
      {.name = "start_straight", .default_value = 0.0, .summary = "straight run on leaving the start", .unit = "m", .low = 0,
       .high = 20},
      {.name = "transition_straight", .default_value = 0.0, .summary = "straight runs to and from the transition point",
       .unit = "m", .low = 0, .high = 20},
      {.name = "dock_straight", .default_value = 0.3, .summary = "straight run into the docked pose", .unit = "m", .low = 0,
       .high = 20},
      {.name = "gap", .default_value = 0.0,
       .summary = "branch and bound until the answer is shown to cost at most this share more than the optimum, within a few seconds; 0: off",
       .low = 0, .high = 1},
      {.name = "fallback", .default_value = true, .summary = "ask ompl_rrt_connect where no pattern fits"},
  };
  parameters.insert(parameters.end(), more.begin(), more.end());
  return {"pattern_docking",
          "docking pattern with one change of direction, curvature-continuous, transition point and heading searched on both sides",
          parameters, [](const Parameters& p, std::uint64_t seed) -> AnyPlanner {
            PatternDockingOptions options;
            options.evaluations = whole_number_of(p, "evaluations");
            options.population = static_cast<int>(number_of(p, "population"));
            options.heading_range = number_of(p, "heading_range");
            options.leads = {number_of(p, "start_straight"), number_of(p, "transition_straight"), number_of(p, "dock_straight")};
            options.weights = {number_of(p, "curvature_weight"), number_of(p, "length_weight")};
            options.objective = objective_of(word_of(p, "objective"));
            options.sides = side_choice(word_of(p, "sides"));
            options.gap = number_of(p, "gap");
            std::optional<AnyPlanner> fallback;
            if (flag_of(p, "fallback")) fallback = OmplPlanner{SamplingPlanner::rrt_connect, OmplOptions{.space = SteeringKind::reeds_shepp, .goal_straight = options.leads.dock}, seed};
            return PatternDockingPlanner{options, optimizer_of(word_of(p, "optimizer")), seed, std::move(fallback)};
          },
          [](const Parameters& p) { return flag_of(p, "fallback"); }, true};
}

PlannerDescription published_docking_description() {
  std::vector<ParameterDescription> parameters = docking_parameters("de", 300.0);
  const std::vector<ParameterDescription> more{
      {.name = "segment", .default_value = 0.05, .summary = "distance of the samples that are tested", .unit = "m", .low = 0.001,
       .high = 1},
      {.name = "curvature_factor", .default_value = 10.0, .summary = "knock-out factor where the curvature is over its limit",
       .low = 1, .high = 1e6},
      {.name = "least_side", .default_value = 1.5, .summary = "a side less wide across is dropped", .unit = "m", .low = 0,
       .high = 100},
  };
  parameters.insert(parameters.end(), more.begin(), more.end());
  return {"pattern_docking_published",
          "the docking publication's own form: natural cubic splines, tested at samples; for comparison", parameters,
          [](const Parameters& p, std::uint64_t seed) -> AnyPlanner {
            PublishedDockingOptions options;
            options.evaluations = whole_number_of(p, "evaluations");
            options.population = static_cast<int>(number_of(p, "population"));
            options.segment = number_of(p, "segment");
            options.curvature_factor = number_of(p, "curvature_factor");
            options.least_side = number_of(p, "least_side");
            options.weights = {number_of(p, "curvature_weight"), number_of(p, "length_weight")};
            options.objective = objective_of(word_of(p, "objective"));
            options.sides = side_choice(word_of(p, "sides"));
            return PublishedDockingPlanner{options, optimizer_of(word_of(p, "optimizer")), seed};
          }};
}

template <class List>
auto find_by_name(const List& list, std::string_view name) -> decltype(list.data()) {
  const auto it = std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.name == name; });
  return it == list.end() ? nullptr : &*it;
}

}  // namespace

const std::vector<OptimizerDescription>& optimizers() {
  static const std::vector<OptimizerDescription> all = [] {
    std::vector<OptimizerDescription> list{lattice_search_description()};
    for (OptimizerDescription& o : pagmo_optimizers()) list.push_back(std::move(o));
    return list;
  }();
  return all;
}

const std::vector<PlannerDescription>& planners() {
  static const std::vector<PlannerDescription> all = [] {
    std::vector<PlannerDescription> list{pattern_docking_description(), published_docking_description()};
    for (PlannerDescription& p : ompl_planner_descriptions()) list.push_back(std::move(p));
    list.push_back(waypoint_clothoid_description(optimizer_names(), optimizer_of));
    for (PlannerDescription& p : spline_planner_descriptions(optimizer_names(), optimizer_of)) list.push_back(std::move(p));
    for (PlannerDescription& p : grid_planner_descriptions()) list.push_back(std::move(p));
    for (PlannerDescription& p : safe_planner_descriptions()) list.push_back(std::move(p));
    list.push_back(clearance_optimal_description());
    list.push_back(visibility_graph_description());
    list.push_back(prm_description());
    list.push_back(voronoi_description());
    for (PlannerDescription& p : tree_planner_descriptions()) list.push_back(std::move(p));
    for (PlannerDescription& p : field_planner_descriptions()) list.push_back(std::move(p));
    list.push_back(wavefront_description());
    list.push_back(harmonic_description());
    list.push_back(global_local_description());
    return list;
  }();
  return all;
}

const PlannerDescription* find_planner(std::string_view name) { return find_by_name(planners(), name); }
const OptimizerDescription* find_optimizer(std::string_view name) { return find_by_name(optimizers(), name); }

}  // namespace waywright
