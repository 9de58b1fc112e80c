// What each planner of this folder tells of its field to those who draw it. All hold by value what they need but the problem.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "waywright/judge/field_picture.hpp"
#include "waywright/planner/field/harmonic.hpp"
#include "waywright/planner/field/potential.hpp"
#include "waywright/planner/field/sphere_world.hpp"
#include "waywright/planner/field/star_world.hpp"
#include "waywright/planner/field/tree_world.hpp"
#include "waywright/planner/field/wavefront.hpp"

namespace waywright {

using SharedDrawing = std::shared_ptr<const FieldDrawing>;

/// `trap`: where the run was trapped. Critical points are found from the slope.
SharedDrawing potential_drawing(const PotentialOptions& options, Vec2 goal, std::optional<Vec2> trap);
/// Critical points are those of critical_points(), for the stars where the map takes them from.
SharedDrawing navigation_drawing(const SphereWorld& world, Vec2 goal, double kappa, std::optional<Vec2> trap);
SharedDrawing star_drawing(const StarWorld& world, Vec2 goal, double lambda, double kappa, std::optional<Vec2> trap);
SharedDrawing tree_drawing(std::shared_ptr<const TreeMap> map, Vec2 goal, double kappa, std::optional<Vec2> trap);
/// Moves to the goal; there is no minimum but it.
SharedDrawing wavefront_drawing(const GridFrame& frame, Wavefront front, Neighbours neighbours);
/// −ln w.
SharedDrawing harmonic_drawing(std::shared_ptr<const HarmonicField> field);

/// Where the map takes critical points of the model from. In the order of critical_points(); those that Newton's method does not find are left out.
std::vector<FieldPicture::Critical> critical_places(const StarNavigation& navigation, const StarWorld& world);

}  // namespace waywright
