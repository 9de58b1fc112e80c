// The lanes that a scenario was made along, as `meta.lanes` tells them: for sentences and pictures, no rules.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

struct LaneCourses {
  double width = 0.0;                  ///< m, of a lane; > 0 where it is told
  std::vector<Polyline> courses;       ///< world frame; two points each or more
  std::vector<std::uint8_t> one_way;   ///< of each course: 1 where it is driven along its points alone; 0 where both ways, or where that is not told
};

/// `meta`: JSON text of anybody's; whatever is no lane is left out.
LaneCourses lane_courses_of(const std::string& meta);

}  // namespace waywright
