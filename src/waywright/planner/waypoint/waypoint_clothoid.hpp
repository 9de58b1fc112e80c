// `waypoint_clothoid`: through waypoints on clothoids, headings chosen by an optimizer for one of many objectives (waypoint publication). Ours by default:
// curvature-continuous chains within the vehicle's limits, length and a barrier on the clearance, in metres, proven.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "waywright/objective/fitness.hpp"
#include "waywright/optimizer/optimizer.hpp"
#include "waywright/planner/planner.hpp"
#include "waywright/planner/waypoint/chain.hpp"

namespace waywright {

enum class WaypointObjective { mlpc, mlmc, mdobs, avgmd, pwavg, levels, pwavg_margin, metres };

inline constexpr std::array waypoint_objectives{WaypointObjective::mlpc,  WaypointObjective::mlmc,   WaypointObjective::mdobs,        WaypointObjective::avgmd,
                                                WaypointObjective::pwavg, WaypointObjective::levels, WaypointObjective::pwavg_margin, WaypointObjective::metres};
/// As the command line names it.
const char* to_string(WaypointObjective objective);
std::string meaning_of(WaypointObjective objective);  ///< in some words

struct WaypointOptions {
  WaypointObjective objective = WaypointObjective::metres;
  FitnessForm form = FitnessForm::corrected;
  Continuity continuity = Continuity::g2;
  std::int64_t evaluations = 4000;
  int population = 50;
  double heading_range = 1.6;      ///< rad to each side of the mean course at a waypoint, in (0, π]; π: all headings
  double bend_range = 1.0;         ///< 1/m, how far the curvature at a waypoint may be from that of the clothoids before and after it, ≥ 0, at most 3 rad over the shorter leg; of G2 chains
  int samples = 100;               ///< poses that the published functions look at, ≥ 2
  double margin = 0.01;            ///< m, least distance of `pwavg_margin`, beside the clearance asked for, > 0
  double wanted_clearance = 0.5;   ///< m beyond the clearance asked for, from where `metres` feels no obstacle, > 0
  double clearance_weight = 1.0;   ///< of its barrier, ≥ 0
  double bend_weight = 0.5;        ///< m², of ∫κ² ds in `metres`, ≥ 0
  double step = 0.1;               ///< m, distance of the poses that `metres` looks at, > 0
};

class WaypointClothoidPlanner {
 public:
  /// `for_many` takes over where the optimizer is lattice_search and there are more variables than it can.
  WaypointClothoidPlanner(WaypointOptions options, std::shared_ptr<const Optimizer> optimizer, std::shared_ptr<const Optimizer> for_many, std::uint64_t seed)
      : options_{options}, optimizer_{std::move(optimizer)}, for_many_{std::move(for_many)}, seed_{seed} {}
  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return "waypoint_clothoid"; }

 private:
  WaypointOptions options_;
  std::shared_ptr<const Optimizer> optimizer_, for_many_;
  std::uint64_t seed_;
};

}  // namespace waywright
