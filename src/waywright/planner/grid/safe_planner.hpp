// `danger_astar`, `block_astar` and `safe_astar`: the safe-A* publication's own planners on the same problems as every other one, each in two forms.
//
// `published` goes from cell to cell as the publication does, past single corners, its danger in what is expected alone; what then touches is unproven. `corrected` moves
// a disc on tested moves, counts danger as cost, and drives straight only where the exact outlines allow it: what it finds can be proven.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "waywright/planner/grid/published_ways.hpp"
#include "waywright/planner/planner.hpp"

namespace waywright {

struct SafePlannerOptions {
  PublishedMethod method = PublishedMethod::danger;
  bool is_published = false;
  Neighbours neighbours = Neighbours::eight;  ///< of `danger`; `boundary` has 16, `line` 8
  double resolution = 0.0;                    ///< m a cell; 0: the map's own cells, or 0.05 m
  double danger_radius = 0.0;                 ///< m, R₁; 0: 1.5 times the radius of the disc, at least 1.5 cells
  double danger_weight = 1.0;                 ///< of the corrected form: a metre costs 1 + weight·ψ
  double local_radius = 3.0;                  ///< m, of `line`: how far before and after an obstacle the search begins and ends
  bool regularise = false;                    ///< of `boundary`: rectangles in place of obstacles that are not convex
};

class SafePlanner {
 public:
  SafePlanner(std::string name, SafePlannerOptions options) : name_{std::move(name)}, options_{options} {}

  PlanningResult plan(const Problem& problem, Budget& budget) const;
  std::string_view name() const { return name_; }
  /// Cells, danger and obstacles of the problem, made once; memory of searches is kept beside them.
  SafePlanner prepared(const Problem& problem) const;

 private:
  class Ready;
  std::string name_;
  SafePlannerOptions options_;
  std::shared_ptr<const Ready> ready_;
};

std::vector<PlannerDescription> safe_planner_descriptions();

}  // namespace waywright
