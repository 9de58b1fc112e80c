// Moving the ends of curves: what is left of a path, before and after its ends are carried along.
#pragma once

#include <algorithm>
#include <optional>

#include "waywright/path/path.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// The motion that takes one pose to another.
class Shift {
 public:
  Shift(const Pose& from, const Pose& to) : from_{from}, to_{to} {}
  /// Moves a point; keeps by how far in `farthest`.
  void move(Vec2& p, double& farthest) const {
    const Vec2 moved = to_.to_world(from_.to_local(p));
    farthest = std::max(farthest, distance(p, moved));
    p = moved;
  }

 private:
  Frame from_, to_;
};

struct CarriedRest {
  Path before;            ///< what is left, without the way into the shelf
  Path carried;           ///< its ends at the problem's first pose, with its curvature, and at the goal
  double farthest = 0.0;  ///< m, the farthest that a control point was moved
};

/// Empty where that cannot be (continuation.hpp).
std::optional<CarriedRest> pattern_left(const Problem& problem, const Path& old, double driven);

}  // namespace waywright
