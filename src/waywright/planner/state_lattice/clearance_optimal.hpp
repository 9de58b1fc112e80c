// `clearance_optimal`: length plus an integral of danger, least over a lattice of motions that the vehicle can drive, then smoothed.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "waywright/planner/planner.hpp"
#include "waywright/planner/state_lattice/lattice_graph.hpp"

namespace waywright {

struct ClearanceOptimalOptions {
  LatticeOptions lattice;
  double gap = 0.0;       ///< by so much the way over the lattice may be dearer than the best one
  bool smooth = true;
};

class ClearanceOptimalPlanner {
 public:
  explicit ClearanceOptimalPlanner(const ClearanceOptimalOptions& options) : options_{options} {}

  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return "clearance_optimal"; }
  /// The lattice and what is left from each of its cells, made once.
  ClearanceOptimalPlanner prepared(const Problem& problem) const;

 private:
  class Ready;
  ClearanceOptimalOptions options_;
  std::shared_ptr<const Ready> ready_;
};

PlannerDescription clearance_optimal_description();

}  // namespace waywright
