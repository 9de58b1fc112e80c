#include "waywright/planner/roadmap/probabilistic_roadmap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "waywright/core/random.hpp"
#include "waywright/planner/plane/proven_radius.hpp"

namespace waywright {
namespace {

constexpr int tries_a_sample = 10'000;  // places drawn until one is free
constexpr int clock_every = 32;         // samples

/// What the search sees of roadmap, ends and lines.
class Graph {
 public:
  using Place = Vec2;
  Graph(const PlaneSpace& space, const ProbabilisticRoadmap& roadmap, Vec2 start, const PlaneTarget& goal) : space_{space}, roadmap_{roadmap}, start_{start}, goal_{goal} {}

  std::uint32_t count() const { return static_cast<std::uint32_t>(roadmap_.size()); }
  Vec2 place(std::uint32_t i) const { return roadmap_.places()[i]; }
  Vec2 start() const { return start_; }
  Vec2 goal_from(Vec2 at) const { return goal_.nearest(at); }
  double cost(Vec2 from, Vec2 to) const { return distance(from, to); }
  double least(Vec2 at) const { return distance(at, goal_.nearest(at)); }
  bool is_free(Vec2 from, Vec2 to) const { return space_.is_free(from, to); }
  std::vector<RoadmapNeighbour> from_start() const { return with_costs(start_, roadmap_.near(start_)); }
  std::vector<RoadmapNeighbour> neighbours(std::uint32_t i) const { return with_costs(place(i), roadmap_.neighbours_of(i)); }
  std::vector<std::uint32_t> before_goal() const { return roadmap_.near(goal_); }

 private:
  std::vector<RoadmapNeighbour> with_costs(Vec2 at, const std::vector<std::uint32_t>& near) const {
    std::vector<RoadmapNeighbour> all;
    all.reserve(near.size());
    for (const std::uint32_t i : near) all.push_back({i, distance(at, place(i))});
    return all;
  }

  const PlaneSpace& space_;
  const ProbabilisticRoadmap& roadmap_;
  Vec2 start_;
  const PlaneTarget& goal_;
};

}  // namespace

ProbabilisticRoadmap::ProbabilisticRoadmap(const PlaneSpace& space, const RoadmapOptions& options, std::uint64_t seed, Budget& budget) : space_{space}, options_{options} {
  bins_.clear(space.region());
  is_whole_ = draw(seed, budget);
  if (options.neighbours > 0) {
    is_whole_ = join_nearest(budget) && is_whole_;
  } else {
    radius_ = options.radius > 0.0 ? options.radius : proven_radius(space.free_area(), static_cast<double>(bins_.size()));
  }
}

bool ProbabilisticRoadmap::draw(std::uint64_t seed, Budget& budget) {
  Random random = Random::stream(seed, 0);
  const Box& region = space_.region();
  for (std::int64_t i = 0; i < options_.samples; ++i) {
    if (i % clock_every == 0 && budget.exhausted()) return false;
    for (int k = 0;; ++k) {
      if (k == tries_a_sample) return true;  // hardly anything is free: there is no more to draw
      const Vec2 at{random.uniform(region.low.x, region.high.x), random.uniform(region.low.y, region.high.y)};
      if (!space_.is_free(at)) continue;
      places_.push_back(at);
      bins_.add(at);
      break;
    }
  }
  return true;
}

/// As many nearest as asked for, of a few equally far ones those drawn first.
std::vector<std::uint32_t> ProbabilisticRoadmap::nearest(Vec2 at, std::size_t count) const {
  count = std::min(count, bins_.size());
  std::vector<PointBins::Near> found;
  if (count == 0) return {};
  const Vec2 size = space_.region().high - space_.region().low;
  double radius = std::sqrt(2.0 * static_cast<double>(count) * size.x * size.y / (std::numbers::pi * static_cast<double>(bins_.size())));
  // Farther than across the region there is none.
  for (const double across = distance(at, bins_[bins_.nearest(at)]) + norm(size); found.size() < count; radius *= 2.0) {
    bins_.within(at, radius, found);
    if (radius > across) break;
  }
  count = std::min(count, found.size());
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count), found.end(),
                    [](const PointBins::Near& a, const PointBins::Near& b) { return a.squared != b.squared ? a.squared < b.squared : a.index < b.index; });
  std::vector<std::uint32_t> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(found[i].index);
  return all;
}

bool ProbabilisticRoadmap::join_nearest(Budget& budget) {
  const auto n = static_cast<std::uint32_t>(bins_.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::vector<std::uint32_t> begin(n + 1, 0);
  first_.assign(n + 1, 0);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (i % clock_every == 0 && budget.exhausted()) return false;
    for (const std::uint32_t k : nearest(bins_[i], static_cast<std::size_t>(options_.neighbours) + 1)) {
      if (k == i) continue;
      pairs.emplace_back(i, k);
      ++begin[i + 1];
      ++begin[k + 1];
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) begin[i + 1] += begin[i];
  joined_.resize(2 * pairs.size());
  std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
  for (const auto& [i, k] : pairs) {
    joined_[fill[i]++] = k;
    joined_[fill[k]++] = i;
  }
  // Those that are each other's are there twice.
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (i % clock_every == 0 && budget.exhausted()) {
      first_.assign(n + 1, 0);
      return false;
    }
    const auto from = joined_.begin() + begin[i], to = joined_.begin() + begin[i + 1];
    std::sort(from, to);
    first_[i] = kept;
    kept += static_cast<std::uint32_t>(std::copy(from, std::unique(from, to), joined_.begin() + kept) - (joined_.begin() + kept));
  }
  first_[n] = kept;
  joined_.resize(kept);
  return true;
}

std::vector<std::uint32_t> ProbabilisticRoadmap::within_radius(Vec2 at, std::uint32_t without) const {
  std::vector<PointBins::Near> found;
  bins_.within(at, radius_, found);
  std::vector<std::uint32_t> all;
  all.reserve(found.size());
  for (const PointBins::Near& near : found) {
    if (near.index != without) all.push_back(near.index);
  }
  return all;
}

std::vector<std::uint32_t> ProbabilisticRoadmap::neighbours_of(std::uint32_t i) const {
  if (options_.neighbours > 0) return {joined_.begin() + first_[i], joined_.begin() + first_[i + 1]};
  return within_radius(places_[i], i);
}

std::vector<std::uint32_t> ProbabilisticRoadmap::near(Vec2 at) const {
  if (options_.neighbours > 0) return nearest(at, static_cast<std::size_t>(options_.neighbours));
  std::vector<std::uint32_t> all = within_radius(at, PointBins::none);
  if (all.empty() && !places_.empty()) all.push_back(bins_.nearest(at));
  return all;
}

std::vector<std::uint32_t> ProbabilisticRoadmap::near(const PlaneTarget& goal) const {
  if (goal.is_point()) return near(goal.area.front());
  std::vector<std::pair<double, std::uint32_t>> all;
  for (std::uint32_t i = 0; i < bins_.size(); ++i) all.emplace_back(distance(bins_[i], goal.nearest(bins_[i])), i);
  std::sort(all.begin(), all.end());
  // All that lie in the region, and of those outside so many, or those within the radius and one at least.
  std::size_t kept = 0, outside = 0;
  while (kept < all.size()) {
    const double off = all[kept].first;
    if (off > 0.0 && outside++ > 0 && (options_.neighbours > 0 ? outside > static_cast<std::size_t>(options_.neighbours) : off > radius_)) break;
    ++kept;
  }
  all.resize(kept);
  std::vector<std::uint32_t> places;
  for (const auto& [off, i] : all) places.push_back(i);
  return places;
}

RoadmapAnswer ProbabilisticRoadmap::shortest(Vec2 start, const PlaneTarget& goal, Budget& budget, std::int64_t lines) const {
  Graph graph{space_, *this, start, goal};
  return LazySearch<Graph>{graph, budget, {lines, most_waiting}}.run();
}

}  // namespace waywright
