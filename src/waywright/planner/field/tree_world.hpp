// A world of trees of stars, and the map of it to a world of discs: leaves drawn in one after another, then stars made to discs one after another.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "waywright/core/result.hpp"
#include "waywright/planner/field/star_rounding.hpp"
#include "waywright/planner/field/star_trees.hpp"

namespace waywright {

/// Laws: one to one and without folds, whatever the shapes (each step is); the rims of obstacles and boundary go to circles; `back` undoes it. At bends of a rim its
/// derivative jumps, as does that of stars with corners.
class TreeMap {
 public:
  /// The failure says what could not be cut or drawn in.
  /// @pre all simple, counter-clockwise, without straight corners; obstacles inside the outside's ring and apart from it and from each other
  static tl::expected<TreeMap, std::string> of(const Ring& outside, const std::vector<Ring>& obstacles, const std::function<bool()>& stops = {});

  const SphereWorld& model() const { return model_; }
  const std::vector<LeafPurge>& leaves() const { return leaves_; }
  const std::vector<StarRounding>& stars() const { return stars_; }
  const std::vector<Ring>& rims() const { return rims_; }  ///< the boundary's first

  PlaneImage at(Vec2 q) const;
  Vec2 back(Vec2 q) const;
  /// Inside the boundary and outside of the obstacles.
  bool is_free(Vec2 q) const;
  /// Does the line between two free places meet no rim?
  bool is_free(Vec2 from, Vec2 to) const;
  /// m, to the nearest rim; 0 where it is not free.
  double distance_to_rim(Vec2 q) const;

 private:
  TreeMap() = default;
  std::vector<LeafPurge> leaves_;
  std::vector<StarRounding> stars_;
  SphereWorld model_;
  std::vector<Ring> rims_;
};

/// The navigation function of the model, seen through the map.
class TreeNavigation {
 public:
  TreeNavigation(const TreeMap& map, Vec2 goal, double kappa) : map_{&map}, goal_{goal}, function_{map.model(), map.at(goal).at, kappa} {}

  const NavigationFunction& function() const { return function_; }
  double value(Vec2 q) const { return map_->is_free(q) ? function_.value(map_->at(q).at) : 1.0; }
  /// Jᵀ·slope of the model's.
  Vec2 slope(Vec2 q) const;
  /// Where the model's way goes on from there, seen back: it has no bends where the map has them. No longer than `longest`, and along a line that is
  /// free; the place itself where nothing leads on.
  Vec2 next(Vec2 q, double longest) const;
  /// The direction in which the model's slope leaves a saddle, seen back; empty where the place is near none.
  std::optional<Vec2> way_off(Vec2 q) const;
  /// The model's minimum, seen back, that Newton's method comes to in the model no farther off than `within` (m) is there.
  std::optional<Vec2> minimum_near(Vec2 q, double within) const;

 private:
  const TreeMap* map_;
  Vec2 goal_;
  NavigationFunction function_;
};

}  // namespace waywright
