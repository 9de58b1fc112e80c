// Planner `voronoi`: ways that keep as far from everything as can be, along the Voronoi diagram of what is blocked.
#pragma once

#include <memory>
#include <string_view>

#include "waywright/planner/planner.hpp"

namespace waywright {

struct VoronoiPlannerOptions {
  double clearance_weight = 0.0;  ///< m: a metre with a clearance of c metres costs 1 + weight/c
  bool shortens = false;          ///< pulled taut, which gives the clearance away
};

/// For vehicles that can turn on the spot, and the disc around their footprint.
class VoronoiPlanner {
 public:
  explicit VoronoiPlanner(VoronoiPlannerOptions options) : options_{options} {}

  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return "voronoi"; }
  /// The diagram.
  VoronoiPlanner prepared(const Problem& problem) const;

 private:
  class Ready;
  VoronoiPlannerOptions options_;
  std::shared_ptr<const Ready> ready_;
};

PlannerDescription voronoi_description();

}  // namespace waywright
