// Clearance of one pose after another along a motion: what is known of the last one bounds the next.
#pragma once

#include "waywright/geometry/moving_outline.hpp"
#include "waywright/map/world.hpp"

namespace waywright {

/// Law: `at(pose)` is `world.least_clearance(footprint, pose, cap)`, at most `cap`, whatever was asked before, up to rounding. Poses near the one before
/// cost a fraction of it: no point of the footprint moved farther than |Δp| + R |Δheading|, so the distance changed by no more, and where it was
/// greater than that nothing can have come to lie inside of anything.
class ClearanceAlong {
 public:
  /// @pre the world outlives this; cap > 0, m
  ClearanceAlong(const World& world, const Footprint& footprint, double cap);

  double at(const Pose& pose);
  /// As if nothing had been asked: what comes next is another motion.
  void forget();
  /// The same for each, appended.
  void at(std::span<const Pose> poses, std::vector<double>& clearances);

 private:
  double at(const Pose& pose, double sin, double cos);

  const World* world_;
  double cap_;
  double grown_;   // m, a disc's radius
  double radius_;  // m, by which turning moves
  MovingOutline outline_;
  bool has_last_ = false;
  Pose last_{};
  double clearance_ = 0.0;  // of the last, m
};

}  // namespace waywright
