#include "waywright/planner/waypoint/describe.hpp"

#include "waywright/scenario/parameter_values.hpp"

namespace waywright {
namespace {

WaypointObjective waypoint_objective(const std::string& name) {
  for (const WaypointObjective o : waypoint_objectives) {
    if (name == to_string(o)) return o;
  }
  return WaypointObjective::metres;
}

}  // namespace

WaypointOptions waypoint_options(const Parameters& p) {
  WaypointOptions options;
  options.objective = waypoint_objective(word_of(p, "objective"));
  options.form = word_of(p, "form") == "published" ? FitnessForm::published : FitnessForm::corrected;
  options.continuity = word_of(p, "chain") == "g1" ? Continuity::g1 : Continuity::g2;
  options.evaluations = whole_number_of(p, "evaluations");
  options.population = static_cast<int>(number_of(p, "population"));
  options.heading_range = number_of(p, "heading_range");
  options.bend_range = number_of(p, "bend_range");
  options.samples = static_cast<int>(number_of(p, "samples"));
  options.margin = number_of(p, "margin");
  options.wanted_clearance = number_of(p, "wanted_clearance");
  options.clearance_weight = number_of(p, "clearance_weight");
  options.bend_weight = number_of(p, "bend_weight");
  options.step = number_of(p, "step");
  return options;
}

PlannerDescription waypoint_clothoid_description(std::vector<std::string> optimizers, std::function<std::shared_ptr<const Optimizer>(const std::string&)> make) {
  std::vector<std::string> objectives;
  for (const WaypointObjective o : waypoint_objectives) objectives.push_back(to_string(o));
  PlannerDescription description{
      "waypoint_clothoid",
      "through waypoints on clothoids, courses chosen for one of eight objectives; curvature-continuous and within the vehicle's limits by default",
      {
          {.name = "objective", .default_value = std::string{"metres"}, .summary = "what is least: ours in metres, or a function of the waypoint publication", .choices = objectives},
          {.name = "form", .default_value = std::string{"corrected"}, .summary = "of the publication's functions: corners only and as printed, or whole footprint and corrected",
           .choices = {"corrected", "published"}},
          {.name = "chain", .default_value = std::string{"g2"}, .summary = "g2: three clothoids a leg, curvature goes on; g1: one, as published", .choices = {"g2", "g1"}},
          {.name = "optimizer", .default_value = std::string{"de"}, .summary = "searches the courses; de takes over from lattice_search beyond six variables",
           .choices = std::move(optimizers)},
          {.name = "evaluations", .default_value = 4000.0, .summary = "candidate paths", .low = 1, .high = 1e8, .whole = true},
          {.name = "population", .default_value = 50.0, .summary = "of optimisers that have one", .low = 2, .high = 1e4, .whole = true},
          {.name = "heading_range", .default_value = 1.6, .summary = "to each side of the mean course at a waypoint; π: all courses", .unit = "rad", .low = 0.01, .high = pi},
          {.name = "bend_range", .default_value = 1.0, .summary = "of g2: how far the curvature at a waypoint may be from that of single clothoids", .unit = "1/m", .low = 0, .high = 100},
          {.name = "samples", .default_value = 100.0, .summary = "poses that the publication's functions look at", .low = 2, .high = 1e5, .whole = true},
          {.name = "margin", .default_value = 0.01, .summary = "least distance of pwavg_margin beyond the clearance asked for", .unit = "m", .low = 1e-6, .high = 100},
          {.name = "wanted_clearance", .default_value = 0.5, .summary = "beyond the clearance asked for, from where obstacles no longer count in metres", .unit = "m", .low = 1e-3,
           .high = 100},
          {.name = "clearance_weight", .default_value = 1.0, .summary = "of nearness in metres", .low = 0, .high = 1e3},
          {.name = "bend_weight", .default_value = 0.5, .summary = "of ∫κ² ds in metres", .unit = "m²", .low = 0, .high = 1e3},
          {.name = "step", .default_value = 0.1, .summary = "distance of the poses that metres looks at", .unit = "m", .low = 0.001, .high = 10},
      },
      [make = std::move(make)](const Parameters& p, std::uint64_t seed) -> AnyPlanner {
        return WaypointClothoidPlanner{waypoint_options(p), make(word_of(p, "optimizer")), make("de"), seed};
      }};
  description.passes_waypoints = true;
  return description;
}

}  // namespace waywright
