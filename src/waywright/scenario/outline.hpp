// A footprint as a polygon, whatever its form.
#pragma once

#include "waywright/vehicle/vehicle.hpp"

namespace waywright {

/// The polygon itself; of a disc one of 32 corners around it, so never less.
Ring polygon_around(const Footprint& footprint);

}  // namespace waywright
