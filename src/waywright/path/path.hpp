// A path: curves in order, each driven in one direction.
#pragma once

#include <optional>
#include <vector>

#include "waywright/curve/curve.hpp"

namespace waywright {

/// The vehicle's heading along a curve that it does not face along, as a mecanum drive can: evenly with arc length from `from` by `turn`.
struct HeadingAlong {
  double from = 0.0;  ///< rad, at the curve's start
  double turn = 0.0;  ///< rad, left positive
};

/// direction: +1 forward (the vehicle's heading is the curve's course), −1 backward (course + π), 0 turning on the spot.
struct Piece {
  Curve curve;
  int direction = 1;
  std::optional<HeadingAlong> heading{};  ///< of lines and arcs driven in direction +1, where the vehicle does not face along them
};

/// As many as a docking pattern has, with the stretch in which a moving vehicle stops and the one into a pocket, need no memory of their own.
using Pieces = boost::container::small_vector<Piece, 4>;

struct Path {
  Pieces pieces;
};

/// One row of the plan file's samples. Where direction changes a pose stands twice, at the same s.
struct Sample {
  double s = 0.0;        ///< m from the start, along the path
  double x = 0.0;        ///< m
  double y = 0.0;        ///< m
  double heading = 0.0;  ///< of the vehicle, (−π, π]
  double course = 0.0;   ///< direction of travel, (−π, π]
  double curvature = 0.0;       ///< of the followed curve in its direction of travel, 1/m, left positive; 0 when turning on the spot
  double curvature_rate = 0.0;  ///< dκ/ds, 1/m²
  int direction = 1;
  double t = 0.0;      ///< s from the start
  double speed = 0.0;  ///< m/s, ≥ 0
  std::size_t piece = 0;  ///< index into Path::pieces
  bool faces_along = true;     ///< the heading follows the course (or its opposite), as of every vehicle but a mecanum drive
  double heading_rate = 0.0;   ///< dθ/ds, rad/m, where it does not

  /// rad/m, dθ/ds, and its change dθ′/ds, rad/m².
  double turning() const { return faces_along ? curvature : heading_rate; }
  double turning_rate() const { return faces_along ? curvature_rate : 0.0; }

  Pose pose() const { return {x, y, heading}; }
};

/// Vehicle poses at the path's two ends. @pre the path is not empty
Pose start_pose(const Path& path);
Pose end_pose(const Path& path);
Pose start_pose(const Piece& piece);
Pose end_pose(const Piece& piece);

/// Length of one piece or path in metres (turning on the spot has none).
double length(const Piece& piece);
double length(const Path& path);

/// Curvature in the direction of travel at the two ends of a piece, 1/m.
double start_curvature(const Piece& piece);
double end_curvature(const Piece& piece);

/// The same places driven the other way, last to first; the vehicle faces as before. Law: reversed twice is the same up to rounding.
Path reversed(const Path& path);

/// So many samples a path may have. One that needs more is too long or too bent to be judged.
inline constexpr std::size_t most_samples = 500'000;

/// Of samples where nothing else is asked for: m, and rad of turning.
inline constexpr double sample_step = 0.05;

/// How many samples the path needs for what `sample` promises (an upper bound); +∞ where a curve has a cusp.
double samples_needed(const Path& path, double radius, double tolerance, double step = sample_step);

/// Whether these are at most `most_samples`; cheap where they are far fewer.
bool can_be_sampled(const Path& path, double radius, double tolerance, double step = sample_step);

/// Samples at most `step` metres and `step` radians apart, and so dense that straight interpolation of the poses stays
/// within `tolerance` of the true motion for every point at most `radius` from the vehicle's origin, by bounds of curvature and its
/// rate. Every joint of curves has a sample, two where curvature jumps. Where more than most_samples are needed, all steps are wider.
/// First = start, last = end; t and speed are left at 0 (speed/ fills them).
std::vector<Sample> sample(const Path& path, double radius, double tolerance, double step = sample_step);
/// The same into `samples`, whose memory is reused.
void sample(const Path& path, double radius, double tolerance, double step, std::vector<Sample>& samples);

/// Places i where the vehicle must stand still between samples i−1 and i (same s): direction changes, turns on the spot.
bool is_direction_change(const Sample& before, const Sample& after);

/// The way of a vehicle that need not face along it has a corner between these neighbours (same s), by more than `tolerance` rad.
bool is_course_jump(const Sample& before, const Sample& after, double tolerance = 1e-6);

}  // namespace waywright
