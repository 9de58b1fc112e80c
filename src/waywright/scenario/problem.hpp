// A scenario made ready: immutable, shared by planners, proof and metrics, safe to read from many threads.
#pragma once

#include <memory>

#include "waywright/core/result.hpp"
#include "waywright/map/world.hpp"
#include "waywright/path/path.hpp"
#include "waywright/scenario/pocket.hpp"
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
  /// What drives: the vehicle's footprint, with its load where it carries one.
  const Footprint& footprint() const { return footprint_; }

  /// What planners are asked: a path from `start` to `goal` (of a station: the docked pose) that keeps the required clearance. The way out
  /// of a station is planned as the way in, and driven back.
  const Pose& start() const { return scenario_.start; }
  const Pose& goal() const { return goal_; }

  /// The whole mission: what planners found, with the stretch into or out of the shelf, in the order in which it is driven.
  bool is_driven_back() const { return driven_back_; }
  const std::optional<PocketMotion>& pocket() const { return pocket_; }
  const Pose& first_pose() const { return driven_back_ ? at_shelf() : start(); }
  const Pose& last_pose() const { return driven_back_ ? start() : at_shelf(); }
  Path whole_path(Path planned) const;
  /// @pre there is a pocket
  Piece pocket_stretch() const;
  /// Which piece of a whole path is the stretch in the shelf; empty where it has none or it is not as it must be.
  std::optional<std::size_t> pocket_piece(const Path& path) const;

  /// Distance by which any point of the footprint can be off within the scenario's pose error. m
  double pose_error_margin() const { return pose_error_margin_; }
  /// Clearance that a nominal pose must show: clearance + pose error margin. m
  double required_clearance() const { return scenario_.clearance + pose_error_margin_; }

  /// First or last pose of the mission, or the docked one, that cannot be: *_outside, *_in_collision with the obstacle's name; empty where
  /// all are fine.
  std::optional<Failure> check_ends() const;

 private:
  Problem() = default;
  const Pose& at_shelf() const { return pocket_ ? pocket_->inner : goal_; }
  std::optional<InputError> set_station(const Station& station);
  std::optional<Failure> check_pocket() const;

  Scenario scenario_;
  Footprint footprint_;
  std::optional<PocketMotion> pocket_;
  bool driven_back_ = false;
  World world_;
  Pose goal_{};
  double pose_error_margin_ = 0.0;
};

}  // namespace waywright
