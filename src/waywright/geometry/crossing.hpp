// Do edges of a ring meet where they should not?
#pragma once

#include <optional>
#include <string>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

/// A sentence about two edges that cross or touch (neighbours share a corner); empty where there are none.
/// Boxes about runs of edges keep the work far below the square of their number; outlines too entangled for
/// that are refused in a sentence, too.
/// @pre at least 3 corners, neighbours different
std::optional<std::string> find_crossing(const Ring& ring);

}  // namespace waywright
