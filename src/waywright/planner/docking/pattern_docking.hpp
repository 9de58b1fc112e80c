// Planner `pattern_docking`: the docking pattern in our form, its transition point and heading searched on both sides.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "waywright/objective/docking_cost.hpp"
#include "waywright/optimizer/optimizer.hpp"
#include "waywright/planner/docking/pattern.hpp"
#include "waywright/planner/docking/prepared.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright {

enum class SideChoice { both, left, right };
enum class DockingObjective { normalised, exponential };

struct PatternDockingOptions {
  /// Candidates per side, ≥ 1; where none of them serves, four times as many are tried before the second choice is asked. A scenario's
  /// budget.evaluations takes its place, for all sides together.
  std::int64_t evaluations = 600;
  int population = 20;              ///< of optimisers that have one
  double heading_range = 1.0;       ///< rad, the transition heading may leave the perpendicular by this; 0: two variables
  PatternLeads leads;
  DockingWeights weights;
  DockingObjective objective = DockingObjective::normalised;
  SideChoice sides = SideChoice::both;
  double gap = 0.0;                 ///< > 0: branch and bound until the answer is shown to cost at most this share more than the optimum
};

/// What the search on one side of the shelf came to.
struct SideOutcome {
  Side side = Side::left;
  bool searched = false;   ///< at least one candidate was looked at
  bool feasible = false;
  double cost = 0.0;       ///< objective of the best path; graded where not feasible
  Pose transition{};       ///< world
  Path path;               ///< best path found, also where it is not feasible
  std::string sentence;    ///< what happened, for the explanation
  std::optional<Contact> contact;  ///< what the best infeasible one meets first …
  double reach = 0.0;              ///< … after so many metres
};

class PatternDockingPlanner {
 public:
  /// `fallback` is asked where no pattern fits; its path is named as the second choice.
  PatternDockingPlanner(PatternDockingOptions options, std::shared_ptr<const Optimizer> optimizer, std::uint64_t seed,
                        std::optional<AnyPlanner> fallback = std::nullopt);

  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return "pattern_docking"; }
  /// With sides, clearance field and covers of the footprint made. @pre the problem outlives what is returned
  PatternDockingPlanner prepared(const Problem& problem) const;

 private:
  PlanningResult plan(const PreparedDocking& prepared, Budget& budget) const;

  std::shared_ptr<const PreparedDocking> prepared_;  ///< for one problem; made anew for others
  PatternDockingOptions options_;
  std::shared_ptr<const Optimizer> optimizer_;
  std::uint64_t seed_;
  std::optional<AnyPlanner> fallback_;
};

}  // namespace waywright
