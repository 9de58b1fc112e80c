#include "waywright/planner/steering/spaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "waywright/scenario/parameter_values.hpp"

namespace waywright {
namespace {

constexpr double least_curvature = 1e-3;  // 1/m: on larger circles the words' rounding is no longer small against tolerances

bool is_of_lines(SteeringKind space) { return space == SteeringKind::plane || space == SteeringKind::turns; }

}  // namespace

std::vector<ParameterDescription> space_parameters(std::string_view choice) {
  const SpaceOptions defaults;
  return {
      {.name = "space",
       .default_value = std::string{"auto"},
       .summary = fmt::format("plane: lines of the disc; turns: drives between turns on the spot; dubins, reeds_shepp: curves; auto: {}", choice),
       .choices = {"auto", "plane", "turns", "dubins", "reeds_shepp"}},
      {.name = "radius_factor", .default_value = defaults.radius_factor, .summary = "turning radius over the least one that the vehicle can drive", .low = 1.0, .high = 100.0},
      {.name = "radius_without_limit", .default_value = defaults.radius_without_limit, .summary = "turning radius of a vehicle without a curvature limit", .unit = "m", .low = 0.01, .high = 100.0},
      {.name = "turn_cost", .default_value = defaults.turn_cost, .summary = "metres that a radian of turning on the spot counts as, in the space of turns", .unit = "m", .low = 0.001, .high = 100.0},
  };
}

ParameterDescription resolution_parameter() {
  return {.name = "resolution",
          .default_value = SpaceOptions{}.resolution,
          .summary = "motions are tested down to this length; passages that are wider by less are missed",
          .unit = "m",
          .low = 1e-4,
          .high = 0.1};
}

SpaceOptions space_options(const Parameters& parameters) {
  SpaceOptions options;
  for (const SteeringKind kind : steering_kinds) {
    if (word_of(parameters, "space") == to_string(kind)) options.space = kind;
  }
  options.radius_factor = number_of(parameters, "radius_factor");
  options.radius_without_limit = number_of(parameters, "radius_without_limit");
  options.turn_cost = number_of(parameters, "turn_cost");
  options.resolution = number_of(parameters, "resolution");
  return options;
}

SteeringKind chosen_space(const Problem& problem, const SpaceOptions& options, bool disc_serves) {
  if (options.space) return *options.space;
  if (!problem.vehicle().can_turn_on_the_spot()) return SteeringKind::reeds_shepp;
  return problem.footprint().is_disc() || problem.free_goal() != nullptr || disc_serves ? SteeringKind::plane : SteeringKind::turns;
}

std::string space_refusal(const Problem& problem, SteeringKind space, std::string_view name, std::string_view label) {
  if (is_of_lines(space) && !problem.vehicle().can_turn_on_the_spot()) {
    return fmt::format("{} in the space \"{}\" plans straight lines with turns on the spot, which a tricycle cannot drive: give space reeds_shepp or dubins", name, to_string(space));
  }
  if (problem.free_goal() != nullptr && space != SteeringKind::plane) {
    return fmt::format("{} in the space \"{}\" plans to a goal pose, and this goal leaves the heading free: give space plane to a vehicle that can turn on the spot", name, to_string(space));
  }
  if (space == SteeringKind::dubins && problem.is_driven_back()) {
    return fmt::format("{} would drive back out of the station what Dubins curves drive forwards: give space reeds_shepp", name);
  }
  const double curvature = problem.vehicle().max_curvature();
  if (!is_of_lines(space) && curvature < least_curvature) {
    return fmt::format("{} could not search: the vehicle's curvature limit of {:g} 1/m is under the {:g} 1/m that {} need", label, curvature, least_curvature,
                       space == SteeringKind::dubins ? "Dubins curves" : "Reeds-Shepp curves");
  }
  return {};
}

double turning_radius(const Problem& problem, const SpaceOptions& options) {
  const double curvature = problem.vehicle().max_curvature();
  return std::isfinite(curvature) ? options.radius_factor / std::max(curvature, least_curvature) : options.radius_without_limit;
}

std::unique_ptr<const Steering> make_steering(const Problem& problem, SteeringKind space, const SpaceOptions& options) {
  return make_steering(space, {turning_radius(problem, options), options.turn_cost, problem.footprint().radius()});
}

}  // namespace waywright
