// Is the footprint free along a whole line or arc? Continuous, by bisection.
#pragma once

#include <cstdint>
#include <map>

#include "waywright/path/path.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// Tests placements and motions of the problem's footprint, and counts what stood in the way.
class MotionTest {
 public:
  explicit MotionTest(const Problem& problem);

  /// The pose keeps the required clearance.
  bool pose_free(const Pose& pose);
  /// The whole motion does: an interval is free where the clearance in its middle exceeds what is required by more than any
  /// footprint point moves in half of it; else it is halved, down to millimetres.
  bool piece_free(const Piece& piece);

  std::int64_t placements() const { return placements_; }
  /// Name of the obstacle that blocked most placements, and its share of the blocked ones; empty where none did.
  std::pair<std::string, double> worst_obstacle() const;

 private:
  bool interval_free(const Arc& arc, int direction, double begin, double end);
  double slack(const Pose& pose);

  const Problem& problem_;
  double radius_;
  double required_;
  std::int64_t placements_ = 0;
  std::map<std::size_t, std::int64_t> blocked_;
};

}  // namespace waywright
