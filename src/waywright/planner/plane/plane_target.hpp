// Where a way in the plane is to end.
#pragma once

#include "waywright/scenario/problem.hpp"

namespace waywright {

/// At a point, or anywhere in a polygon.
struct PlaneTarget {
  Ring area;  ///< one point, or a simple polygon, counter-clockwise

  bool is_point() const { return area.size() == 1; }
  Vec2 nearest(Vec2 to) const { return is_point() ? area.front() : nearest_in(area, to); }
};

/// The problem's goal; `at` stands for a goal that is a pose or a point.
inline PlaneTarget target_of(const Problem& problem, Vec2 at) {
  const FreeGoal* free = problem.free_goal();
  return free != nullptr && !free->is_point() ? PlaneTarget{free->area} : PlaneTarget{{at}};
}

}  // namespace waywright
