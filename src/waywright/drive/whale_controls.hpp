// GenerateControls of the RRT*-WOA publication (Algorithm 6): commands from waypoint to waypoint by the whale optimisation algorithm.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "waywright/drive/controls.hpp"
#include "waywright/optimizer/whale_step.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// Numbers that the publication does not give are those of its reconstruction; what is marked with * is ours.
struct WhaleControlOptions {
  std::int64_t population = 30;
  std::int64_t iterations = 80;      ///< of a search
  std::int64_t restarts = 5;         ///< more searches with the same number of commands, at most
  std::int64_t triplets = 2;         ///< commands of a segment, at first
  std::int64_t most_triplets = 4;    ///< one more at a time, where that does not do *
  std::int64_t backtracks = 10;      ///< times that segments before one that fails are searched again, in all *
  double tolerance = 0.10;           ///< m, of a segment's end
  double heading_tolerance = 0.10;   ///< rad, likewise *
  double aim = 0.05;                 ///< m, of the same: searches go on until a segment ends so near; farther off is no failure *
  double heading_aim = 0.10;         ///< rad, likewise *
  double heading_weight = 0.2;       ///< [w_φ] m/rad
  double time_weight = 0.02;         ///< [w_t] m/s
  double speed_weight = 0.5;         ///< m per m/s by which a segment ends faster than the plan is there: what follows could not be driven *
  double rate_weight = 0.1;          ///< m per rad/s by which it ends turning otherwise than the plan *
  double least_time = 0.1;           ///< s, of a command
  double most_time = 4.0;            ///< s
  double turn_speed = 1.0;           ///< rad/s, where the vehicle names no limit
  double spacing = 1.0;              ///< m, of waypoints, at most: the publication's step of the tree *
  double clearance = 0.0;            ///< m, more than which the footprint keeps from everything *
  bool warm = true;                  ///< one agent begins as the plan drives the segment, on the mean *
  WhaleParameters whale{};
  WhaleForm form = WhaleForm::unbiased;
};

/// (v, ω, t) as printed: a speed and a turning rate that are commanded for t.
struct Triplet {
  double v = 0.0, turn = 0.0, time = 0.0;  ///< m/s, rad/s, s
};

/// Where a segment should end.
struct ControlWaypoint {
  Pose pose{};             ///< the heading is that with which the path goes on from there, after turns on the spot
  int direction = 1;       ///< of driving to it; 0: a turn where the vehicle stands
  bool is_stand = false;   ///< the vehicle stands there: the end, a change of direction, a jump of curvature for which the wheel has to be turned
  double top_speed = 0.0;  ///< m/s, of zones on the way to it; +∞ where there are none
  double speed = 0.0, turn_rate = 0.0;  ///< of the plan where the segment ends: m/s, ≥ 0, and rad/s
  /// How the plan gets there from the waypoint before: m, rad and s of driving, rad and s of turning on the spot afterwards.
  double way = 0.0, bend = 0.0, way_time = 0.0, turn = 0.0, turn_time = 0.0;
};
/// Of a judged plan. Equal parts, at most `spacing` m, of every stretch without a turn on the spot or another stand, and the ends of these.
std::vector<ControlWaypoint> control_waypoints(const Problem& problem, const Plan& plan, double spacing);

struct ControlSegment {
  ControlWaypoint to{};
  std::vector<Triplet> triplets;
  EndError end;              ///< of this segment
  double time = 0.0;         ///< s, with braking where the vehicle is to stand
  std::int64_t evaluations = 0;
  std::int64_t searches = 0;
  bool collision_free = false;  ///< by the continuous motion, not by its steps
};

struct WhaleControls {
  double period = 0.0;            ///< s, of the simulation
  std::vector<ControlSegment> segments;
  std::vector<ControlRow> rows;   ///< what the vehicle does while it follows the commands
  EndError end;
  double worst_end = 0.0;         ///< m, of the segments
  double worst_heading = 0.0;     ///< rad, likewise
  double least_clearance = 0.0;   ///< m, at the rows' poses, at most 10
  std::int64_t evaluations = 0;   ///< of all searches, those given up too
  bool collision_free = false;
  bool arrives = false;           ///< no segment's end is off by `tolerance` or `heading_tolerance` or more
};

/// One search a segment for commands (v, ω, t)ⁿ, from the state in which the last segment's simulation ended. Cost
///   ‖p − x‖ + w_φ |φ − φ_next| + w_t Σt + 10 [collides] + w_v max(0, |v| − v_plan) + w_ω |ω − ω_plan|,
/// p by odometry along the arcs of steps of `period`, the vehicle following its commands within its limits (drive_model.hpp), so that speeds are continuous within segments
/// and between them. Beyond the publication: the last two terms; the last segment is asked for the goal's heading; backwards segments have v ≤ 0; where the vehicle is to
/// stand it brakes after the last command; a waypoint on a bend has the bend's heading. Collisions are looked for where a candidate would be the best.
/// Same plan, options, seed: the same bits.
/// A plan that goes nowhere has no segments and one row, which stands.
/// @pre a plan without legs that verifies against the problem; the problem has no pocket
WhaleControls whale_controls(const Problem& problem, const Plan& plan, const WhaleControlOptions& options, double period, std::uint64_t seed);

}  // namespace waywright
