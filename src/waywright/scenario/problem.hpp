// A scenario made ready: immutable, shared by planners, proof and metrics, safe to read from many threads.
#pragma once

#include <memory>

#include "waywright/core/result.hpp"
#include "waywright/map/world.hpp"
#include "waywright/scenario/scenario.hpp"

namespace waywright {

class Problem {
 public:
  /// Builds the world (map + station's area + shelf). Checks of single fields are the reader's; this refuses what only
  /// shows when map, vehicle and mission meet (shelf outside the station, gap under clearance, …).
  static Parsed<Problem> prepare(Scenario scenario);

  const Scenario& scenario() const { return scenario_; }
  const Vehicle& vehicle() const { return scenario_.vehicle; }
  const World& world() const { return world_; }
  const Pose& start() const { return scenario_.start; }
  const Pose& goal() const { return goal_; }  ///< the docked pose of a station

  /// Distance by which any point of the footprint can be off within the scenario's pose error. m
  double pose_error_margin() const { return pose_error_margin_; }
  /// Clearance that a nominal pose must show: clearance + pose error margin. m
  double required_clearance() const { return scenario_.clearance + pose_error_margin_; }

  /// Start or goal that cannot be: *_outside, *_in_collision with the obstacle's name; empty where both are fine.
  std::optional<Failure> check_ends() const;

 private:
  Problem() = default;
  Scenario scenario_;
  World world_;
  Pose goal_{};
  double pose_error_margin_ = 0.0;
};

}  // namespace waywright
