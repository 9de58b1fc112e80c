// Which motions a planner among states has a vehicle make: the parameter `space`, what goes with it, and what it does not go together with.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/planner/planner.hpp"
#include "waywright/planner/steering/steering.hpp"

namespace waywright {

struct SpaceOptions {
  /// None: chosen by the vehicle and the task (chosen_space).
  std::optional<SteeringKind> space;
  /// Turning radius over 1/(greatest curvature): a little more than 1, so that rounding never breaks the limit.
  double radius_factor = 1.001;
  /// m, turning radius of a vehicle without a curvature limit: small, but no turning on the spot.
  double radius_without_limit = 0.3;
  /// m that a radian of turning on the spot counts as, in the space of turns.
  double turn_cost = 0.05;
  /// m: motions are tested down to this length; passages wider than what is required by less than about this are missed.
  double resolution = 0.001;
};

/// `space`, `radius_factor`, `radius_without_limit`, `turn_cost`. @param choice what auto takes, in words
std::vector<ParameterDescription> space_parameters(std::string_view choice);
ParameterDescription resolution_parameter();
/// @pre the parameters above are among them
SpaceOptions space_options(const Parameters& parameters);

/// The one asked for, else curves for a vehicle that cannot turn on the spot, the plane for a disc, a goal that leaves the heading free, or where the disc around the
/// footprint serves, else turns on the spot.
SteeringKind chosen_space(const Problem& problem, const SpaceOptions& options, bool disc_serves);

/// Why vehicle and task do not go together with the space; empty: they do. @param label "RRT*": of the method
std::string space_refusal(const Problem& problem, SteeringKind space, std::string_view name, std::string_view label);

/// m, of the space's curves.
double turning_radius(const Problem& problem, const SpaceOptions& options);
std::unique_ptr<const Steering> make_steering(const Problem& problem, SteeringKind space, const SpaceOptions& options);

}  // namespace waywright
