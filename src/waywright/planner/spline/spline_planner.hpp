// `capso_spline` and `ga_bspline`: one curve from start to goal, its control points found by an optimizer (the safe-A* publication's rivals). Ours by default:
// length, nearness and bends in metres, within the vehicle's limits, proven; the publication's fitness (27) on request.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "waywright/optimizer/optimizer.hpp"
#include "waywright/planner/planner.hpp"
#include "waywright/planner/spline/spline_curve.hpp"
#include "waywright/planner/spline/spline_fitness.hpp"

namespace waywright {

enum class SplineObjective {
  metres,     ///< ours
  published,  ///< (27)
};

/// Where control points are looked for.
enum class ControlSpace {
  guide,  ///< each about its own place on a shortest way around obstacles, mostly near it; on the straight line where there is no such way
  line,   ///< each about its own place on the straight line, as far to its sides as the map goes, mostly near it
  map,    ///< anywhere in the map's box, in the order of their projections on the straight line (published)
};

struct SplineOptions {
  SplineForm curve = SplineForm::cubic;
  SplineObjective objective = SplineObjective::metres;
  ControlSpace space = ControlSpace::guide;
  bool normalises = true;          ///< weights of (27) by single-objective searches; else the publication's
  int control_points = 6;          ///< ≥ 2
  std::int64_t evaluations = 9030;
  int population = 30;
  int samples = 200;               ///< that (27) looks at, ≥ 2
  double wanted_clearance = 0.5;   ///< m beyond the clearance asked for, from where `metres` feels no obstacle, > 0
  double clearance_weight = 1.0;   ///< of its barrier, ≥ 0
  double bend_weight = 0.5;        ///< m², of ∫κ² ds, ≥ 0
  double turn_cost = 0.05;         ///< m that a radian of turning on the spot counts as, ≥ 0
  double step = 0.1;               ///< m, distance of the poses that `metres` looks at, > 0
};

class SplinePlanner {
 public:
  /// `for_many` takes over where the optimizer is lattice_search and there are more variables than it can.
  SplinePlanner(std::string name, SplineOptions options, std::shared_ptr<const Optimizer> optimizer, std::shared_ptr<const Optimizer> for_many, std::uint64_t seed)
      : name_{std::move(name)}, options_{options}, optimizer_{std::move(optimizer)}, for_many_{std::move(for_many)}, seed_{seed} {}
  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return name_; }

 private:
  std::string name_;
  SplineOptions options_;
  std::shared_ptr<const Optimizer> optimizer_, for_many_;
  std::uint64_t seed_;
};

}  // namespace waywright
