// The times of a path that a planner wants among moving obstacles, in place of those of the rule that stops for them (waits.hpp).
#pragma once

#include <optional>
#include <vector>

#include "waywright/judge/waits.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// How fast a way is wanted to be driven where, and where the vehicle is to stand for how long. Of the whole path, with the stretch in which a moving vehicle stops.
struct Pace {
  struct Place {
    double s = 0.0;      ///< m, never falling
    double speed = 0.0;  ///< m/s, ≥ 0: no faster than this; v² is linear in s between two places, which is even acceleration
  };
  std::vector<Place> places;      ///< at least two; beyond the first and the last the way is as fast as it may be
  std::vector<WantedWait> waits;  ///< by rising s
};

/// The pace of a plan that is being driven, from t seconds and `driven` metres on: its speeds, and where it stands. @pre the samples carry t and speed; t and `driven` are of one place of them
Pace pace_from(const std::vector<Sample>& samples, std::span<const Wait> waits, double t, double driven);

/// The fastest profile under the vehicle's limits, those along the way and the pace, with the waits. Laws: every limit that assign_speed keeps is kept; a place where the
/// pace is 0 is driven through at rest. Nothing is said of whether the times are clear of what moves: check_in_time does.
Timed timed_at_pace(const Problem& problem, const std::vector<Sample>& samples, const LimitsAlong& along, const Pace& pace);

}  // namespace waywright
