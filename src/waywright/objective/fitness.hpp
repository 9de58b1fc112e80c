// The fitness functions of the waypoint publication, each as it was published and corrected. All are minimised. They look at a trajectory through a
// number of sampled poses: how far each is from the obstacles, and how deep in one.
//
// Lengths are in metres here; the functions evaluate in millimetres, as published.
#pragma once

#include <string_view>
#include <vector>

namespace waywright {

enum class Fitness {
  mlpc,    ///< least length, a knock-out factor on contact
  mlmc,    ///< the same, times the number of poses in contact
  mdobs,   ///< one over the least distance
  avgmd,   ///< one over the mean distance
  pwavg,   ///< piecewise average: depth in obstacles, else mean distance
  levels,  ///< two-level safety: how many poses have something within a first and a second distance
};

/// How distances of a pose are taken, and which form of a function is evaluated.
enum class FitnessForm {
  published,  ///< corners of the footprint only; formulas as printed, where they have a meaning
  corrected,  ///< the whole footprint; formulas corrected
};

/// What the sampled poses of a trajectory are like. Metres.
struct TrajectoryMeasures {
  double length = 0.0;
  std::vector<double> distance;  ///< D_i: of each pose to the nearest obstacle, 0 where it touches one
  std::vector<double> depth;     ///< Dc_i: how deep each pose is in an obstacle, 0 where it touches none
  double greatest = 0.0;         ///< greatest distance of any corner of any pose to any obstacle
  double reference = 1.0;        ///< of the map: half its diagonal, > 0
};

/// Not published for the two-level function (reconstructed), and of the knock-out.
struct FitnessWeights {
  double collision = 1000.0;            ///< C_c
  double first_level = 0.150;           ///< m
  double second_level = 0.400;          ///< m
  double first_weight = 0.25;
  double second_weight = 0.10;
};

/// Source: docs/waypoints.md has the formulas. @pre distance and depth have one element a pose, at least one
double fitness_of(Fitness fitness, FitnessForm form, const TrajectoryMeasures& measures, const FitnessWeights& weights = {});

/// The corrected piecewise average, where a path counts as free only with a least distance of `margin` (m, > 0): others are at least 1.
double fitness_with_margin(const TrajectoryMeasures& measures, double margin);

int poses_in_contact(const TrajectoryMeasures& measures);
double least_distance(const TrajectoryMeasures& measures);
double mean_distance(const TrajectoryMeasures& measures);

}  // namespace waywright
