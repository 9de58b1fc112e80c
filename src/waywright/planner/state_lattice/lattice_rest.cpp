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

struct LeastStep {
  LatticeStep step{};
  double metres = 0.0, length = 0.0;
};

/// Every step once, with the least of what it can cost and of its length.
std::vector<LeastStep> least_steps(const MotionPrimitives& primitives) {
  std::vector<LeastStep> all;
  for (const auto& of_heading : primitives) {
    for (const MotionPrimitive& p : of_heading) {
      if (p.step == LatticeStep{}) continue;
      const auto it = std::find_if(all.begin(), all.end(), [&](const LeastStep& s) { return s.step == p.step; });
      if (it == all.end()) {
        all.push_back({p.step, p.metres, p.length});
      } else {
        it->metres = std::min(it->metres, p.metres);
        it->length = std::min(it->length, p.length);
      }
    }
  }
  return all;
}

}  // namespace

double LatticeRest::motion_at_least(std::uint32_t from, std::uint32_t to, double metres, double length) const {
  const double a = graph_.clearance_at_most(from) - graph_.required(), b = graph_.clearance_at_most(to) - graph_.required();
  if (std::min(a, b) >= costs_.range || length == 0.0) return metres;
  // Half the way the origin can have led away from one end, half to the other.
  const double half = 0.5 * length;
  return metres / length * (costs_.away(std::max(a, 0.0), half) + costs_.away(std::max(b, 0.0), half)) * (1.0 - rounding);
}

LatticeRest::LatticeRest(const LatticeGraph& graph, const DangerCosts& costs) : graph_{graph}, costs_{costs} {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  rest_.assign(graph.cells(), infinity);
  const std::vector<LeastStep> steps = least_steps(graph.primitives());
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto reach = [&](std::uint32_t cell, double cost) {
    if (!(cost < rest_[cell])) return;
    rest_[cell] = cost;
    open.push({cost, cell});
  };
  for (const GoalMotion& m : graph.goal_motions()) reach(m.cell, m.metres);
  double until = infinity;
  known_ = infinity;
  is_cut_off_ = true;
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
    for (const LeastStep& s : steps) {
      const auto before = graph.moved(cell, {-s.step.column, -s.step.row});
      if (!before || graph.clearance_at_most(*before) <= graph.margin()) continue;
      if (cost + s.metres >= rest_[*before]) continue;
      reach(*before, cost + motion_at_least(*before, cell, s.metres, s.length));
    }
  }
}

}  // namespace waywright
