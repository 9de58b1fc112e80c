// Cells of a clearance field that lie within something solid, whole.
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/map/clearance_field.hpp"

namespace waywright {

/// Of each cell how many cells deep it surely is: 0 where some of it may be free; k: so are all cells that are fewer than k cells away, across corners, too, 200 at most.
/// Row-major, columns() a row. Cells that an edge touches are 0; of the others all is as their middle is. @pre the field is that of the world
std::vector<std::uint8_t> blocked_cells(const World& world, const ClearanceField& field);

}  // namespace waywright
