// Planners `ompl_rrt_connect`, `ompl_rrt_star`, `ompl_informed_rrt_star`, `ompl_bit_star`, `ompl_ait_star`, `ompl_prm_star` and `ompl_kpiece`: those of
// OMPL that people compare against, in the plane, with turns on the spot, with Dubins or Reeds–Shepp curves; shortened, as exact lines, arcs and turns.
// RRTConnect with Reeds–Shepp curves is the second choice where no docking pattern fits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "waywright/planner/ompl/sampling_search.hpp"
#include "waywright/planner/planner.hpp"
#include "waywright/planner/steering/spaces.hpp"

namespace waywright {

/// Each with its reason; ranges stand in ompl_planner_descriptions().
struct OmplOptions {
  /// None: curves for a tricycle, the plane for a disc or a free goal, else turns on the spot.
  std::optional<SteeringKind> space;
  /// Turning radius over 1/(greatest curvature): a little more than 1, so that rounding never breaks the
  /// limit.
  double radius_factor = SpaceOptions{}.radius_factor;
  /// m, turning radius of a vehicle without a curvature limit: small, but no turning on the spot.
  double radius_without_limit = SpaceOptions{}.radius_without_limit;
  /// m that a radian of turning on the spot counts as, in the space of turns.
  double turn_cost = SpaceOptions{}.turn_cost;
  /// m: motions are tested down to this length; passages wider than what is required by less than about this
  /// are missed.
  double resolution = SpaceOptions{}.resolution;
  /// Footprint placements that may be tested; a scenario's budget.samples takes its place.
  std::int64_t checks = 60000;
  /// m: the last stretch into the goal is this long, straight and forwards; 0: as it comes.
  double goal_straight = 0.0;
  /// Whether the path found is shortened.
  bool simplify = true;
  /// Shortcuts tried on the path found.
  int shortcuts = 300;
  /// OMPL's own, by its names; what is left out is as OMPL has it.
  LibraryParameters library{};

  SpaceOptions of_space() const { return {space, radius_factor, radius_without_limit, turn_cost, resolution}; }
};

/// Any goal pose, the docked pose of a station included; in the plane goals that leave the heading free too. No optimum is promised: the
/// answer depends on the seed.
///
/// The work is counted in footprint placements (option `checks` or budget.samples) and, where
/// budget.evaluations is given, in candidate motions, each from one state to another. The same problem, seed
/// and options give the same bits on any number of threads; searches run beside each other.
/// (OMPL seeds all generators of a process from one state, which a search sets: programs that use OMPL beside
/// this find it seeded anew.)
class OmplPlanner {
 public:
  OmplPlanner(SamplingPlanner planner, OmplOptions options, std::uint64_t seed) : planner_{planner}, options_{std::move(options)}, seed_{seed} {}
  /// @pre start and goal keep the required clearance (Problem::check_ends); where not, no_path says so
  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const;

 private:
  SamplingPlanner planner_;
  OmplOptions options_;
  std::uint64_t seed_;
};

std::vector<PlannerDescription> ompl_planner_descriptions();

}  // namespace waywright
