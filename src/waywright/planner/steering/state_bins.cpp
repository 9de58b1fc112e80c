#include "waywright/planner/steering/state_bins.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double looked_at = 4.0;  // times as many positions as are wanted, in the first look

/// The least bound on top, of several the state added first.
bool is_later(const StateBins::Near& a, const StateBins::Near& b) { return b < a; }

}  // namespace

void StateBins::clear(const Steering& steering, const Box& region) {
  steering_ = &steering;
  region_ = region;
  bins_.clear(region);
  states_.clear();
}

std::uint32_t StateBins::add(const Pose& pose) {
  states_.emplace_back(pose);
  return bins_.add(pose.position());
}

void StateBins::nearest(const Pose& at, Way way, std::size_t count, std::vector<Near>& found) const {
  found.clear();
  count = std::min(count, size());
  if (count == 0) return;
  const Facing facing{at};
  const Vec2 extent = region_.high - region_.low;
  double radius = std::sqrt(looked_at * static_cast<double>(count) * extent.x * extent.y / (pi * static_cast<double>(size())));
  double looked = -1.0;  // m²: all positions so near have been looked at
  static thread_local std::vector<PointBins::Near> near;
  static thread_local std::vector<Near> waiting;
  const auto worst = [&] { return found.size() < count ? std::numeric_limits<double>::infinity() : found.front().cost; };  // a heap, the dearest on top
  // A circle about the place that holds all of them ends the search.
  const Vec2 far{std::max(at.x - region_.low.x, region_.high.x - at.x), std::max(at.y - region_.low.y, region_.high.y - at.y)};
  for (const double across = norm(far) + norm(extent);; radius *= 2.0) {
    bins_.within(at.position(), radius, near);
    waiting.clear();
    for (const PointBins::Near& n : near) {
      if (n.squared <= looked) continue;
      const double least = bound(facing, way, n.index);
      if (least <= worst()) waiting.push_back({least, n.index});
    }
    std::make_heap(waiting.begin(), waiting.end(), is_later);
    while (!waiting.empty() && waiting.front().cost <= worst()) {
      std::pop_heap(waiting.begin(), waiting.end(), is_later);
      const Near next{cost_under(at, way, waiting.back().index, worst()), waiting.back().index};
      waiting.pop_back();
      if (found.size() < count) {
        found.push_back(next);
        std::push_heap(found.begin(), found.end());
      } else if (next < found.front()) {
        std::pop_heap(found.begin(), found.end());
        found.back() = next;
        std::push_heap(found.begin(), found.end());
      }
    }
    looked = radius * radius;
    if (worst() <= radius || near.size() == size() || radius > across) break;
  }
  std::sort_heap(found.begin(), found.end());
}

StateBins::Near StateBins::nearest(const Pose& at, Way way) const {
  static thread_local std::vector<Near> found;
  nearest(at, way, 1, found);
  return found.front();
}

void StateBins::within(const Pose& at, Way way, double radius, std::vector<Near>& found) const {
  found.clear();
  const Facing facing{at};
  static thread_local std::vector<PointBins::Near> near;
  bins_.within(at.position(), radius, near);
  for (const PointBins::Near& n : near) {
    if (bound(facing, way, n.index) > radius) continue;
    const double metres = cost_under(at, way, n.index, radius);
    if (metres <= radius) found.push_back({metres, n.index});
  }
  std::sort(found.begin(), found.end());
}

}  // namespace waywright
