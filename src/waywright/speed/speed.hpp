// Speed and time along a sampled path under the vehicle's limits.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "waywright/path/path.hpp"
#include "waywright/vehicle/vehicle.hpp"

namespace waywright {

inline constexpr double default_angular_acceleration = 1.0;  ///< rad/s², of turns on the spot where a vehicle has no limit

/// Fills t and speed of every sample: the fastest profile that is at rest at both ends, at changes of
/// direction, at corners of a way that the vehicle does not face along, and where the curvature jumps while curvature rate, steering rate or angular acceleration is
/// limited, and keeps speed (by direction), acceleration, deceleration, lateral acceleration, angular speed
/// and acceleration (|θ′·a + θ″·v²|; θ′ = κ where the vehicle faces along), and the steering rate (wheelbase·|dκ/ds|·v / (1 + (wheelbase·κ)²) ≤
/// max_steering_rate), and of a mecanum base its wheels' greatest speed. v² is linear in s between samples, but for steps that begin and end at rest, which
/// speed up and slow down within; turning on the spot follows the angular limits (1 rad/s and 1 rad/s² where
/// absent); a steered wheel that has to turn while the vehicle stands is waited for. Laws: t never decreases
/// and is finite; speed ≥ 0; limits hold at both ends of every step. Returns the total time in s.
///
/// With a `start_speed` (m/s, ≥ 0, in the first sample's direction) the first sample is passed with it instead of at rest; where that
/// cannot be (can_start_with), with the greatest speed that can. From a speed over that of the profile, which is made for the worse end
/// of each step, it brakes as hard as may be until it meets the profile, under what the samples' own curvature allows. A turn on the spot
/// begins at rest.
/// @pre s never decreases; limits > 0
double assign_speed(std::vector<Sample>& samples, const Vehicle& vehicle, double start_speed = 0.0);

/// What holds along a path beside the vehicle's limits: greatest speeds in m/s, +∞ where there is none. `steps[i]` between samples i and
/// i + 1; `samples[i]` at sample i, beside those of its steps. Both empty: nothing.
struct LimitsAlong {
  std::vector<double> steps, samples;
};

/// What holds along one step between samples, whichever of its two ends is worse; so it holds between them too.
struct SpeedStep {
  double length = 0.0;  ///< m; 0: both samples are at one place
  double turn = 0.0;    ///< rad, of a turn on the spot; else 0
  double top = std::numeric_limits<double>::infinity();  ///< m²/s², greatest v² by speed, lateral acceleration, angular speed, steering rate, wheel speed
  double turning = 0.0;  ///< greatest |dθ/ds| of the heading, rad/m: |κ| where the vehicle faces along
  double rate = 0.0;     ///< greatest |d²θ/ds²|, rad/m²
};

/// Memory that is reused from profile to profile.
struct SpeedWorkspace {
  std::vector<SpeedStep> steps;
  std::vector<double> caps;     ///< m²/s², v² that a sample's steps allow
  std::vector<double> squares;  ///< m²/s², v² of the profile
  /// For so many samples nothing is allocated.
  void reserve(std::size_t samples);
};
double assign_speed(std::vector<Sample>& samples, const Vehicle& vehicle, double start_speed, SpeedWorkspace& workspace, const LimitsAlong& along = {});

/// Can the first sample be passed with this speed (m/s, > 0) so that the rest keeps all limits? 0.1 % too fast is allowed for, since speeds are
/// measured: the profile then begins that much slower.
bool can_start_with(const std::vector<Sample>& samples, const Vehicle& vehicle, double speed, SpeedWorkspace& workspace, const LimitsAlong& along = {});

/// Greatest speed in m/s with which the first sample can surely be passed so: that of the profile. 0 where the vehicle must stand there.
double greatest_start_speed(const std::vector<Sample>& samples, const Vehicle& vehicle, SpeedWorkspace& workspace, const LimitsAlong& along = {});

/// How far and how fast a vehicle is within a step between two samples that carry t and speed, `time` s after the first of them (clamped): evenly accelerated; from rest to rest
/// it speeds up for one half of the time and slows down for the other. Of a step at one place nothing.
struct WithinStep {
  double way = 0.0;    ///< m
  double speed = 0.0;  ///< m/s
};
WithinStep within_step(const Sample& from, const Sample& to, double time);

/// s that a step takes at least which begins and ends at rest and moves between.
double time_from_rest_to_rest(const Sample& before, const Sample& after, const Vehicle& vehicle);

/// The vehicle must stand at both of these neighbours: the direction changes, it turns on the spot, its way has a corner that it does not turn
/// for, or the curvature jumps and steering (or turning faster) takes time.
bool must_stand(const Sample& before, const Sample& after, const Vehicle& vehicle);

/// Samples i−1, i of two pieces at one place whose curvature differs by more than `tolerance` 1/m.
bool is_curvature_jump(const Sample& before, const Sample& after, double tolerance = 1e-6);
/// The same of dθ/ds, rad/m: what a vehicle that need not face along turns by.
bool is_turning_jump(const Sample& before, const Sample& after, double tolerance = 1e-6);

}  // namespace waywright
