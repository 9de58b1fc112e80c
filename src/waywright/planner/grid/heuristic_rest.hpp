// A heuristic towards several ends at once: towards the first of them, less what keeps it under the way to any.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "waywright/planner/grid/grid_graph.hpp"

namespace waywright {

class HeuristicRest {
 public:
  /// `least`: what a metre costs at least.
  HeuristicRest(Neighbours neighbours, const MoveWeights& weights, Heuristic heuristic, double least = 1.0)
      : neighbours_{neighbours}, weights_{weights}, heuristic_{heuristic}, share_{least < 1.0 ? least * under : 1.0} {}

  /// Cells and what lies behind each. @pre not empty
  void aim_at(const std::vector<std::pair<Cell, std::uint32_t>>& ends) {
    middle_ = ends.front().first;
    for (const auto& [cell, behind] : ends) {
      low_ = {std::min(low_.column, cell.column), std::min(low_.row, cell.row)};
      high_ = {std::max(high_.column, cell.column), std::max(high_.row, cell.row)};
      const std::uint32_t way = scaled(towards_middle(cell)) + (share_ < 1.0 ? 1 : 0);  // rounded up
      less_ = std::max(less_, way > behind ? way - behind : 0);
    }
  }
  std::uint32_t at(Cell c) const {
    const std::uint32_t value = scaled(towards_middle(c));
    return value > less_ ? value - less_ : 0;
  }
  /// The same of free_way, where it and the neighbourhood are known when compiled. @pre a metre costs a metre at least
  template <Neighbours neighbours>
  std::uint32_t at_free_way(Cell c) const {
    const std::uint32_t value = free_way(neighbours, weights_, c.column - middle_.column, c.row - middle_.row);
    return value > less_ ? value - less_ : 0;
  }
  Cell middle() const { return middle_; }         ///< what the way is expected to
  std::uint32_t less() const { return less_; }  ///< what is taken off
  bool may_be_end(Cell c) const { return c.column >= low_.column && c.column <= high_.column && c.row >= low_.row && c.row <= high_.row; }

 private:
  static constexpr double under = 1.0 - 0x1p-20;  // never over a sum of weights
  std::uint32_t scaled(std::uint32_t value) const { return share_ < 1.0 ? static_cast<std::uint32_t>(share_ * value) : value; }
  std::uint32_t towards_middle(Cell c) const {
    const int columns = c.column - middle_.column, rows = c.row - middle_.row;
    switch (heuristic_) {
      case Heuristic::none: return 0;
      case Heuristic::free_way: return free_way(neighbours_, weights_, columns, rows);
      case Heuristic::octile: return free_way(Neighbours::eight, weights_, columns, rows);
      case Heuristic::manhattan: return free_way(Neighbours::four, weights_, columns, rows);
      case Heuristic::chebyshev: return static_cast<std::uint32_t>(std::max(std::abs(columns), std::abs(rows))) * weights_.scale;
      case Heuristic::euclidean: {
        const double squared = static_cast<double>(static_cast<std::int64_t>(columns) * columns + static_cast<std::int64_t>(rows) * rows);
        return static_cast<std::uint32_t>(under * weights_.scale * std::sqrt(squared));
      }
    }
    return 0;
  }

  Neighbours neighbours_;
  MoveWeights weights_;
  Heuristic heuristic_;
  double share_ = 1.0;
  Cell middle_{};
  Cell low_{GridGraph::longest_side, GridGraph::longest_side}, high_{-1, -1};
  std::uint32_t less_ = 0;
};

}  // namespace waywright
