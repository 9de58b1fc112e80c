// Whether a region has a place for the vehicle at all.
#pragma once

#include <optional>

#include "waywright/core/result.hpp"
#include "waywright/map/world.hpp"

namespace waywright {

/// Set where it is certain that a disc of `radius` about no place of the region keeps `required` from everything: goal_outside where all that stops it
/// are borders, goal_in_collision else, with the names of what does. Found by halving boxes: a box is blocked where its middle lies deeper in
/// something solid than the box reaches, or an edge is so near that the disc is too near to it all over the box. Empty where a place is free, or where
/// the work that is allowed does not decide it. @pre the region has at least 3 corners; radius, required ≥ 0, m
std::optional<Failure> blocked_region(const World& world, const Ring& region, double radius, double required);

}  // namespace waywright
