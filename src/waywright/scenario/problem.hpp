// A scenario made ready: immutable, shared by planners, proof and metrics, safe to read from many threads.
#pragma once

#include <memory>

#include "waywright/core/result.hpp"
#include "waywright/map/world.hpp"
#include "waywright/path/path.hpp"
#include "waywright/scenario/pocket.hpp"
#include "waywright/scenario/scenario.hpp"
#include "waywright/scenario/zone_rules.hpp"

namespace waywright {

/// A vehicle that moves when the plan begins. One that stops within a micrometre stands.
struct EntryMotion {
  double speed = 0.0;      ///< m/s, > 0
  int direction = 1;       ///< +1 forward, −1 backward
  double curvature = 0.0;  ///< 1/m in the direction of travel
  std::optional<double> course{};  ///< rad, direction of travel of one that does not face along its way
  double turning = 0.0;    ///< rad/m, change of the heading along the way
};

class Problem {
 public:
  /// Builds the world (map + station's area + shelf). Checks of single fields are the reader's; this refuses what only
  /// shows when map, vehicle and mission meet (shelf outside the station, gap under clearance, …). Problems that share a map may share the
  /// work that a large grid makes: `of_map` is World{scenario.map}, not built, and is copied.
  static Parsed<Problem> prepare(Scenario scenario, const World* of_map = nullptr);

  const Scenario& scenario() const { return scenario_; }
  const Vehicle& vehicle() const { return scenario_.vehicle; }
  const World& world() const { return world_; }
  /// The scenario's zones; those that are forbidden are obstacles of the world.
  const ZoneRules& zones() const { return zones_; }
  /// The same for planners: where the way is planned from its end and driven back, zones lead the other way.
  const ZoneRules& zones_as_planned() const { return driven_back_ ? zones_driven_back_ : zones_; }
  /// What drives: the vehicle's footprint, with its load where it carries one.
  const Footprint& footprint() const { return footprint_; }

  /// What planners are asked: a path from `start` to `goal` (of a station: the docked pose) that keeps the required clearance. The way out
  /// of a station is planned as the way in, and driven back. A vehicle that moves stops first, with the curvature that it has, and `start`
  /// is where it stands then; who can go on from its motion may begin at first_pose() instead.
  const Pose& start() const { return rest_; }
  const Pose& goal() const { return goal_; }
  /// A goal that leaves the heading free; none otherwise. goal() stands for it then, at its point or in the middle of its region's box, heading 0:
  /// good for estimates and pictures alone.
  const FreeGoal* free_goal() const { return std::get_if<FreeGoal>(&scenario_.mission); }
  /// Does a path that ends in this pose end as asked for, by so much?
  bool is_goal(const Pose& end, double position_tolerance, double heading_tolerance) const;

  const std::optional<EntryMotion>& motion() const { return motion_; }
  /// @pre the vehicle moves
  const Piece& stopping_stretch() const { return *stopping_; }

  /// The whole mission: what planners found, with the stretch in which a moving vehicle stops and the one into or out of the shelf, in the
  /// order in which it is driven.
  bool is_driven_back() const { return driven_back_; }
  const std::optional<PocketMotion>& pocket() const { return pocket_; }
  const Pose& first_pose() const { return driven_back_ ? at_shelf() : scenario_.start; }
  const Pose& last_pose() const { return driven_back_ ? scenario_.start : at_shelf(); }
  /// `begins_in_motion`: what was planned begins at first_pose(), though the vehicle moves there.
  Path whole_path(Path planned, bool begins_in_motion = false) const;
  /// @pre there is a pocket
  Piece pocket_stretch() const;
  /// Which piece of a whole path is the stretch in the shelf; empty where it has none or it is not as it must be.
  std::optional<std::size_t> pocket_piece(const Path& path) const;

  /// Distance by which any point of the footprint can be off within the scenario's pose error. m
  double pose_error_margin() const { return pose_error_margin_; }
  /// Clearance that a nominal pose must show: clearance + pose error margin. m
  double required_clearance() const { return scenario_.clearance + pose_error_margin_; }

  /// First or last pose of the mission, or the docked one, that cannot be: *_outside, *_in_collision with the obstacle's name; or a motion
  /// at the start that is over the vehicle's limits. Empty where all are fine.
  std::optional<Failure> check_ends() const;
  /// Where a moving vehicle would be too near to something before it comes to rest, looked at every 2 cm.
  struct BlockedStop {
    double driven = 0.0;  ///< m
    Pose pose{};
    Contact contact{};
  };
  std::optional<BlockedStop> blocked_stop() const;
  /// The same in words.
  std::optional<Failure> check_stop() const;

 private:
  Problem() = default;
  const Pose& at_shelf() const { return pocket_ ? pocket_->inner : goal_; }
  std::optional<InputError> set_station(const Station& station);
  std::optional<InputError> set_motion();
  std::optional<InputError> check_waypoints() const;
  std::optional<Failure> check_motion() const;
  std::optional<Failure> check_pocket() const;

  Scenario scenario_;
  Footprint footprint_;
  std::optional<PocketMotion> pocket_;
  bool driven_back_ = false;
  std::optional<EntryMotion> motion_;
  std::optional<Piece> stopping_;
  Pose rest_{};
  World world_;
  ZoneRules zones_, zones_driven_back_;
  Pose goal_{};
  double pose_error_margin_ = 0.0;
};

}  // namespace waywright
