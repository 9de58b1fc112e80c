#include "waywright/scenario/outline.hpp"

#include "waywright/core/elementary.hpp"

namespace waywright {

Ring polygon_around(const Footprint& footprint) {
  if (!footprint.is_disc()) return footprint.polygon;
  constexpr int corners = 32;
  Ring ring;
  const double outer = footprint.disc / sin_cos(pi / 2 - pi / corners).sin;
  for (int i = 0; i < corners; ++i) ring.push_back(outer * unit(2.0 * pi * i / corners));
  return ring;
}

}  // namespace waywright
