#include "waywright/planner/state_lattice/lattice_rest.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace waywright {
namespace {

constexpr double beyond_start = 1.3;  // of what the start's rest is
constexpr double and_more = 2.0;      // m
constexpr double rounding = 1e-9;     // share by which sums of a search may be off

/// Motions that change the cell; of those that drive the same curve in both directions the less costly one.
std::vector<const MotionPrimitive*> least_motions(const MotionPrimitives& primitives) {
  std::vector<const MotionPrimitive*> all;
  for (int h = 0; h < lattice_headings; ++h) {
    for (const MotionPrimitive& p : primitives[static_cast<std::size_t>(h)]) {
      if (p.step == LatticeStep{}) continue;
      const auto is_same = [&](const MotionPrimitive& q) { return q.step == p.step && q.to == other_way(p.to) && q.length == p.length && q.stretch.direction != p.stretch.direction; };
      const auto& others = primitives[static_cast<std::size_t>(other_way(h))];
      const auto same = std::find_if(others.begin(), others.end(), is_same);
      if (same == others.end() || p.metres < same->metres || (p.metres == same->metres && p.stretch.direction > 0)) all.push_back(&p);
    }
  }
  return all;
}

}  // namespace

double LatticeRest::motion_at_least(std::uint32_t from, std::uint32_t to, const MotionPrimitive& motion) const {
  if (motion.length == 0.0) return motion.metres;
  const double required = graph_.required(), margin = graph_.margin();
  // Half the way to the next place the origin can have led straight away from one, half towards the other. The places are among the poses that the cost is summed over: between
  // two of them the greater of both bounds is convex, so that the sum by trapezoids is no less than the integral.
  const double begin = graph_.clearance_at_most(from), end = graph_.clearance_at_most(to);
  if (begin <= margin || end <= margin) return std::numeric_limits<double>::infinity();
  const Vec2 at = graph_.place(from);
  double sum = 0.0, before = begin;
  for (const MotionPrimitive::Place& place : motion.between) {
    const double there = graph_.clearance_at_most(at + place.offset);
    if (there <= margin) return std::numeric_limits<double>::infinity();
    sum += costs_.away(before - required, 0.5 * place.way) + costs_.away(there - required, 0.5 * place.way);
    before = there;
  }
  sum += costs_.away(before - required, 0.5 * motion.last_way) + costs_.away(end - required, 0.5 * motion.last_way);
  // Bends cost something where nothing is near, too; how much more where the danger is, nobody knows here.
  const double each = costs_.each(motion.stretch.direction);
  return least_factor_ * std::max(motion.metres, (each * sum + motion.metres - each * motion.length) * (1.0 - rounding));
}

LatticeRest::LatticeRest(const LatticeGraph& graph, const DangerCosts& costs, double least_factor) : graph_{graph}, costs_{costs}, least_factor_{least_factor} {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  rest_.assign(graph.cells(), infinity);
  const std::vector<const MotionPrimitive*> motions = least_motions(graph.primitives());
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](std::uint32_t cell, double cost) {
    if (!(cost < rest_[cell])) return;
    rest_[cell] = cost;
    open.push({cost, cell});
  };
  for (const GoalMotion& m : graph.goal_motions()) reach(m.cell, least_factor * m.metres);
  double until = infinity;
  known_ = infinity;
  is_cut_off_ = true;
  if (graph.is_cut_off()) return;
  while (!open.empty()) {
    const auto [cost, cell] = open.top();
    open.pop();
    if (cost > rest_[cell]) continue;
    if (cost > until) {
      known_ = cost;
      break;
    }
    if (cell == graph.start_cell()) {
      is_cut_off_ = false;
      until = beyond_start * cost + and_more;
    }
    for (const MotionPrimitive* m : motions) {
      const auto before = graph.moved(cell, {-m->step.column, -m->step.row});
      if (!before || cost + least_factor * m->metres >= rest_[*before]) continue;
      reach(*before, cost + motion_at_least(*before, cell, *m));
    }
  }
}

}  // namespace waywright
