// What moves, as a disc sees it: how far off it is at a time, where its nearest point is, how fast it goes.
#pragma once

#include <cstddef>
#include <vector>

#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

/// Of a problem's moving obstacles and the disc of a PlaneSpace, which outlives it. Immutable.
class Movers {
 public:
  /// `beside`: m kept from what moves over what is required.
  Movers(const PlaneSpace& space, double beside);

  std::size_t size() const { return obstacles_.size(); }
  const MovingObstacle& obstacle(std::size_t i) const { return obstacles_[i]; }

  struct Near {
    double gap = 0.0;  ///< m that lie between the two beyond what is kept, wherever within its spread the obstacle is; negative: too near
    Vec2 point{};      ///< its outline's nearest point as predicted
  };
  /// Where the gap is over `cap` it may be told as any number over that.
  Near at(std::size_t i, Vec2 disc, double t, double cap) const;
  double gap(std::size_t i, Vec2 disc, double t, double cap) const { return at(i, disc, t, cap).gap; }

  Vec2 velocity(std::size_t i, double t) const;  ///< m/s, of its frame at a time
  /// Does it stay as it is from `t` on, for so many seconds? (Its spread may grow.)
  bool stands(std::size_t i, double t, double seconds) const;
  /// A convex polygon about it as predicted for a time, `room` m and its spread wider, and as much as the disc keeps from it more than from what stands.
  Ring outline(std::size_t i, double t, double room) const;

 private:
  const std::vector<MovingObstacle>& obstacles_;
  std::vector<double> radii_;
  double kept_, beside_;
};

}  // namespace waywright
