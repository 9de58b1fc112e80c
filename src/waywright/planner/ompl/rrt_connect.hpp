// Planner `ompl_rrt_connect`: RRTConnect in the Reeds–Shepp space by OMPL, simplified, as exact lines and arcs. The second choice
// where no docking pattern fits.
#pragma once

#include <cstdint>
#include <string_view>

#include "waywright/planner/planner.hpp"

namespace waywright {

struct RrtConnectOptions {
  double radius_factor = 1.001;           ///< turning radius over 1/(greatest curvature)
  double radius_without_limit = 0.3;      ///< m, for vehicles without a curvature limit
  std::int64_t checks = 60000;            ///< footprint placements that may be tested; a scenario's budget.samples replaces it
  int shortcuts = 300;                    ///< tried on the path found
};

class RrtConnectPlanner {
 public:
  RrtConnectPlanner(RrtConnectOptions options, std::uint64_t seed) : options_{options}, seed_{seed} {}
  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return "ompl_rrt_connect"; }

 private:
  RrtConnectOptions options_;
  std::uint64_t seed_;
};

PlannerDescription rrt_connect_description();

}  // namespace waywright
