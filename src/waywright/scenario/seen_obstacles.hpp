// What appears while a plan is driven.
#pragma once

#include <vector>

#include "waywright/map/map.hpp"
#include "waywright/scenario/moving_obstacle.hpp"

namespace waywright {

/// What stays where it is has the map's form; times of what moves count from the moment of its being seen.
struct SeenObstacles {
  Map still;  ///< obstacles, lines and points alone, and notes of what was repaired
  std::vector<MovingObstacle> moving;
};

}  // namespace waywright
