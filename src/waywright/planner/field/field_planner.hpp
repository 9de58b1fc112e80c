// Planners `potential_field`, `navigation_function` and `star_navigation`: the way of a disc down a field.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/planner/field/descent.hpp"
#include "waywright/planner/field/potential.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright {

enum class FieldMethod { potential, navigation, star };

struct FieldPlannerOptions {
  FieldMethod method = FieldMethod::potential;
  PotentialOptions potential{};
  DescentOptions descent{};
  double kappa = 0.0;   ///< of the navigation function; 0: of those that are shown to lead to the goal the one whose way, at most a tenth longer than the shortest, keeps farthest away
  double lambda = 0.0;  ///< of the published map from stars to discs, which is taken first where this is told; 0: the least that is shown not to fold, where that map is taken
  double step = 0.002;  ///< of its steps, in radii of the outer disc
  std::int64_t steps = 200'000;  ///< at most
};

/// For vehicles that move any way or turn on the spot. Traps are found and told as traps: with the place, and as a failure.
class FieldPlanner {
 public:
  FieldPlanner(std::string name, const FieldPlannerOptions& options) : name_{std::move(name)}, options_{options} {}
  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return name_; }
  /// Bounds of distances, and what a navigation function needs of the map.
  FieldPlanner prepared(const Problem& problem) const;

 private:
  class Ready;
  std::string name_;
  FieldPlannerOptions options_;
  std::shared_ptr<const Ready> ready_;
};

std::vector<PlannerDescription> field_planner_descriptions();

}  // namespace waywright
