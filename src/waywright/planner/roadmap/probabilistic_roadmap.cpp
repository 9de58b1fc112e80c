#include "waywright/planner/roadmap/probabilistic_roadmap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>

#include "waywright/core/random.hpp"
#include "waywright/planner/plane/proven_radius.hpp"

namespace waywright {
namespace {

constexpr int tries_a_sample = 10'000;  // places drawn until one is free
constexpr int clock_every = 32;         // samples, or lines

/// A* with lines that are tested when they come first (Bohlin, Kavraki 2000; one entry a line).
class LazySearch {
 public:
  LazySearch(const PlaneSpace& space, const ProbabilisticRoadmap& roadmap, Vec2 start, const PlaneTarget& goal, Budget& budget, std::int64_t lines)
      : space_{space}, roadmap_{roadmap}, places_{roadmap.places()}, start_{start}, goal_{goal}, budget_{budget}, lines_{lines}, count_{static_cast<std::uint32_t>(places_.size())} {}

  RoadmapAnswer run() {
    const std::vector<std::uint32_t> from_start = roadmap_.near(start_), to_goal = roadmap_.near(goal_);
    is_before_goal_.assign(count_, false);
    for (const std::uint32_t i : to_goal) is_before_goal_[i] = true;
    parents_.assign(count_ + 2, none);
    costs_.assign(count_ + 2, std::numeric_limits<double>::infinity());
    settle(start(), none, 0.0);
    for (const std::uint32_t i : from_start) offer(start(), i);
    if (const double length = distance(start_, goal_.nearest(start_)); roadmap_.radius() <= 0.0 || length <= roadmap_.radius()) offer(start(), goal());
    answer_.ended = search();
    const std::uint32_t last = answer_.ended == RoadmapEnd::found ? goal() : nearest_;
    answer_.length = costs_[last];
    for (std::uint32_t i = last; i != none; i = parents_[i]) {
      const Vec2 at = i == goal() ? goal_.nearest(place(parents_[i])) : place(i);
      if (answer_.way.empty() || answer_.way.back() != at) answer_.way.push_back(at);
    }
    std::reverse(answer_.way.begin(), answer_.way.end());
    return std::move(answer_);
  }

 private:
  static constexpr std::uint32_t none = PointBins::none;
  struct Entry {
    double estimate, cost;
    std::uint32_t node, parent;
    /// Worse ones first, for a queue whose top is the last. In full order: the same whoever compares.
    bool operator<(const Entry& o) const {
      if (estimate != o.estimate) return estimate > o.estimate;
      if (cost != o.cost) return cost < o.cost;
      if (node != o.node) return node > o.node;
      return parent > o.parent;
    }
  };
  std::uint32_t start() const { return count_; }
  std::uint32_t goal() const { return count_ + 1; }
  Vec2 place(std::uint32_t i) const { return i == start() ? start_ : places_[i]; }

  void settle(std::uint32_t node, std::uint32_t parent, double cost) {
    parents_[node] = parent;
    costs_[node] = cost;
    if (node == goal()) return;
    ++answer_.reached;
    const Vec2 at = place(node);
    const double off = distance(at, goal_.nearest(at));
    if (off >= missing_) return;
    missing_ = off;
    nearest_ = node;
  }

  void offer(std::uint32_t from, std::uint32_t to) {
    if (std::isfinite(costs_[to])) return;
    const Vec2 here = place(from), there = to == goal() ? goal_.nearest(here) : places_[to];
    const double cost = costs_[from] + distance(here, there);
    waiting_.push({to == goal() ? cost : cost + distance(there, goal_.nearest(there)), cost, to, from});
  }

  RoadmapEnd search() {
    for (std::int64_t step = 0; !waiting_.empty(); ++step) {
      if (step % clock_every == 0 && budget_.exhausted()) return RoadmapEnd::stopped;
      const Entry next = waiting_.top();
      waiting_.pop();
      if (std::isfinite(costs_[next.node])) continue;
      const Vec2 from = place(next.parent), to = next.node == goal() ? goal_.nearest(from) : places_[next.node];
      if (from != to) {
        if (answer_.lines >= lines_) return RoadmapEnd::lines;
        ++answer_.lines;
        if (!space_.is_free(from, to)) continue;
      }
      settle(next.node, next.parent, next.cost);
      answer_.taken.push_back({from, to, static_cast<std::uint32_t>(std::min<std::int64_t>(answer_.lines, SearchPicture::never - 1))});
      if (next.node == goal()) return RoadmapEnd::found;
      if (waiting_.size() > ProbabilisticRoadmap::most_waiting) return RoadmapEnd::crowded;
      if (is_before_goal_[next.node]) offer(next.node, goal());
      for (const std::uint32_t i : roadmap_.neighbours_of(next.node)) offer(next.node, i);
    }
    return RoadmapEnd::unreachable;
  }

  const PlaneSpace& space_;
  const ProbabilisticRoadmap& roadmap_;
  const std::vector<Vec2>& places_;
  Vec2 start_;
  const PlaneTarget& goal_;
  Budget& budget_;
  std::int64_t lines_;
  std::uint32_t count_;
  std::vector<bool> is_before_goal_;
  std::vector<std::uint32_t> parents_;
  std::vector<double> costs_;  // m; +∞: not reached
  std::priority_queue<Entry> waiting_;
  double missing_ = std::numeric_limits<double>::infinity();
  std::uint32_t nearest_ = none;
  RoadmapAnswer answer_;
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
  return LazySearch{space_, *this, start, goal, budget, lines}.run();
}

}  // namespace waywright
