// Lower bounds on what a docking pattern can cost, and proof that it collides, for a whole box of transition points and headings at once.
//
// The tangent length of our quintics is m(α, β) times the chord's length, α and β being the angles of the end courses from the chord. Over a
// box, the chord, its direction, the courses and m stay within bounds about their values at the box's middle: |Δm| from the greatest slope of
// m's formula, the rest from geometry. So any p(u), p′(u), p″(u) is within a known distance of the one at the middle, and
//  * the length is at least the chords between some points of the middle curve, each shorter by what its ends can move;
//  * the change of curvature is at least the differences between its extremes, as far as the intervals in which these curvatures lie are
//    apart (any samples bound a total variation from below);
//  * where a disc inside of the footprint is deeper in an obstacle than it can move, every pattern of the box collides.
#pragma once

#include "waywright/planner/docking/pattern.hpp"
#include "waywright/planner/docking/prepared.hpp"

namespace waywright {

/// A box of decision variables: transition point in the shelf's frame, heading offset.
struct TransitionBox {
  Vec2 low{}, high{};
  double offset_low = 0.0, offset_high = 0.0;  ///< rad
};

struct PatternBound {
  double length = 0.0;            ///< m, straight runs included
  double curvature_change = 0.0;  ///< 1/m
};

class PatternBounds {
 public:
  /// @pre `prepared` outlives this
  PatternBounds(const PreparedDocking& prepared, Side side, const PatternLeads& leads);

  /// Law: no pattern of the box is shorter or changes its curvature less.
  PatternBound over(const TransitionBox& box) const;
  /// Law: where true, every pattern of the box comes nearer to something than the required clearance.
  bool all_collide(const TransitionBox& box) const;

 private:
  struct Family;
  std::array<Family, 2> families_of(const TransitionBox& box) const;

  const PreparedDocking& prepared_;
  Placement start_, dock_;  ///< in the shelf's frame
  Side side_;
  PatternLeads leads_;
};

}  // namespace waywright
