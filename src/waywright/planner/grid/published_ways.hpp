// The four searches of the safe-A* publication on cells, as published: a point that goes from the middle of a cell to the middle of a cell, past single blocked
// corners, with its own expectations of what is left. For comparison; what a vehicle can drive is planned by the corrected forms (safe_planner.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "waywright/planner/grid/boundary_points.hpp"
#include "waywright/planner/grid/line_detours.hpp"
#include "waywright/planner/grid/published_search.hpp"

namespace waywright {

enum class PublishedMethod {
  shortest,  ///< T_A*: 8 neighbours, straight distance expected
  danger,    ///< S_A*: the same with the danger coefficient
  line,      ///< R_[17]: the straight line, with searches around what it crosses
  boundary,  ///< SHA*: 16 neighbours, danger coefficient, up to where a boundary point sees the goal
};

struct PublishedWay {
  SearchEnd ended = SearchEnd::unreachable;
  bool known_at_once = false;
  std::vector<Vec2> points;    ///< from start to goal; middles of cells, and on straight parts places at most a cell apart; cells
  std::int64_t expansions = 0;
  BoundaryAnswer boundary;     ///< of `boundary`: how it was constructed
  bool fell_back = false;      ///< of `boundary`: searched to the goal, as `boundary.why` says
  std::size_t local = 0;       ///< of `line`: searches around obstacles
};

/// What the four know of one map, prepared. Immutable.
class PublishedWays {
 public:
  /// `cell`: m. `neighbours`: of `danger`. `around`: cells, of `line`. `clearance`: m from the middle of a blocked cell that the straight part of `boundary` keeps.
  struct Options {
    DangerRule danger{};
    Neighbours neighbours = Neighbours::eight;
    double around = 3.0;
    double clearance = 1.0;
  };
  PublishedWays(CellMap cells, double cell, PublishedMethod method, const Options& options);

  PublishedWay way(Cell start, Cell goal, PublishedSearch& search, std::optional<std::int64_t> expansions, Budget* budget) const;
  const CellMap& cells() const { return cells_; }

 private:
  bool is_clear(Vec2 from, Vec2 to) const;
  PublishedWay line(Cell start, Cell goal, PublishedSearch& search, std::optional<std::int64_t> expansions, Budget* budget) const;
  PublishedWay boundary(Cell start, Cell goal, PublishedSearch& search, std::optional<std::int64_t> expansions, Budget* budget) const;

  CellMap cells_;
  PublishedMethod method_;
  Options options_;
  double clearance_ = 0.0;  ///< cells
  GridGraph graph_;
  CellDanger danger_;
  std::optional<CellObstacles> obstacles_;
};

}  // namespace waywright
