// Planner `pattern_docking_published`: the publication's method as printed and corrected, for comparison and reproduction.
//
// Natural cubic splines through four waypoints each, sampled every 0.05 m; footprint tested at the samples; cost B or A with
// knock-outs; transition point searched on each side. Its paths miss the wanted headings by some degrees (natural ends) and
// nothing holds between the samples: they are judged as they are.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "waywright/planner/docking/pattern_docking.hpp"

namespace waywright {

struct PublishedDockingOptions {
  std::int64_t evaluations = 300;  ///< candidates per side (population 20 × 15 generations)
  int population = 20;
  double segment = 0.05;           ///< m, distance of samples (kSegmentLength)
  double curvature_factor = 10.0;  ///< knock-out factor on cc where |κ| exceeds the limit
  double least_side = 1.5;         ///< m, a side whose extent across is under this is dropped
  DockingWeights weights;
  DockingObjective objective = DockingObjective::normalised;
  SideChoice sides = SideChoice::both;
};

/// Samples at equal arc length: n = max(1, round(L / segment)) steps of each spline, both ends included (Algorithm 2,
/// corrected). Directions −1 and +1.
std::vector<Sample> published_samples(const std::array<Spline, 2>& splines, double segment);

/// Algorithm 3, corrected: cost of samples against a reference. A footprint hit returns 1000 + share of poses hit.
struct PublishedScore {
  PathMeasures measures;
  double cost = 0.0;
  double objective = 0.0;  ///< the cost without knock-outs
  double violation = 0.0;  ///< share of poses that touch, and of the curvature over its limit
  std::size_t hits = 0;  ///< poses whose footprint touches
  bool within_curvature = true;
  std::optional<Contact> contact;  ///< of the first hit
  bool feasible() const { return hits == 0 && within_curvature; }
};
PublishedScore published_evaluation(const Problem& problem, const std::vector<Sample>& samples,
                                    const PathMeasures& reference, const PublishedDockingOptions& options);

/// The reference path of a side: transition at (4.0, ±3.5) m in the shelf's frame.
PathMeasures published_reference(const Problem& problem, const DockingTask& task, Side side, double segment);

class PublishedDockingPlanner {
 public:
  PublishedDockingPlanner(PublishedDockingOptions options, std::shared_ptr<const Optimizer> optimizer, std::uint64_t seed);
  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return "pattern_docking_published"; }

 private:
  PublishedDockingOptions options_;
  std::shared_ptr<const Optimizer> optimizer_;
  std::uint64_t seed_;
};

}  // namespace waywright
