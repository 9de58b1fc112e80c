// An obstacle that moves as it is told to: where it is at any time, and how fast that changes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "waywright/vehicle/vehicle.hpp"

namespace waywright {

inline constexpr std::size_t most_moving = 200;          ///< obstacles in a scenario
inline constexpr std::size_t most_track_points = 10'000;  ///< of one
inline constexpr double latest_time = 1e6;                ///< s
inline constexpr double fastest_obstacle = 1e3;           ///< m/s

/// Times are s after the plan's start. Between the points of its track it goes straight, evenly in time, and turns the shorter way; before the first it stands there;
/// after the last one it goes on with `velocity`, without turning.
struct MovingObstacle {
  struct Place {
    double t = 0.0;  ///< s
    Pose pose{};     ///< of its own frame
  };
  std::string name;                       ///< free, for sentences
  Footprint footprint;                    ///< in its own frame
  std::vector<Place> track{Place{}};      ///< times rise; at least one
  Vec2 velocity{};                        ///< m/s, world frame
  double spread = 0.0;                    ///< m/s: so much for every second since it was seen it may be off. ≥ 0
  double seen = 0.0;                      ///< s, time at which it was where the track has it. ≤ 0
  double range = 1.0;                     ///< m of the way ahead that have to be free of it while the vehicle moves, ≥ 0
  double free_for = 1.0;                  ///< s that they have to be before the vehicle goes on, ≥ 0
  double patience = 10.0;                 ///< s that the vehicle waits for one that stands in its way; then it counts as an obstacle that stays. ≥ 0

  Pose at(double t) const;
  /// m, by which it may be elsewhere than at(t). @pre t ≥ 0
  double off_by(double t) const { return spread * (t - seen); }
  /// It stays where it is from this time on; empty where it goes on for ever.
  std::optional<double> stands_from() const;
};

/// "the cart", or "moving obstacle 2".
std::string title_of(const MovingObstacle& obstacle, std::size_t index);

/// The same obstacle with times counted from `now` (s, ≥ 0): what has been driven till then is left out. Nobody has seen it again: what it may be off by stays.
MovingObstacle seen_from(const MovingObstacle& obstacle, double now);

/// Bounds of how far a point of the obstacle gets in a stretch of time, whatever the point; made once.
class MovingPlaces {
 public:
  explicit MovingPlaces(const MovingObstacle& obstacle);

  struct Stretch {
    Pose pose{};         ///< in the middle of the time
    double reach = 0.0;  ///< m: no point of it is farther from its place in `pose` at any time of the stretch
  };
  /// @pre 0 ≤ begin ≤ end, end finite
  Stretch between(double begin, double end) const;
  /// m/s, of no point of it more at any time (without `spread`).
  double fastest() const { return fastest_; }
  /// Times at which its motion changes, rising: stretches between them are even.
  const std::vector<double>& breaks() const { return breaks_; }

 private:
  const MovingObstacle* obstacle_;
  double radius_;
  double fastest_ = 0.0;
  std::vector<double> breaks_, speeds_;  ///< speeds: before the first break, between them, after the last
};

}  // namespace waywright
