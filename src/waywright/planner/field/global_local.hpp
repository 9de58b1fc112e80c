// Planner `global_local`: a global way, planned as if nothing moved, followed under a local field among what moves.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "waywright/planner/field/local_drive.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright {

enum class GlobalWay { harmonic, wavefront, navigation, star_navigation, visibility };

struct GlobalLocalOptions {
  GlobalWay global = GlobalWay::harmonic;
  double resolution = 0.0;  ///< m, of ways over cells; 0: as their planners choose it
  LocalFieldOptions field{};
  LocalDriveOptions drive{};
};

/// For the disc around the footprint, of vehicles that move any way or turn on the spot. What comes out is a path with the times at which it is driven, proven in time here
/// already; where the local field comes to no end, the global way, for the judge to find times for.
class GlobalLocalPlanner {
 public:
  explicit GlobalLocalPlanner(const GlobalLocalOptions& options) : options_{options} {}
  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return "global_local"; }
  /// The table of distances, and what the global way's planner prepares.
  GlobalLocalPlanner prepared(const Problem& problem) const;

 private:
  class Ready;
  GlobalLocalOptions options_;
  std::shared_ptr<const Ready> ready_;
};

PlannerDescription global_local_description();

}  // namespace waywright
