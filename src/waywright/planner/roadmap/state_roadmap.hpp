// The probabilistic roadmap of a footprint: free positions with headings drawn at random, and which are near enough to be joined by a motion.
//
// Sources: L. E. Kavraki, P. Švestka, J.-C. Latombe, M. H. Overmars: Probabilistic roadmaps for path planning in high-dimensional configuration spaces, IEEE TRA 12 (1996);
// P. Švestka, M. H. Overmars: Motion planning for carlike robots using a probabilistic learning approach, IJRR 16 (1997) (motions that lead one way alone); S. Karaman,
// E. Frazzoli: Sampling-based algorithms for optimal motion planning, IJRR 30 (2011) (k-nearest PRM*); R. Bohlin, L. E. Kavraki: Path planning using lazy PRM, ICRA 2000.
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/planner/roadmap/lazy_search.hpp"
#include "waywright/planner/roadmap/probabilistic_roadmap.hpp"
#include "waywright/planner/roadmap/state_planning.hpp"
#include "waywright/planner/steering/state_bins.hpp"

namespace waywright {

/// Immutable once grown; queries may run on many threads. The steering outlives it.
///
/// From each state motions lead to so many others as they cost least to, k = e (1 + 1/d) ln n with d = 3 (what is proven of that number, and for what, stands with StateTree),
/// or to as many as RoadmapOptions::neighbours says, or to all within `radius`, m of cost. Into the goal they lead from as many as they cost least from. Of motions that are the
/// same both ways a search may take each in the direction of either end.
///
/// Laws: states are free and depend on the query's world, the seed and their number alone: those of fewer samples are the first ones of more. A query's way costs least among
/// all whose motions are free and in the roadmap, whatever was tested in which order.
class StateRoadmap {
 public:
  /// Ends early, with what there is by then, where the budget's clock or flag says so.
  StateRoadmap(const StateQuery& query, const RoadmapOptions& options, std::uint64_t seed, Budget& budget);

  const RoadmapOptions& options() const { return options_; }
  std::size_t size() const { return bins_.size(); }
  const Pose& state(std::uint32_t i) const { return bins_[i]; }
  bool is_whole() const { return is_whole_; }  ///< all samples were drawn
  std::size_t neighbours() const { return neighbours_; }  ///< of each state; 0: those within the radius

  /// A* by cost. Motions are tested by the query's test.
  LazyAnswer<Pose> shortest(const StateQuery& query, Budget& budget) const;
  /// Where motions lead from a state, which may be in the roadmap or not; from a state to itself none does.
  std::vector<RoadmapNeighbour> from(const Pose& at) const;
  /// From where they lead to it.
  std::vector<RoadmapNeighbour> into(const Pose& at) const;

 private:
  std::vector<RoadmapNeighbour> near(const Pose& at, StateBins::Way way) const;

  RoadmapOptions options_;
  StateBins bins_;
  std::size_t neighbours_ = 0;
  bool is_whole_ = false;
};

}  // namespace waywright
