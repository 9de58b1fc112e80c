// Any-angle ways over a grid: lazy Theta* (Nash, Koenig, Tovey 2010). A cell's parent is any cell, or the true start, that sees it; whether it does is looked at when
// the cell is expanded.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "waywright/planner/grid/grid_search.hpp"
#include "waywright/planner/grid/sight.hpp"

namespace waywright {

struct ThetaQuery {
  Vec2 start{}, goal{};
  std::vector<GridEnd> starts, goals;        ///< the cells around them, as in GridQuery
  double margin = 0.0, end_margin = 0.0;     ///< m, between cells, and from the start
  std::optional<std::int64_t> expansions{};  ///< at most so many
  Budget* budget = nullptr;
  std::function<bool(Cell, int move)> is_free{};  ///< of moves that have to be asked for
  const ZoneRules* zones = nullptr;               ///< that direct or weigh; starts and goals have what they cost as lengths
};

struct ThetaAnswer {
  SearchEnd ended = SearchEnd::unreachable;
  std::vector<Vec2> points;  ///< from the start to the goal
  std::int64_t expansions = 0;
};

class ThetaSearch {
 public:
  /// Not proven to be the shortest of any kind; deterministic. Where zones weigh, a line costs what ZoneRules says of it, cut exactly where it crosses outlines, and a cell is
  /// reached from its parent's parent or from its parent, whichever costs less. 16 bytes a cell, kept from search to search.
  ThetaAnswer run(const GridGraph& graph, const GridFrame& frame, const Sight& sight, const ThetaQuery& query);

 private:
  struct Visit {
    double length = 0.0;       ///< m from the start, as zones weigh it
    std::uint32_t parent = 0;  ///< index of a cell; the start itself: from_start
    std::uint16_t generation = 0;
    bool is_closed = false;
  };
  template <class Lines>
  ThetaAnswer run(const GridGraph& graph, const GridFrame& frame, const Sight& sight, const ThetaQuery& query, const Lines& lines);

  std::vector<Visit> visits_;
  std::uint16_t generation_ = 0;
};

}  // namespace waywright
