// The multi-objective fitness of the safe-A* publication, (27): f = k₁L + k₂R + k₃T + k₄A − k₅E, and 1000 for each colliding sample.
#pragma once

#include <span>
#include <vector>

#include "waywright/scenario/problem.hpp"

namespace waywright {

/// What a sampled curve is like.
struct SplineMeasures {
  double length = 0.0;   ///< L (16), m
  double risk = 0.0;     ///< R (17): Σ over samples and obstacles within R₁ of exp(−½ (d/2)), C = 1 as published
  double time = 0.0;     ///< T (18), s, at the vehicle's speed
  double turning = 0.0;  ///< A (19), rad
  double energy = 0.0;   ///< E (20), percent that are left, with no changes of speed
  int collisions = 0;    ///< samples whose footprint touches something
};

struct SplineWeights {
  double length = 1.0, risk = 100.0, time = 0.94, turning = 16.76, energy = 0.69;  ///< the publication's, of CAPSO
};
inline constexpr SplineWeights weights_of_ga{1.0, 100.0, 0.97, 10.36, 0.75};

inline constexpr double collision_penalty = 1000.0;

double fitness_of(const SplineMeasures& measures, const SplineWeights& weights);

/// The publication's normalisation, of extrema that single-objective searches found: k = L_min over the extremum. Where that is over 100, or the extremum is
/// not positive, 100, as the publication has for a risk of 0.
SplineWeights normalised_weights(double least_length, double least_risk, double least_time, double least_turning, double greatest_energy);

/// Measures of one problem's curves. Obstacles of the risk: the centres of occupied cells of grids; obstacles, boundaries and walls by their nearest edge;
/// scan points. R₁ is 1.5 times the footprint's radius.
class SplineMeasurer {
 public:
  explicit SplineMeasurer(const Problem& problem);  ///< which outlives this
  SplineMeasures measure(std::span<const Pose> poses) const;
  double risk_at(Vec2 point) const;

 private:
  struct Outline {
    std::vector<Vec2> points;
    bool is_closed;
    Box box;
  };
  const Problem& problem_;
  double within_;  // R₁, m
  std::vector<Outline> outlines_;
};

}  // namespace waywright
