// What being near to something costs along a motion, in metres.
#pragma once

#include <functional>
#include <limits>

#include "waywright/map/clearance_along.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// The integral of a barrier on the clearance along a motion: wanted/c − 1 where what is beyond the required clearance, c, is under what is wanted.
/// Between two poses nothing is nearer than half of what their clearances leave of the way that the footprint moves: where that is not enough, more poses
/// are looked at.
class Nearness {
 public:
  /// `wanted`: m beyond the required clearance, > 0. `depth_of`: m, how deep a pose that touches something is in it, the steadier the better.
  /// @pre the problem outlives this
  Nearness(const Problem& problem, double wanted, std::function<double(const Pose&)> depth_of);

  double barrier() const { return barrier_; }  ///< m
  double lacking() const { return lacking_; }  ///< m, length that is too near, longer the nearer
  double least() const { return least_; }      ///< m, beyond the required clearance

  /// The motion from a pose to the next, `length` metres. The first and last pose may just keep what is required.
  void add(const Pose& a, const Pose& b, double length, bool is_first, bool is_last);

 private:
  double beyond(const Pose& pose);
  void add(const Pose& a, const Pose& b, double ca, double cb, double length, int depth);

  std::function<double(const Pose&)> depth_of_;
  double required_, wanted_, radius_;
  ClearanceAlong along_;
  double before_ = 0.0;
  double barrier_ = 0.0, lacking_ = 0.0;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace waywright
