// Straight drives and turns on the spot against the exact outlines: what joins true poses to cells, and cells to each other.
#pragma once

#include <vector>

#include "waywright/scenario/problem.hpp"

namespace waywright {

/// For one thread. A drive is tested without any error: what a convex part sweeps on a straight line is the hull of its two places. A turn is
/// cut into steps of at most `turn_step`, and each tested by the hull of its ends, grown by how far a point between leaves their chord.
class MotionCheck {
 public:
  static constexpr double turn_step = 0.06;  ///< rad; the growth is under 0.05 % of the footprint's radius

  explicit MotionCheck(const Problem& problem) : MotionCheck{problem, problem.footprint()} {}
  /// Of another footprint, for example a disc around the vehicle's.
  MotionCheck(const Problem& problem, const Footprint& footprint);

  /// Does the footprint, facing `heading`, keep more than `margin` m from everything on the straight way? @pre margin ≥ 0
  bool is_drive_free(Vec2 from, Vec2 to, double heading, double margin);
  /// The same of a turn on the spot by `angle`. A disc always turns where it can stand.
  bool is_turn_free(Vec2 at, double from, double angle, double margin);

  /// What a drive or turn sweeps about the origin, for tests at many places: rings and how much each is to be grown.
  struct Swept {
    Ring ring;
    double grown = 0.0;  ///< m
  };
  std::vector<Swept> drive_rings(Vec2 way, double heading) const;
  std::vector<Swept> turn_rings(double from, double angle) const;
  bool is_free(const std::vector<Swept>& swept, Vec2 at, double margin);

 private:
  const Problem& problem_;
  std::vector<Ring> parts_;  ///< convex; of a disc its middle
  double grown_ = 0.0;       ///< m, a disc's radius
  bool is_disc_ = false;
  Ring placed_;
};

/// What a drive between true poses keeps: the clearance that is required, which the proof can confirm to a micrometre.
double connecting_margin(const Problem& problem);
/// What moves between cells keep: twice the proof's tolerance more, so that nothing hangs on rounding.
double lattice_margin(const Problem& problem);

}  // namespace waywright
