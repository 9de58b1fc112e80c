// Shortest ways on a GridGraph: `dijkstra` and `astar` for one heuristic and neighbourhood or another.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "waywright/core/budget.hpp"
#include "waywright/planner/grid/grid_graph.hpp"

namespace waywright {

/// A cell that a way may begin or end in, and what lies between it and the true start or goal.
struct GridEnd {
  Cell cell{};
  double length = 0.0;  ///< cells, ≥ 0, as zones weigh it
};

enum class SearchOrder {
  buckets,    ///< quick; among ways of equal cost the one found first by a fixed rule
  published,  ///< least cost, then least expected rest, then the older entry, as the publication's reconstruction has it
};

struct GridQuery {
  std::vector<GridEnd> starts, goals;
  Heuristic heuristic = Heuristic::free_way;
  SearchOrder order = SearchOrder::buckets;
  std::optional<std::int64_t> expansions{};  ///< at most so many
  Budget* budget = nullptr;                  ///< its clock and its flag end the search
  /// Is the move from this cell free? Of moves that the graph has to ask for.
  std::function<bool(Cell, int move)> is_free{};
};

enum class SearchEnd { found, unreachable, expansions, timed_out, canceled, too_long };

struct GridAnswer {
  SearchEnd ended = SearchEnd::unreachable;
  std::vector<Cell> cells;      ///< from one of the starts to one of the goals
  MoveCounts counts;            ///< of the moves between them: their exact length
  double cost = 0.0;            ///< cells: length and danger, with what lies before and after
  double error = 0.0;           ///< cells, by which the cost may be over the least one (see MoveWeights)
  std::int64_t expansions = 0;
  bool known_at_once = false;   ///< unreachable, by components: nothing was searched
};

/// Memory of searches on one graph after another; for one thread at a time. 5 bytes a cell and what waits.
class GridSearch {
 public:
  GridSearch();
  ~GridSearch();
  GridSearch(GridSearch&&) noexcept;
  GridSearch& operator=(GridSearch&&) noexcept;

  /// The least costly way. Cells of starts and goals lie in the grid. Same graph and query: the same answer.
  GridAnswer run(const GridGraph& graph, const GridQuery& query);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace waywright
