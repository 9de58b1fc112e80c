// A ring covered by few discs: what is asked of a distance field instead of the ring itself.
#pragma once

#include <vector>

#include "waywright/geometry/polygon.hpp"

namespace waywright {

struct CoverDisc {
  Vec2 center{};
  double radius = 0.0;  ///< m
  double inner = 0.0;   ///< m, the disc of this radius about the centre lies inside the ring; 0 where there is none
};

/// Discs whose union holds the ring's area: the ring is cut across its longer side into equal slabs, each in its own disc, as few
/// as let no disc bulge sideways out of its slab's box by more than `bulge`, and at most `most`. @pre at least 3 corners, most ≥ 1
std::vector<CoverDisc> disc_cover(const Ring& ring, double bulge, int most);

}  // namespace waywright
