// Planner `pattern_docking`: the docking pattern in our form, its transition point and heading searched on both sides.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "waywright/optimizer/optimizer.hpp"
#include "waywright/planner/docking/pattern_options.hpp"
#include "waywright/planner/docking/prepared.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright {

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
