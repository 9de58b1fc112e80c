// Ways down navigation functions: of a world of discs, of stars through the published map, of trees of stars.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "waywright/planner/field/field_drawings.hpp"
#include "waywright/planner/field/navigation_descent.hpp"
#include "waywright/planner/field/star_world_of.hpp"

namespace waywright {

struct NavigationOptions {
  double kappa = 0.0;   ///< 0: of those that are shown to lead to the goal
  double lambda = 0.0;  ///< of the map from stars to discs; 0: the least that is shown not to fold
  NavigationSteps steps{};
};

/// Where it was led to, and what there is to say of it.
struct NavigationWay {
  FollowedWay way;
  double keeps = 0.0;  ///< m beyond what is needed, that arcs at its corners leave
  std::vector<std::string> text;
  std::function<SharedDrawing(std::optional<Vec2> trap)> drawn;  ///< the field, with the trap that it ended in
};

NavigationWay way_among_discs(const NavigationOptions& options, const SphereWorld& world, Vec2 start, Vec2 goal, Budget& budget);

/// Of stars that are apart. Where all are convex, or a λ is told, down the published map, and as trees of stars, whose map cannot fold, where that does not lead to the goal,
/// or (no λ told) by a detour that is more than a tenth longer than theirs; others as trees, and down the published map where these do not serve. The text says why the other was taken.
NavigationWay way_among_stars(const NavigationOptions& options, const PlaneSpace& space, const StarWorld& world, Vec2 start, Vec2 goal, Budget& budget);

/// Leaves are drawn in to next to nothing, so that the model's ways pass close to them: where there is room, all is taken as larger than it need be, as long as that makes
/// the way no more than a tenth longer. `needed`: with nothing larger than that.
NavigationWay way_among_trees(const NavigationOptions& options, const PlaneSpace& space, const TreeMap& needed, Vec2 start, Vec2 goal, Budget& budget);

}  // namespace waywright
