// Planner `ompl_rrt_connect`: RRTConnect in the Reeds–Shepp space by OMPL, shortened, as exact lines and
// arcs. The second choice where no docking pattern fits.
//
// Sources: J. J. Kuffner, S. M. LaValle: RRT-Connect, ICRA 2000; I. A. Șucan, M. Moll, L. E. Kavraki: The
// Open Motion Planning Library, IEEE Robotics & Automation Magazine 19 (2012).
#pragma once

#include <cstdint>
#include <string_view>

#include "waywright/planner/planner.hpp"

namespace waywright {

/// Each with its reason; ranges stand in rrt_connect_description().
struct RrtConnectOptions {
  /// Turning radius over 1/(greatest curvature): a little more than 1, so that rounding never breaks the
  /// limit.
  double radius_factor = 1.001;
  /// m, turning radius of a vehicle without a curvature limit: small, but no turning on the spot.
  double radius_without_limit = 0.3;
  /// m, longest motion that a tree grows by at once; 0: a fifth of the extent of the region searched (OMPL's
  /// rule).
  double range = 0.0;
  /// m: motions are tested down to this length; passages wider than what is required by less than about this
  /// are missed.
  double resolution = 0.001;
  /// Footprint placements that may be tested; a scenario's budget.samples takes its place.
  std::int64_t checks = 60000;
  /// m: the last stretch into the goal is this long, straight and forwards; 0: as it comes.
  double goal_straight = 0.0;
  /// Whether the path found is shortened.
  bool simplify = true;
  /// Shortcuts tried on the path found.
  int shortcuts = 300;
};

/// Any goal pose, the docked pose of a station included, for vehicles that drive both ways. No optimum is
/// promised: the answer depends on the seed.
///
/// The work is counted in footprint placements (option `checks` or budget.samples) and, where
/// budget.evaluations is given, in candidate motions, each a curve between two poses. The same problem, seed
/// and options give the same bits on any number of threads and any processor; searches run beside each other.
/// (OMPL seeds all generators of a process from one state, which a search sets: programs that use OMPL beside
/// this find it seeded anew.)
class RrtConnectPlanner {
 public:
  RrtConnectPlanner(RrtConnectOptions options, std::uint64_t seed) : options_{options}, seed_{seed} {}
  /// @pre start and goal keep the required clearance (Problem::check_ends); where not, no_path says so
  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return "ompl_rrt_connect"; }

 private:
  RrtConnectOptions options_;
  std::uint64_t seed_;
};

PlannerDescription rrt_connect_description();

}  // namespace waywright
