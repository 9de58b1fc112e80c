// How far poses of a trajectory are from the map's objects, as the waypoint publication measures it and exactly.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "waywright/map/clearance_along.hpp"
#include "waywright/objective/fitness.hpp"
#include "waywright/scenario/problem.hpp"

namespace waywright {

/// The objects of a problem's world: obstacles, the inside of which is occupied; the boundary, the outside of which is; grids, walls and scan points.
class MapObjects {
 public:
  explicit MapObjects(const Problem& problem);  ///< which outlives this

  /// Published: least distance of the footprint's corners (a disc: its centre, less the radius) from the objects' edges, and how deep corners are in
  /// them. Corrected: exact distance of the whole footprint; depth also of the objects' corners in the footprint, at least 1 µm on contact.
  /// Fills all but the length. `greatest` costs as much as all objects: only where wanted. For one thread at a time: memory is kept.
  void measure(std::span<const Pose> poses, FitnessForm form, bool wants_greatest, TrajectoryMeasures& measures);

  /// m, depth of a footprint that touches something. @pre it does
  double depth_of(const Pose& pose) const;

  /// Half the diagonal of the map, m; of nothing: 1.
  double reference() const { return reference_; }

 private:
  struct Object {
    std::vector<Segment> edges;
    Box box;
    bool is_solid = false;     ///< the inside of its ring is occupied
    bool is_boundary = false;  ///< the outside is
  };
  struct Corner {
    double distance, depth;
  };
  double corner_depth(Vec2 corner) const;
  Corner corner_against(const Object& object, Vec2 corner) const;
  void measure_corners(const Pose& pose, bool wants_greatest, TrajectoryMeasures& measures) const;

  const Problem& problem_;
  std::vector<Object> objects_;
  std::vector<Vec2> corners_;  ///< of the footprint, body frame
  Box body_;                   ///< about them, and a little more
  double radius_ = 0.0;        ///< of a disc
  double reference_ = 1.0;
  std::unique_ptr<ClearanceAlong> along_;
};

}  // namespace waywright
