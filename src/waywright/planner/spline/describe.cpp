#include "waywright/planner/spline/describe.hpp"

#include "waywright/scenario/parameter_values.hpp"

namespace waywright {
namespace {

PlannerDescription description_of(std::string name, std::string summary, SplineForm curve, const std::string& own, std::int64_t evaluations, const std::vector<std::string>& optimizers,
                                  const std::function<std::shared_ptr<const Optimizer>(const std::string&)>& make) {
  return {name, std::move(summary),
          {
              {.name = "form", .default_value = std::string{"metres"}, .summary = "what is least: length, nearness and bends in metres, or the publication's fitness (27)",
               .choices = {"metres", "published"}},
              {.name = "control_points", .default_value = 6.0, .summary = "between start and goal; the publication tried 3 to 6", .low = 2, .high = 50, .whole = true},
              {.name = "space", .default_value = std::string{"auto"},
               .summary = "of control points. guide: about a shortest way around obstacles; line: about the straight line; map: anywhere, ordered along that line, as published; auto: guide, of form=published map",
               .choices = {"auto", "guide", "line", "map"}},
              {.name = "optimizer", .default_value = own, .summary = own + " takes over from lattice_search beyond six variables", .choices = optimizers},
              {.name = "evaluations", .default_value = static_cast<double>(evaluations), .summary = "curves looked at; of form=published with weights=normalised a fifth for each of five searches",
               .low = 1, .high = 1e8, .whole = true},
              {.name = "population", .default_value = 30.0, .summary = "of optimisers that have one", .low = 2, .high = 1e4, .whole = true},
              {.name = "weights", .default_value = std::string{"normalised"}, .summary = "of (27): by single-objective searches, or the printed numbers", .choices = {"normalised", "published"}},
              {.name = "samples", .default_value = 200.0, .summary = "poses that (27) looks at", .low = 2, .high = 1e5, .whole = true},
              {.name = "wanted_clearance", .default_value = 0.5, .summary = "beyond the clearance asked for, from where obstacles no longer count in metres", .unit = "m", .low = 1e-3, .high = 100},
              {.name = "clearance_weight", .default_value = 1.0, .summary = "of nearness in metres", .low = 0, .high = 1e3},
              {.name = "bend_weight", .default_value = 0.5, .summary = "of ∫κ² ds in metres", .unit = "m²", .low = 0, .high = 1e3},
              {.name = "turn_cost", .default_value = 0.05, .summary = "metres that a radian of turning on the spot counts as", .unit = "m", .low = 0, .high = 100},
              {.name = "step", .default_value = 0.1, .summary = "distance of the poses that metres looks at", .unit = "m", .low = 0.001, .high = 10},
          },
          [name, curve, own, make](const Parameters& p, std::uint64_t seed) -> AnyPlanner {
            return SplinePlanner{name, spline_options(curve, p), make(word_of(p, "optimizer")), make(own), seed};
          }};
}

}  // namespace

SplineOptions spline_options(SplineForm curve, const Parameters& p) {
  SplineOptions options;
  options.curve = curve;
  options.objective = word_of(p, "form") == "published" ? SplineObjective::published : SplineObjective::metres;
  const std::string space = word_of(p, "space");
  if (space == "line") options.space = ControlSpace::line;
  if (space == "map" || (space == "auto" && options.objective == SplineObjective::published)) options.space = ControlSpace::map;
  options.normalises = word_of(p, "weights") == "normalised";
  options.control_points = static_cast<int>(number_of(p, "control_points"));
  options.evaluations = whole_number_of(p, "evaluations");
  options.population = static_cast<int>(number_of(p, "population"));
  options.samples = static_cast<int>(number_of(p, "samples"));
  options.wanted_clearance = number_of(p, "wanted_clearance");
  options.clearance_weight = number_of(p, "clearance_weight");
  options.bend_weight = number_of(p, "bend_weight");
  options.turn_cost = number_of(p, "turn_cost");
  options.step = number_of(p, "step");
  return options;
}

std::vector<PlannerDescription> spline_planner_descriptions(const std::vector<std::string>& optimizers, const std::function<std::shared_ptr<const Optimizer>(const std::string&)>& make) {
  // 30 particles or individuals and 100 iterations, as published; a particle's move takes three evaluations.
  return {
      description_of("capso_spline", "one cubic spline through control points, found by a chaotic particle swarm for length, nearness and bends; or by the safe-A* publication's fitness", SplineForm::cubic,
                     "capso", 9030, optimizers, make),
      description_of("ga_bspline", "one B-spline along control points, found by a genetic algorithm for length, nearness and bends; or by the safe-A* publication's fitness", SplineForm::bspline, "ga_spline",
                     3000, optimizers, make),
  };
}

}  // namespace waywright
