// A star made to a disc, with the free space about it: the last step of the way from trees of stars to discs.
#pragma once

#include <vector>

#include "waywright/planner/field/leaf_purge.hpp"
#include "waywright/planner/field/sphere_world.hpp"
#include "waywright/planner/field/star.hpp"

namespace waywright {

/// Along each ray from the star's centre, what lies between its rim ρ and the collar's end R, R² = ρ² + room², is stretched (or pressed) to between the disc's radius and R.
/// Of a boundary, which is bent from inside, R² = ρ² − room².
///
/// Laws: the identity beyond the collar; one to one and without folds (det J > 0); the star's rim goes to the disc's.
class StarRounding {
 public:
  /// Of the farthest collar that comes to none of `others` by less than a part of the way, or as wide as the star is; its disc's radius lies midway between the least that the
  /// star holds and the least of the collar. @pre star-shaped about the centre; others apart from it, rims of closed lines
  StarRounding(const Ring& star, Vec2 centre, bool is_boundary, const std::vector<Ring>& others);

  const Disc& disc() const { return disc_; }
  double room() const { return room_; }  ///< m
  PlaneImage at(Vec2 q) const;
  Vec2 back(Vec2 q) const;
  /// In the star or on its rim; of a boundary, beyond it.
  bool holds(Vec2 q) const;

 private:
  Star star_;
  bool is_boundary_;
  double room_ = 0.0;
  Disc disc_;
};

}  // namespace waywright
