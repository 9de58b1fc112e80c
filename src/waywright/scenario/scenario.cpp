#include "waywright/scenario/scenario.hpp"

namespace waywright {

Ring Shelf::outline() const {
  return transformed(rectangle({-0.5 * depth, -0.5 * width}, {0.5 * depth, 0.5 * width}),
                     Frame{make_pose(center, heading)});
}

Pose Shelf::docked(double front) const {
  return make_pose(face().to_world(Vec2{gap + front, slot}), wrap(heading + pi));
}

}  // namespace waywright
