// The probabilistic roadmap of a disc: free places drawn at random, and which are near enough to be joined by a straight line.
//
// Sources: L. E. Kavraki, P. Švestka, J.-C. Latombe, M. H. Overmars: Probabilistic roadmaps for path planning in high-dimensional configuration spaces, IEEE TRA 12 (1996);
// S. Karaman, E. Frazzoli: Sampling-based algorithms for optimal motion planning, IJRR 30 (2011) (PRM*, the radius); R. Bohlin, L. E. Kavraki: Path planning using lazy
// PRM, ICRA 2000 (lines are tested when a search wants them).
#pragma once

#include <cstdint>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/planner/plane/plane_space.hpp"
#include "waywright/planner/plane/plane_target.hpp"
#include "waywright/planner/plane/point_bins.hpp"
#include "waywright/planner/roadmap/lazy_search.hpp"

namespace waywright {

struct RoadmapOptions {
  std::int64_t samples = 1000;
  double radius = 0.0;    ///< m, places so near are neighbours; 0: the proven one of PRM*
  int neighbours = 0;     ///< so many nearest ones are instead; 0: those within the radius
};

using RoadmapAnswer = LazyAnswer<Vec2>;

/// Immutable once grown; queries may run on many threads. The space outlives it.
///
/// Laws: places are free and depend on the space, the seed and their number alone: those of fewer samples are the first ones of more. A query's way is a shortest one among
/// all whose lines are free and join neighbours, or start and goal, whatever was tested in which order. With the proven radius its length tends to that of the shortest way with the samples.
class ProbabilisticRoadmap {
 public:
  static constexpr std::int64_t most_samples = 100'000;
  static constexpr std::size_t most_waiting = 20'000'000;  ///< lines that a search keeps in mind; it ends crowded where there are more

  /// Ends early, with what there is by then, where the budget's clock or flag says so.
  ProbabilisticRoadmap(const PlaneSpace& space, const RoadmapOptions& options, std::uint64_t seed, Budget& budget);

  const RoadmapOptions& options() const { return options_; }
  std::size_t size() const { return places_.size(); }
  const std::vector<Vec2>& places() const { return places_; }
  double radius() const { return radius_; }  ///< m, within which places are neighbours; 0 where so many nearest ones are
  bool is_whole() const { return is_whole_; }  ///< all samples were drawn

  /// A* by length over lines that are tested when a search takes them, each once. @pre the start is free. At most so many lines are tested.
  RoadmapAnswer shortest(Vec2 start, const PlaneTarget& goal, Budget& budget, std::int64_t lines) const;
  /// Those whose line to place i is in the roadmap, if it is free; i itself is not among them.
  std::vector<std::uint32_t> neighbours_of(std::uint32_t i) const;
  /// The same of a place that is not in the roadmap; the nearest one where none is within the radius.
  std::vector<std::uint32_t> near(Vec2 at) const;
  /// The same of a goal.
  std::vector<std::uint32_t> near(const PlaneTarget& goal) const;

 private:
  bool draw(std::uint64_t seed, Budget& budget);
  bool join_nearest(Budget& budget);
  std::vector<std::uint32_t> nearest(Vec2 at, std::size_t count) const;
  std::vector<std::uint32_t> within_radius(Vec2 at, std::uint32_t without) const;

  const PlaneSpace& space_;
  RoadmapOptions options_;
  std::vector<Vec2> places_;
  PointBins bins_;  // of them
  double radius_ = 0.0;
  bool is_whole_ = false;
  std::vector<std::uint32_t> first_, joined_;  // of each place its neighbours, where so many nearest ones are; both ways
};

}  // namespace waywright
