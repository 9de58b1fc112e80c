// A plan's motion in time: where the vehicle is, on the exact curves, at any time of the plan's speed profile.
#pragma once

#include <vector>

#include "waywright/drive/path_places.hpp"
#include "waywright/vehicle/vehicle.hpp"

namespace waywright {

/// What a vehicle does between two times at which it stands, or in motion from the plan's beginning.
struct Stretch {
  enum class Kind { drive, turn, wait };  ///< turn: on the spot; wait: until the steered wheel is where it has to be
  Kind kind = Kind::drive;
  int direction = 1;            ///< +1, −1; 0 but for drive
  std::size_t first = 0, last = 0;  ///< samples
  double duration = 0.0;        ///< s
};

/// A moment of a stretch.
struct Moment {
  Pose pose{};
  double s = 0.0;          ///< m, driven
  double heading = 0.0;    ///< rad, not wrapped: it goes on from that of the plan's start
  double steering = 0.0;   ///< rad, of the steered wheel; 0 where there is none
};

/// Between samples as the profile has it: v² linear in s on a step, speeding up and slowing down within steps that begin and end at rest, and likewise on the spot.
/// Laws: stretches follow each other without a gap, from the first sample to the last; s never decreases; a stretch's ends are its samples.
class PlanMotion {
 public:
  /// @pre samples are those of the path, at least two, t and s never decrease (as `verify` confirms)
  PlanMotion(const Path& path, std::vector<Sample> samples, const Vehicle& vehicle);

  const std::vector<Stretch>& stretches() const { return stretches_; }
  const std::vector<Sample>& samples() const { return samples_; }
  /// `time` s after the stretch's begin; clamped to it.
  Moment at(const Stretch& stretch, double time) const;

 private:
  Moment at_sample(std::size_t i) const;
  double driven(std::size_t step, double time) const;

  PathPlaces places_;
  std::vector<Sample> samples_;
  Vehicle vehicle_;
  std::vector<double> headings_;  ///< rad, not wrapped
  std::vector<Stretch> stretches_;
};

}  // namespace waywright
