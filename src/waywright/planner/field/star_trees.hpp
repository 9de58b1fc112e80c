// Obstacles of any shape, and a boundary of any shape, as trees of stars: cut into convex pieces, of which all but a star in the middle are drawn in, leaf by leaf.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/planner/field/leaf_purge.hpp"

namespace waywright {

struct StarTrees {
  std::vector<LeafPurge> purges;  ///< one after another: each leaves alone all but the free space next to its leaf
  Ring outside;                   ///< what is left of the boundary: star-shaped
  std::vector<Ring> stars;        ///< what is left of the obstacles, in their order: star-shaped
  std::size_t pieces = 0;         ///< convex ones that all were cut into
};

/// The lines along which a leaf is drawn in are chosen, at each end of its cut, among a few; of all leaves the one that shears least comes next.
/// The failure says what could not be cut or drawn in. `stops`, asked again and again, ends it early.
/// @pre all simple, counter-clockwise, without straight corners; obstacles inside the outside's ring and apart from it and from each other
tl::expected<StarTrees, std::string> star_trees(const Ring& outside, const std::vector<Ring>& obstacles, const std::function<bool()>& stops = {});

}  // namespace waywright
