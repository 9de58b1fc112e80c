// The timing of a path among moving obstacles: where the vehicle stops, how long it waits, when it goes on.
#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "waywright/judge/plan.hpp"
#include "waywright/scenario/problem.hpp"
#include "waywright/speed/speed.hpp"

namespace waywright {

/// A stop that is wanted whatever moves: at the first sample from `s` on, not to be left before `until`.
struct WantedWait {
  double s = 0.0;      ///< m
  double until = 0.0;  ///< s
  std::size_t obstacle = 0;
};

struct Timed {
  std::vector<Sample> samples;  ///< with t and speed; where the vehicle waits one stands twice, at the same s
  std::vector<Wait> waits;
  std::optional<Hindrance> hindrance;  ///< then the samples are those of the fastest profile, as if nothing moved
};

/// The rule: while the vehicle moves, its next `range` metres (in its driving direction, up to where that changes) are clear of the obstacle by the scenario's clearance; where
/// they would not be, it stands, as far on as that leaves it, until they have been clear for `free_for` seconds and it can go on. Where it cannot stop that far away any
/// more it brakes as hard as it may; it is hindered where that would be too late, where an obstacle comes to the place that it waits at, or stands in its way for ever.
///
/// The times are those of `assign_speed`, part by part. What comes of it is judged by check_in_time, which knows nothing of it.
Timed timed_past_moving(const Problem& problem, const std::vector<Sample>& samples, const LimitsAlong& along, double tolerance, std::span<const WantedWait> wanted = {},
                        const std::atomic<bool>* cancel = nullptr);

/// Why no timing serves, with its figures.
std::string hindrance_sentence(const Problem& problem, const Hindrance& hindrance);

}  // namespace waywright
