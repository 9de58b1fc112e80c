// What the way from each cell to the goal costs at least, whatever the heading.
#pragma once

#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/planner/state_lattice/lattice_graph.hpp"

namespace waywright {

/// The lattice without its headings: from cell to cell by every motion of any heading, with the least danger that there can be where the distance of its origin to
/// obstacles is known at some places. Dijkstra from the goal.
/// Laws: rest(cell) ≤ cost of any way in the lattice from a state of the cell; rest(a) ≤ cost of a motion from a to b + rest(b).
class LatticeRest {
 public:
  /// Searched until all is known up to some way beyond the start; the rest is at least what the farthest known cell needs.
  /// `least_factor`: of a metre in any zone.
  LatticeRest(const LatticeGraph& graph, const DangerCosts& costs, double least_factor = 1.0);

  double operator()(std::uint32_t cell) const { return rest_[cell] < known_ ? rest_[cell] : known_; }
  /// No way leads from the start's cell.
  bool is_cut_off() const { return is_cut_off_; }
  /// What a motion between these cells costs at least; +∞ where it cannot be free.
  double motion_at_least(std::uint32_t from, std::uint32_t to, const MotionPrimitive& motion) const;

 private:
  const LatticeGraph& graph_;
  DangerCosts costs_;
  double least_factor_;
  std::vector<double> rest_;
  double known_ = 0.0;
  bool is_cut_off_ = false;
};

}  // namespace waywright
