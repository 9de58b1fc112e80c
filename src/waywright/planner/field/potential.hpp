// The artificial potential field: attraction by the goal, repulsion by each obstacle nearer than its reach.
//
// Source: the navigation-field publication, (3.1)–(3.4); O. Khatib: Real-time obstacle avoidance for manipulators and mobile robots, IJRR 5 (1986).
#pragma once

#include <optional>
#include <vector>

#include "waywright/planner/plane/plane_space.hpp"

namespace waywright {

struct PotentialOptions {
  double attraction = 1.0;  ///< k_a, 1/s where the potential's slope is a speed
  double conic_from = 1.0;  ///< d, m: nearer to the goal the attraction grows evenly with the distance, farther off it stays
  double repulsion = 0.1;   ///< k_r, m⁴/s
  double reach = 0.8;       ///< ρ₀, m: obstacles farther off do not repel
  bool repels_walls = true; ///< the boundary, too
  bool reaches_goal = false;  ///< the repulsion is weighed by the squared distance to the goal, so that one beside an obstacle can be reached (GNRON)
};

/// Of a disc: distances are between obstacles and what the disc needs around its middle. Every polygon and boundary repels for itself, walls, scan points and cells
/// together by what is nearest of them. Immutable; the space outlives it.
class PotentialField {
 public:
  PotentialField(const PlaneSpace& space, const PotentialOptions& options, Vec2 goal) : space_{space}, options_{options}, goal_{goal} {}

  struct Value {
    double potential = 0.0;  ///< m²/s
    Vec2 gradient{};         ///< m/s
    double distance = 0.0;   ///< ρ, m: to the nearest of what repels; +∞ where nothing is in reach
  };
  /// Empty where the disc cannot stand. The gradient is that of the potential wherever nothing changes which obstacle point is nearest.
  std::optional<Value> at(Vec2 q) const;

 private:
  struct Obstacle {
    std::size_t source;
    double distance;
    Vec2 point;
  };
  std::vector<Obstacle> in_reach(Vec2 q) const;

  const PlaneSpace& space_;
  PotentialOptions options_;
  Vec2 goal_;
};

}  // namespace waywright
