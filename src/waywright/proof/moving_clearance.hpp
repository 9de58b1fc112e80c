// A way in time held against obstacles that move: proven by bounds on where both can be, never by looking at single times.
#pragma once

#include <limits>
#include <vector>

#include "waywright/map/world.hpp"
#include "waywright/path/path.hpp"
#include "waywright/proof/proof.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

struct TimeSpan {
  double begin = 0.0, end = 0.0;  ///< s
};

/// For each of a problem's moving obstacles: when may a piece of the way be nearer to it than is allowed?
///
/// Law: at a time in none of the spans, whatever pose between the two samples the vehicle has (straight interpolation, and `tolerance` about it) and wherever within its
/// spread the obstacle is, more than `needed` lies between the two. The converse holds up to a centimetre or two and a hundredth of a second (a thousandth of the time since the start, where that
/// is more).
class MovingClearance {
 public:
  /// The problem outlives it. `needed`: m; `tolerance`: m, by which the true motion may leave the interpolated one.
  MovingClearance(const Problem& problem, double needed, double tolerance);

  std::size_t size() const { return bodies_.size(); }
  double needed() const { return needed_; }

  static constexpr double for_ever = std::numeric_limits<double>::infinity();
  /// Spans within [from, to], rising, with gaps between; `to` may be for_ever.
  void blocked(const Pose& a, const Pose& b, std::size_t obstacle, double from, double to, std::vector<TimeSpan>& spans) const;
  /// The same of poses that lie within `reach` m of the pose (every point of the footprint): is there none at all?
  bool is_clear(const Pose& about, double reach, std::size_t obstacle, double from, double to) const;
  /// m between the footprint at a pose and the obstacle as predicted for a time, capped at `cap`.
  double distance_at(const Pose& pose, std::size_t obstacle, double t, double cap) const;

 private:
  struct Body {
    World world;         // the obstacle in its own frame; a disc as its middle
    double grown = 0.0;  // m, radius of a disc
    MovingPlaces places;
    explicit Body(const MovingObstacle& obstacle);
  };
  struct Step {
    Pose a{}, b{};
    double way = 0.0;  // m that no point of the footprint moves farther by
    double slack = 0.0;
  };
  double distance(const Body& body, const Pose& vehicle, const Pose& obstacle, double enough) const;
  bool look(const Body& body, const Step& step, double low, double high, double from, double to, std::vector<TimeSpan>& spans) const;
  double last_time(const Body& body, std::size_t obstacle, Vec2 about, double reach) const;

  const Problem& problem_;
  double needed_, tolerance_, radius_;
  std::vector<Body> bodies_;
};

/// Samples and tracks that would take minutes to be held against each other are not: such a plan is not proven.
bool is_too_much_in_time(const Problem& problem, std::size_t samples);

/// Is the way driven in these times clear of every moving obstacle by the scenario's clearance, at every pose within the pose error? One violation for each obstacle that it
/// is not clear of, where it begins. @pre samples of a measurable path, with t that never decreases; nothing is said of what comes after the last
std::vector<Violation> check_in_time(const Problem& problem, const std::vector<Sample>& samples, double tolerance);

}  // namespace waywright
