// `dijkstra`, `astar` and `theta_star`: ways over the cells of a grid, driven as straight lines with turns on the spot, every move tested against the exact outlines.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "waywright/planner/grid/heading_search.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright {

struct GridPlannerOptions {
  Neighbours neighbours = Neighbours::eight;
  Heuristic heuristic = Heuristic::free_way;
  double resolution = 0.0;  ///< m a cell; 0: the map's own cells, or 0.05 m
  HeadingCosts costs{};     ///< of footprints that are no disc
  bool any_angle = false;   ///< not bound to the directions of moves; for a disc, or the disc around the footprint
};

class GridPlanner {
 public:
  GridPlanner(std::string name, GridPlannerOptions options) : name_{std::move(name)}, options_{options} {}

  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return name_; }
  /// Distance transform, moves and components of the problem, made once; memory of searches is kept beside them.
  GridPlanner prepared(const Problem& problem) const;

 private:
  class Ready;
  std::string name_;
  GridPlannerOptions options_;
  std::shared_ptr<const Ready> ready_;
};

std::vector<PlannerDescription> grid_planner_descriptions();

}  // namespace waywright
