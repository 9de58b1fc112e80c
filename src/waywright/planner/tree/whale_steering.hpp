// Steering of the RRT*-WOA publication's local variant: the whale optimisation algorithm looks around a sample for where the tree sees the goal.
#pragma once

#include <vector>

#include "waywright/optimizer/whale_step.hpp"
#include "waywright/planner/plane/shadow.hpp"
#include "waywright/planner/tree/plane_tree.hpp"

namespace waywright {

/// The publication names four terms and gives neither formula nor weights; these are reconstructed:
///   f(x) = w_r |x − sample| / R + w_g |x − goal| / D + w_n [line from `near` is not free] + w_v [line to the goal is not free] + 10 [x is not free],
/// D the region's diagonal. To the goal alone: w_r = 0; growth at random: w_g = 0.
struct WhaleSteeringOptions {
  int population = 10;
  int iterations = 10;
  double radius = 2.5;  ///< m, of the disc around the sample that is searched [R]
  double sample_weight = 0.2, goal_weight = 1.0, near_weight = 4.0, view_weight = 2.0;
  WhaleParameters whale{};
};

class WhaleSteering final : public TreeSteering {
 public:
  WhaleSteering(const PlaneSpace& space, const WhaleSteeringOptions& options);
  Vec2 aim(Vec2 near, Vec2 sample, Vec2 goal, Random& random) override;

  std::int64_t evaluations() const { return evaluations_; }
  std::int64_t lines() const { return lines_; }  ///< whose freedom was asked for

  /// The cost of a place, whole.
  double cost(Vec2 x, Vec2 near, Vec2 sample, Vec2 goal) const;

 private:
  struct Best {
    Vec2 at{};
    double cost = 0.0;
  };
  void look(Vec2 x, Vec2 near, Vec2 sample, Vec2 goal, Best& best);
  Vec2 into_disc(Vec2 x, Vec2 middle) const;

  const PlaneSpace& space_;
  WhaleSteeringOptions options_;
  double per_radius_, per_diagonal_;
  Shadow shadow_;  // of the goal, where it stays the same from one extension to the next
  Vec2 last_goal_{};
  bool has_goal_ = false;
  std::vector<Vec2> agents_;
  std::int64_t evaluations_ = 0, lines_ = 0;
};

}  // namespace waywright
