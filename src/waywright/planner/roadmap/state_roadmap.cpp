#include "waywright/planner/roadmap/state_roadmap.hpp"

#include "waywright/core/random.hpp"
#include "waywright/planner/plane/proven_radius.hpp"

namespace waywright {
namespace {

constexpr int clock_every = 32;  // samples

/// What the search sees of roadmap, ends and motions.
class Graph {
 public:
  using Place = Pose;
  Graph(const StateRoadmap& roadmap, const StateQuery& query) : roadmap_{roadmap}, query_{query} {}

  std::uint32_t count() const { return static_cast<std::uint32_t>(roadmap_.size()); }
  const Pose& place(std::uint32_t i) const { return roadmap_.state(i); }
  const Pose& start() const { return query_.start; }
  const Pose& goal_from(const Pose&) const { return query_.goal; }
  double cost(const Pose& from, const Pose& to) const { return query_.steering.distance(from, to); }
  double least(const Pose& at) const { return query_.steering.least(at, query_.goal); }
  bool is_free(const Pose& from, const Pose& to) const { return query_.test.motion_free(query_.steering.between(from, to)); }
  std::vector<RoadmapNeighbour> from_start() const { return roadmap_.from(query_.start); }
  std::vector<RoadmapNeighbour> neighbours(std::uint32_t i) const { return roadmap_.from(roadmap_.state(i)); }
  std::vector<std::uint32_t> before_goal() const {
    std::vector<std::uint32_t> all;
    for (const RoadmapNeighbour& n : roadmap_.into(query_.goal)) all.push_back(n.index);
    return all;
  }

 private:
  const StateRoadmap& roadmap_;
  const StateQuery& query_;
};

}  // namespace

StateRoadmap::StateRoadmap(const StateQuery& query, const RoadmapOptions& options, std::uint64_t seed, Budget& budget) : options_{options} {
  bins_.clear(query.steering, query.region);
  Random random = Random::stream(seed, 0);
  const auto any = [](const Pose&) { return true; };
  is_whole_ = true;
  for (std::int64_t i = 0; i < options.samples; ++i) {
    if (i % clock_every == 0 && budget.exhausted()) is_whole_ = false;
    if (!is_whole_) break;
    const std::optional<Pose> drawn = query.draw(random, budget, any, std::numeric_limits<double>::infinity());
    if (!drawn) {  // hardly anything is free, or the budget ended
      is_whole_ = !budget.exhausted();
      break;
    }
    bins_.add(*drawn);
  }
  neighbours_ = options.neighbours > 0 ? static_cast<std::size_t>(options.neighbours) : options.radius > 0.0 ? 0 : static_cast<std::size_t>(proven_neighbours(static_cast<double>(size())));
}

std::vector<RoadmapNeighbour> StateRoadmap::near(const Pose& at, StateBins::Way way) const {
  std::vector<StateBins::Near> found;
  if (neighbours_ > 0) {
    bins_.nearest(at, way, neighbours_ + 1, found);  // itself may be among them
  } else {
    bins_.within(at, way, options_.radius, found);
    if (found.empty() && size() > 0) found.push_back(bins_.nearest(at, way));
  }
  std::vector<RoadmapNeighbour> all;
  for (const StateBins::Near& n : found) {
    if (bins_[n.index] != at && (neighbours_ == 0 || all.size() < neighbours_)) all.push_back({n.index, n.cost});
  }
  return all;
}

std::vector<RoadmapNeighbour> StateRoadmap::from(const Pose& at) const { return near(at, StateBins::Way::from_it); }

std::vector<RoadmapNeighbour> StateRoadmap::into(const Pose& at) const { return near(at, StateBins::Way::to_it); }

LazyAnswer<Pose> StateRoadmap::shortest(const StateQuery& query, Budget& budget) const {
  Graph graph{*this, query};
  const std::int64_t left = query.motions - std::min(query.motions, query.test.motions());
  return LazySearch<Graph>{graph, budget, {left, ProbabilisticRoadmap::most_waiting}}.run();
}

}  // namespace waywright
