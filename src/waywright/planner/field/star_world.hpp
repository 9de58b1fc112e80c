// A world of stars, and the smooth map that takes it to a world of discs.
//
// Source: the navigation-field publication, §4.3, (4.10); E. Rimon, D. E. Koditschek: The construction of analytic diffeomorphisms for exact robot navigation on star
// worlds, Trans. AMS 327 (1991).
#pragma once

#include <functional>
#include <vector>

#include "waywright/planner/field/leaf_purge.hpp"
#include "waywright/planner/field/sphere_world.hpp"
#include "waywright/planner/field/star.hpp"

namespace waywright {

struct StarWorld {
  Star outside;                 ///< what is free lies within
  std::vector<Star> obstacles;  ///< apart from each other and from the outside's rim
};

/// h(q) = q + Σ σᵢ (Tᵢ(q) − q): next to star i, where σᵢ is 1, the map Tᵢ that takes its rim to a circle about its centre; at the goal and far from all rims hardly
/// more than q itself. The circles are the largest that the stars hold; the outer one the smallest around the boundary.
class StarMap {
 public:
  /// λ > 0: the greater, the nearer to its rim each star bends the map; too small, the map folds.
  StarMap(const StarWorld& world, Vec2 goal, double lambda);

  const SphereWorld& model() const { return model_; }
  double lambda() const { return lambda_; }

  using Image = PlaneImage;
  Image at(Vec2 q) const;

  bool is_free(Vec2 q) const;

 private:
  StarWorld world_;
  SphereWorld model_;
  Vec2 goal_;
  double lambda_;
};

/// The least of 10², 10³ … 10¹² with which the map does not fold at any of `side` × `side` places; 10¹² where it does with all (`is_shown` is false then).
struct ChosenLambda {
  double lambda = 0.0;
  bool is_shown = false;
};
ChosenLambda choose_lambda(const StarWorld& world, Vec2 goal, int side = 140, const std::function<bool()>& stops = {});

/// The navigation function of the model, seen through the map.
class StarNavigation {
 public:
  StarNavigation(const StarWorld& world, Vec2 goal, double lambda, double kappa) : map_{world, goal, lambda}, function_{map_.model(), map_.at(goal).at, kappa} {}

  const StarMap& map() const { return map_; }
  const NavigationFunction& function() const { return function_; }
  double value(Vec2 q) const { return map_.is_free(q) ? function_.value(map_.at(q).at) : 1.0; }
  /// Jᵀ·slope of the model's: that of the logarithm of a rising function of φ. 1/m. At a free place that is not the goal.
  Vec2 slope(Vec2 q) const;

 private:
  StarMap map_;
  NavigationFunction function_;
};

}  // namespace waywright
