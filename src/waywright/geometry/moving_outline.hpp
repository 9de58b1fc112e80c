// An outline that moves: what does not change with its place is worked out once.
#pragma once

#include "waywright/core/pose.hpp"
#include "waywright/geometry/obstacle_index.hpp"

namespace waywright {

class MovingOutline {
 public:
  /// Corners in the body frame; one is a point. @pre not empty
  explicit MovingOutline(std::span<const Vec2> corners);
  MovingOutline(const MovingOutline&) = delete;  // what is placed points at its own corners
  MovingOutline& operator=(const MovingOutline&) = delete;

  /// Puts it there; sin and cos are those of the pose's heading.
  void place(const Pose& pose, double sin, double cos);

  /// As if nothing had been asked.
  void forget() { nearest_ = segment_lanes::none; }

  std::span<const Vec2> ring() const { return world_; }  ///< as placed last
  /// As `index.distance(ring(), limit)`, up to rounding of the coordinates. @pre the same index each time
  double distance(const ObstacleIndex& index, double limit) { return index.distance(placed_, limit, nearest_); }

 private:
  std::vector<Vec2> body_, world_;
  std::vector<segment_lanes::Edge> edges_;  // in the body frame, as many as are made beforehand and looked at
  segment_lanes::Outline placed_;
  std::uint32_t nearest_ = segment_lanes::none;  // segment, where it was asked last
};

}  // namespace waywright
