// A global way as the local field sees it: where along it the vehicle is, what lies ahead, how much room the way has.
#pragma once

#include <vector>

#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

/// A way of the disc of a PlaneSpace, as points no more than a decimetre apart. Immutable.
class WayAhead {
 public:
  /// `cap`: m; room beyond it is not told. @pre at least one point
  WayAhead(const PlaneSpace& space, const std::vector<Vec2>& points, double cap);

  double length() const { return s_.back(); }
  Vec2 end() const { return points_.back(); }
  Vec2 at(double s) const;
  /// m along it to the place nearest to a point, of those between two such.
  double nearest(Vec2 point, double from, double to) const;
  /// m, the least distance over what is required that the disc keeps from what stands, between two places.
  double room(double from, double to) const;
  const std::vector<Vec2>& points() const { return points_; }

 private:
  std::size_t index(double s) const;  ///< of the last point at or before s

  std::vector<Vec2> points_;
  std::vector<double> s_, room_;
};

}  // namespace waywright
