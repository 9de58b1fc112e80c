#include "waywright/planner/docking/optimality.hpp"

#include <algorithm>
#include <queue>
#include <tuple>
#include <vector>

#include "waywright/planner/docking/cost_bound.hpp"
#include "waywright/planner/docking/pattern_search.hpp"
#include "waywright/planner/docking/side_search.hpp"

namespace waywright {
namespace {

constexpr std::int64_t most_boxes = 400'000;  // a few seconds, some 40 MiB
constexpr double metres_per_radian = 2.5;     // what a heading weighs when a box is split

struct Node {
  double cost = 0.0;        ///< no pattern of the box costs less
  std::int64_t order = 0;   ///< of its making: ties are broken the same way everywhere
  std::size_t side = 0;
  TransitionBox box;
  bool operator<(const Node& other) const { return std::tie(other.cost, other.order) < std::tie(cost, order); }
};

/// Is some of the box's area in a polygon? A box that only may be is taken to be.
bool meets(const TransitionBox& box, const std::vector<Ring>& polygons) {
  const Vec2 middle = 0.5 * (box.low + box.high);
  const double radius = 0.5 * norm(box.high - box.low);
  return std::any_of(polygons.begin(), polygons.end(), [&](const Ring& ring) { return distance(nearest_in(ring, middle), middle) <= radius; });
}

std::pair<TransitionBox, TransitionBox> halves(const TransitionBox& box) {
  TransitionBox first = box, second = box;
  const Vec2 size = box.high - box.low;
  const double turn = metres_per_radian * (box.offset_high - box.offset_low);
  if (turn >= size.x && turn >= size.y) {
    first.offset_high = second.offset_low = 0.5 * (box.offset_low + box.offset_high);
  } else if (size.x >= size.y) {
    first.high.x = second.low.x = 0.5 * (box.low.x + box.high.x);
  } else {
    first.high.y = second.low.y = 0.5 * (box.low.y + box.high.y);
  }
  return {first, second};
}

}  // namespace

Optimality bound_optimum(const PreparedDocking& prepared, const PatternDockingOptions& options, const PathMeasures& reference, double cost,
                         Budget& budget) {
  const std::vector<TransitionZone>& zones = prepared.task().zones;
  std::vector<PatternBounds> bounds;
  std::priority_queue<Node> open;
  std::int64_t made = 0;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    bounds.emplace_back(prepared, zones[i].side, options.leads);
    if (zones[i].left_out() || !is_wanted(options.sides, zones[i].side)) continue;
    const SearchSpace space = search_space(zones[i], options.heading_range);
    TransitionBox all{{space.low[0], space.low[1]}, {space.high[0], space.high[1]}, 0.0, 0.0};
    if (space.dimension() > 2) std::tie(all.offset_low, all.offset_high) = std::pair{space.low[2], space.high[2]};
    open.push({0.0, made++, i, all});
  }
  Optimality found;
  found.cost = cost;
  found.lower_bound = cost;
  const double enough = cost / (1.0 + options.gap);
  while (!open.empty()) {
    const Node node = open.top();
    found.lower_bound = std::min(cost, node.cost);
    if (node.cost >= enough || made >= most_boxes || budget.exhausted()) break;
    open.pop();
    const auto [first, second] = halves(node.box);
    for (const TransitionBox& box : {first, second}) {
      ++made;
      if (!meets(box, zones[node.side].polygons)) continue;
      const PatternBound bound = bounds[node.side].over(box);
      PathMeasures least;
      least.length = bound.length;
      least.curvature_change = bound.curvature_change;
      const double at_least = std::max(node.cost, objective_value(options, least, reference));
      if (at_least >= cost || bounds[node.side].all_collide(box)) continue;
      open.push({at_least, made, node.side, box});
    }
    found.lower_bound = cost;  // where no box is left, nothing costs less
  }
  found.boxes = made;
  return found;
}

}  // namespace waywright
