#include "waywright/planner/field/field_planner.hpp"
#include "waywright/scenario/parameter_values.hpp"

namespace waywright {
namespace {

PlannerDescription described(const char* name, const char* summary, std::vector<ParameterDescription> parameters, std::function<FieldPlannerOptions(const Parameters&)> options) {
  parameters.push_back({.name = "steps", .default_value = 200'000.0, .summary = "down the field, at most", .low = 1, .high = 1e8, .whole = true});
  PlannerDescription d{name, summary, std::move(parameters), [name = std::string{name}, options = std::move(options)](const Parameters& p, std::uint64_t) -> AnyPlanner {
                         FieldPlannerOptions o = options(p);
                         o.steps = whole_number_of(p, "steps");
                         return FieldPlanner{name, o};
                       }};
  d.takes_free_goals = true;
  d.turns_on_the_spot = true;
  return d;
}

PlannerDescription potential_description() {
  const PotentialOptions field;
  const DescentOptions descent;
  return described("potential_field", "down the artificial potential of a goal that attracts and obstacles that repel, as published; tells where it is trapped",
                   {{.name = "attraction", .default_value = field.attraction, .summary = "k_a", .low = 1e-6, .high = 1e6},
                    {.name = "conic_from", .default_value = field.conic_from, .summary = "d: farther from the goal than this the attraction does not grow", .unit = "m", .low = 1e-3, .high = 1e4},
                    {.name = "repulsion", .default_value = field.repulsion, .summary = "k_r", .low = 0, .high = 1e6},
                    {.name = "reach", .default_value = field.reach, .summary = "rho_0: obstacles farther off do not repel", .unit = "m", .low = 1e-3, .high = 1e3},
                    {.name = "walls", .default_value = field.repels_walls, .summary = "the boundary repels, too"},
                    {.name = "reaches_goal", .default_value = field.reaches_goal, .summary = "weigh repulsion by the squared distance to the goal, so that one beside an obstacle can be reached"},
                    {.name = "speed", .default_value = descent.speed, .summary = "greatest speed down the field", .unit = "m/s", .low = 1e-3, .high = 100},
                    {.name = "period", .default_value = descent.period, .summary = "between looks at the field", .unit = "s", .low = 1e-5, .high = 1}},
                   [](const Parameters& p) {
                     FieldPlannerOptions o;
                     o.method = FieldMethod::potential;
                     o.potential = {number_of(p, "attraction"), number_of(p, "conic_from"), number_of(p, "repulsion"), number_of(p, "reach"), flag_of(p, "walls"), flag_of(p, "reaches_goal")};
                     o.descent.speed = number_of(p, "speed");
                     o.descent.period = number_of(p, "period");
                     return o;
                   });
}

PlannerDescription navigation_description() {
  const FieldPlannerOptions defaults;
  return described("navigation_function", "down the navigation function of a world whose obstacles fit into discs apart from each other, as published",
                   {{.name = "kappa", .default_value = 0.0, .summary = "0: of the whole numbers to 20 (greater ones where none of them does) that are shown to leave no minimum but the goal, one whose way is short and keeps away", .low = 0, .high = 1e4},
                    {.name = "step", .default_value = defaults.step, .summary = "length of a step, in radii of the outer disc", .low = 1e-6, .high = 0.1}},
                   [](const Parameters& p) {
                     FieldPlannerOptions o;
                     o.method = FieldMethod::navigation;
                     o.kappa = number_of(p, "kappa");
                     o.step = number_of(p, "step");
                     return o;
                   });
}

PlannerDescription star_description() {
  const FieldPlannerOptions defaults;
  return described("star_navigation", "down the navigation function of a world of star-shaped obstacles, seen through a smooth map to discs, as published; polygons that are not convex as trees of stars",
                   {{.name = "kappa", .default_value = 0.0, .summary = "0: of the whole numbers to 20 that are shown to leave no minimum but the goal in the model, one whose way is short and keeps away", .low = 0, .high = 1e4},
                    {.name = "lambda", .default_value = 0.0, .summary = "of the published map, which is taken first where this is told: the greater, the nearer to its rim each star bends it; 0: among convex polygons the least power of ten that is shown not to fold, among others trees of stars, which need none", .low = 0, .high = 1e15},
                    {.name = "step", .default_value = defaults.step, .summary = "length of a step, in greatest radii of the boundary", .low = 1e-6, .high = 0.1}},
                   [](const Parameters& p) {
                     FieldPlannerOptions o;
                     o.method = FieldMethod::star;
                     o.kappa = number_of(p, "kappa");
                     o.lambda = number_of(p, "lambda");
                     o.step = number_of(p, "step");
                     return o;
                   });
}

}  // namespace

std::vector<PlannerDescription> field_planner_descriptions() { return {potential_description(), navigation_description(), star_description()}; }

}  // namespace waywright
