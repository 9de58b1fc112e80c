// Candidates of the waypoint planner: from decision variables to a chain of clothoids and what it costs.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "waywright/planner/waypoint/distances.hpp"
#include "waywright/planner/waypoint/waypoint_clothoid.hpp"

namespace waywright {

/// Evaluates candidates of one problem, in memory that is kept: for one thread.
class WaypointCandidates {
 public:
  /// @pre both outlive this
  WaypointCandidates(const Problem& problem, const WaypointOptions& options);

  /// One course a waypoint; of G2 chains a curvature, too; and its place, where it may be left by a radius.
  const SearchSpace& space() const { return space_; }
  std::optional<Clothoids> chain_at(std::span<const double> x, std::size_t* unsolved = nullptr) const;
  /// A candidate whose chain has no solution is as bad as can be.
  Evaluation evaluate(std::span<const double> x);

  /// Length, clearance and curvature against each other.
  struct Figures {
    double length = 0.0;        ///< m
    double clearance = 0.0;     ///< m, least at the poses that `metres` looks at, at most what is required and what is wanted beyond it
    double curvature = 0.0;     ///< 1/m, greatest
    double violation = 0.0;     ///< as `metres` has it
  };
  Figures figures_at(std::span<const double> x);

  const WaypointOptions& options() const { return options_; }

  /// Over the vehicle's curvature or its rate.
  bool is_beyond_limits(const Clothoids& chain) const { return beyond_limits(chain) > 0.0; }

  struct Tightest {
    Pose pose{};
    Contact contact{};
  };
  /// Where the poses that `metres` looks at are nearest to something.
  Tightest tightest_of(const Clothoids& chain);

  /// What the published functions see of a chain; valid until the next call.
  const TrajectoryMeasures& measures_of(const Clothoids& chain, FitnessForm form, bool wants_greatest);

 private:
  struct Metres {
    Evaluation evaluation;
    double clearance;  // m, least beyond the required one
  };
  Metres in_metres(const Clothoids& chain);
  /// Poses a step apart; how far.
  double sample_by_step(const Clothoids& chain);
  double beyond_limits(const Clothoids& chain) const;

  const Problem& problem_;
  const WaypointOptions& options_;
  MapObjects objects_;
  SearchSpace space_;
  bool has_bends_ = false;   // as variables
  bool may_leave_ = false;   // waypoints, by the scenario's radius
  std::vector<Pose> poses_;
  TrajectoryMeasures measures_;
};

}  // namespace waywright
