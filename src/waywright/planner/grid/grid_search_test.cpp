#include "waywright/planner/grid/grid_search.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

using Blocked = std::vector<std::uint8_t>;

struct Maze {
  int columns = 0, rows = 0;
  Blocked blocked;
};

Maze random_maze(Random& random) {
  Maze m{static_cast<int>(random.integer(2, 40)), static_cast<int>(random.integer(2, 40)), {}};
  const double share = random.uniform(0.0, 0.45);
  m.blocked.resize(static_cast<std::size_t>(m.columns * m.rows));
  for (std::uint8_t& b : m.blocked) b = random.uniform() < share ? 1 : 0;
  return m;
}

Cell random_cell(const Maze& m, Random& random) {
  return {static_cast<int>(random.integer(0, m.columns - 1)), static_cast<int>(random.integer(0, m.rows - 1))};
}

GridQuery between(Cell start, Cell goal, Heuristic heuristic = Heuristic::free_way) {
  GridQuery q;
  q.starts = {{start, 0.0}};
  q.goals = {{goal, 0.0}};
  q.heuristic = heuristic;
  return q;
}

double walked(const std::vector<Cell>& cells) {
  double sum = 0.0;
  for (std::size_t i = 1; i < cells.size(); ++i) sum += std::hypot(cells[i].column - cells[i - 1].column, cells[i].row - cells[i - 1].row);
  return sum;
}

constexpr Neighbours all_neighbours[]{Neighbours::four, Neighbours::eight, Neighbours::sixteen};

TEST(GridSearch, DijkstraAndAStarAgreeOnTenThousandRandomMaps) {
  Random random{2};
  GridSearch search;
  int found = 0, unreachable = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Maze m = random_maze(random);
    const Neighbours n = all_neighbours[i % 3];
    const CornerRule corners = i % 7 == 0 ? CornerRule::loose : CornerRule::strict;
    GridGraph graph{m.columns, m.rows, m.blocked, n, corners};
    const Cell start = random_cell(m, random), goal = random_cell(m, random);
    const GridAnswer plain = search.run(graph, between(start, goal, Heuristic::none));
    for (const Heuristic h : {Heuristic::free_way, Heuristic::euclidean, Heuristic::chebyshev, Heuristic::octile, Heuristic::manhattan}) {
      const GridAnswer quick = search.run(graph, between(start, goal, h));
      ASSERT_EQ(quick.ended, plain.ended) << "map " << i;
      if (plain.ended != SearchEnd::found) continue;
      ASSERT_EQ(quick.cells.front(), start);
      ASSERT_EQ(quick.cells.back(), goal);
      ASSERT_NEAR(walked(quick.cells), quick.counts.length(), 1e-9);
      if (never_too_much(h, n)) ASSERT_EQ(quick.counts.length(), plain.counts.length()) << "map " << i << ", " << to_string(h);
      else ASSERT_GE(quick.counts.length(), plain.counts.length());
      ASSERT_NEAR(quick.cost, quick.counts.length(), quick.error);
    }
    GridQuery published = between(start, goal, Heuristic::euclidean);
    published.order = SearchOrder::published;
    ASSERT_EQ(search.run(graph, published).counts.length(), plain.counts.length());
    ++(plain.ended == SearchEnd::found ? found : unreachable);
  }
  EXPECT_GT(found, 2000);
  EXPECT_GT(unreachable, 2000);
}

// The publication's example: 56 × 14 cells, nothing in the way.
TEST(GridSearch, FreeWaysAreWhatThePublicationPrints) {
  const Blocked none(60 * 20, 0);
  const Cell start{1, 2}, goal{57, 16};
  GridSearch search;
  const auto length = [&](Neighbours n) { return search.run(GridGraph{60, 20, none, n, CornerRule::strict}, between(start, goal)).counts.length(); };
  EXPECT_EQ(length(Neighbours::four), 70.0);
  EXPECT_NEAR(length(Neighbours::eight), 61.799, 5e-4);
  EXPECT_NEAR(length(Neighbours::sixteen), 28.0 + 14.0 * std::sqrt(5.0), 1e-12);
}

TEST(GridSearch, CornersAreCutOnlyByTheLooseRuleAndNeverBetweenTwoBlockedCells) {
  //  . X      . X
  //  . .      X .
  const Blocked one{0, 1, 0, 0}, two{0, 1, 1, 0};
  GridSearch search;
  const auto answer = [&](const Blocked& b, CornerRule rule) { return search.run(GridGraph{2, 2, b, Neighbours::eight, rule}, between({0, 0}, {1, 1})); };
  EXPECT_EQ(answer(one, CornerRule::strict).counts, (MoveCounts{2, 0, 0}));
  EXPECT_EQ(answer(one, CornerRule::loose).counts, (MoveCounts{0, 1, 0}));
  EXPECT_EQ(answer(two, CornerRule::loose).ended, SearchEnd::unreachable);
}

TEST(GridSearch, AKnightsMoveChecksEveryCellThatItCrosses) {
  GridSearch search;
  for (const int blocked : {1, 4}) {  // (1, 0) and (1, 1) under the move from (0, 0) to (2, 1)
    Blocked b(6, 0);
    EXPECT_EQ(search.run(GridGraph{3, 2, b, Neighbours::sixteen, CornerRule::loose}, between({0, 0}, {2, 1})).counts, (MoveCounts{0, 0, 1}));
    b[static_cast<std::size_t>(blocked)] = 1;
    EXPECT_NE(search.run(GridGraph{3, 2, b, Neighbours::sixteen, CornerRule::loose}, between({0, 0}, {2, 1})).counts, (MoveCounts{0, 0, 1}));
  }
}

TEST(GridSearch, UnreachableGoalsAreKnownWithoutASearch) {
  const int n = 500;
  Blocked b(n * n, 0);
  for (int r = 0; r < n; ++r) b[static_cast<std::size_t>(r * n + n / 2)] = 1;
  const GridGraph graph{n, n, b, Neighbours::sixteen, CornerRule::strict};
  EXPECT_EQ(graph.components(), 2);
  const GridAnswer answer = GridSearch{}.run(graph, between({3, 3}, {n - 3, n - 3}));
  EXPECT_EQ(answer.ended, SearchEnd::unreachable);
  EXPECT_TRUE(answer.known_at_once);
  EXPECT_EQ(answer.expansions, 0);
}

TEST(GridSearch, StartsAndGoalsWithWaysBeforeAndAfter) {
  const Blocked none(20 * 20, 0);
  const GridGraph graph{20, 20, none, Neighbours::eight, CornerRule::strict};
  GridQuery q;
  q.starts = {{{2, 2}, 0.6}, {{3, 2}, 0.5}, {{19, 19}, 700.0}};
  q.goals = {{{10, 2}, 4.5}, {{9, 2}, 5.4}};
  for (const Heuristic h : {Heuristic::free_way, Heuristic::none, Heuristic::euclidean}) {
    q.heuristic = h;
    const GridAnswer answer = GridSearch{}.run(graph, q);
    ASSERT_EQ(answer.ended, SearchEnd::found);
    EXPECT_EQ(answer.cells.front(), (Cell{3, 2}));
    EXPECT_NEAR(answer.cost, 0.5 + 6.0 + 5.4, 1e-3);
  }
}

TEST(GridSearch, ADangerousWayIsTakenOnlyWhereTheDetourCostsMore) {
  Blocked none(30 * 30, 0);
  GridGraph graph{30, 30, none, Neighbours::eight, CornerRule::strict};
  std::vector<std::uint16_t> danger(900, 0);
  for (int r = 0; r < 28; ++r) danger[static_cast<std::size_t>(r * 30 + 15)] = 256 * 100;
  graph.set_danger(danger);
  const GridAnswer around = GridSearch{}.run(graph, between({5, 10}, {25, 10}));
  EXPECT_GE(std::max_element(around.cells.begin(), around.cells.end(), [](Cell a, Cell b) { return a.row < b.row; })->row, 28);
  for (std::uint16_t& d : danger) d = static_cast<std::uint16_t>(d / 100);
  graph.set_danger(danger);
  const GridAnswer through = GridSearch{}.run(graph, between({5, 10}, {25, 10}));
  EXPECT_NEAR(through.cost, 20.0 + 1.0, 1e-3);
}

TEST(GridSearch, EndsWithItsBudgetItsClockAndItsFlag) {
  const Blocked none(300 * 300, 0);
  const GridGraph graph{300, 300, none, Neighbours::eight, CornerRule::strict};
  GridQuery q = between({0, 0}, {299, 299}, Heuristic::none);
  q.expansions = 100;
  GridAnswer answer = GridSearch{}.run(graph, q);
  EXPECT_EQ(answer.ended, SearchEnd::expansions);
  EXPECT_EQ(answer.expansions, 100);
  q.expansions.reset();
  const std::atomic<bool> raised{true};
  Budget canceled{{}, &raised};
  q.budget = &canceled;
  EXPECT_EQ(GridSearch{}.run(graph, q).ended, SearchEnd::canceled);
  BudgetLimits limits;
  limits.seconds = 1e-9;
  Budget late{limits};
  q.budget = &late;
  EXPECT_EQ(GridSearch{}.run(graph, q).ended, SearchEnd::timed_out);
}

// Serpentines are the longest ways there are; in the finest weights they leave 32 bits.
TEST(GridSearch, LongWaysAreSearchedInCoarserWeights) {
  const int n = 1000;
  Blocked b(n * n, 0);
  for (int r = 1; r < n; r += 2) {
    for (int c = 0; c < n; ++c) b[static_cast<std::size_t>(r * n + c)] = c == (r % 4 == 1 ? n - 1 : 0) ? 0 : 1;
  }
  const GridGraph graph{n, n, b, Neighbours::eight, CornerRule::strict};
  const GridAnswer answer = GridSearch{}.run(graph, between({0, 0}, {0, n - 2}));
  ASSERT_EQ(answer.ended, SearchEnd::found);
  EXPECT_EQ(answer.counts, (MoveCounts{999 * 500 + 998, 0, 0}));
}

TEST(GridSearch, ManySearchesInOneMemoryAnswerAsFreshOnes) {
  Random random{9};
  GridSearch kept;
  for (int i = 0; i < 300; ++i) {
    const Maze m = random_maze(random);
    const GridGraph graph{m.columns, m.rows, m.blocked, all_neighbours[i % 3], CornerRule::strict};
    const GridQuery q = between(random_cell(m, random), random_cell(m, random));
    const GridAnswer a = kept.run(graph, q), b = GridSearch{}.run(graph, q);
    ASSERT_EQ(a.cells, b.cells);
    ASSERT_EQ(a.expansions, b.expansions);
  }
}

// Ways far longer than expected leave the numbers that a search was given, and those after it begin under what it wrote.
TEST(GridSearch, LongWaysAndShortOnesInOneMemory) {
  const int n = 60;
  Blocked b(n * n, 0);
  for (int r = 1; r < n; r += 2) {
    for (int c = 0; c < n; ++c) b[static_cast<std::size_t>(r * n + c)] = c == (r % 4 == 1 ? n - 1 : 0) ? 0 : 1;
  }
  for (const Neighbours neighbours : all_neighbours) {
    GridGraph graph{n, n, b, neighbours, CornerRule::strict};
    for (const bool dangerous : {false, true}) {
      if (dangerous) graph.set_danger(std::vector<std::uint16_t>(b.size(), 300));
      GridSearch kept;
      for (int i = 0; i < 40; ++i) {
        const GridQuery q = i % 3 == 0 ? between({0, 0}, {0, n - 2}) : i % 3 == 1 ? between({5, 4}, {20, 4}) : between({i, 0}, {i, 10});
        const GridAnswer a = kept.run(graph, q), fresh = GridSearch{}.run(graph, q);
        ASSERT_EQ(a.ended, SearchEnd::found);
        ASSERT_EQ(a.cells, fresh.cells);
        ASSERT_EQ(a.cost, fresh.cost);
        ASSERT_EQ(a.expansions, fresh.expansions);
      }
    }
  }
}

// What searches write goes down to nothing many times over.
TEST(GridSearch, ForgetsOldSearchesWhenNumbersBeginAgain) {
  const Blocked none(9, 0);
  const GridGraph graph{3, 3, none, Neighbours::four, CornerRule::strict};
  GridSearch search;
  for (int i = 0; i < 70'000; ++i) {
    const GridAnswer answer = search.run(graph, between({i % 3, 0}, {0, 2}));
    ASSERT_EQ(answer.counts.straight, 2 + i % 3);
  }
}

}  // namespace
}  // namespace waywright
