#include "waywright/planner/field/wavefront.hpp"

#include <gtest/gtest.h>

#include "waywright/core/random.hpp"
#include "waywright/planner/grid/grid_search.hpp"

namespace waywright {
namespace {

const auto never_asked = [](Cell, int) { return false; };
const auto never_stops = [] { return false; };

// The grid that is printed, top row first; 1 is blocked.
TEST(Wavefront, IsThePrintedOne) {
  const std::vector<std::vector<std::uint32_t>> printed{
      {18, 17, 16, 15, 14, 13, 12, 11, 10, 9, 9, 9, 9, 9, 9, 9}, {17, 17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 8, 8, 8, 8, 8}, {17, 16, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 7, 7, 7, 7},
      {17, 16, 15, 15, 1, 1, 1, 1, 1, 1, 1, 1, 6, 6, 6, 6},      {17, 16, 15, 14, 1, 1, 1, 1, 1, 1, 1, 1, 5, 5, 5, 5},     {17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 4, 4},
      {17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 3},  {17, 16, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2}};
  std::vector<std::uint8_t> blocked;
  for (const auto& row : printed) {
    for (const std::uint32_t value : row) blocked.push_back(value == 1 ? 1 : 0);
  }
  const GridGraph graph{16, 8, blocked, Neighbours::eight, CornerRule::loose};  // as printed: past corners
  const Wavefront front = wavefront(graph, {{15, 7}}, never_asked, never_stops);
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 16; ++column) {
      const std::uint32_t value = printed[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      EXPECT_EQ(front.values[graph.index(column, row)], value == 1 ? 0 : value) << column << ", " << row;
    }
  }
  EXPECT_EQ(front.reached, 16 * 8 - 16);
  const std::vector<Cell> way = way_down(front, graph, {0, 0}, never_asked);
  ASSERT_EQ(way.size(), 17u);  // 18 down to 2
  EXPECT_TRUE(way.back() == (Cell{15, 7}));
  // The first of those that lead down, from the east on: so from 17 at (1, 0) east to 16.
  EXPECT_TRUE(way[1] == (Cell{1, 0}));
}

// With four neighbours a move is a cell's side: the value is Dijkstra's distance.
TEST(Wavefront, CountsTheMovesOfTheShortestWayWithFourNeighbours) {
  Random random{3};
  for (int map = 0; map < 200; ++map) {
    std::vector<std::uint8_t> blocked(30 * 20);
    for (auto& b : blocked) b = random.uniform() < 0.3 ? 1 : 0;
    const GridGraph graph{30, 20, blocked, Neighbours::four, CornerRule::strict};
    const Cell goal{static_cast<int>(random.integer(0, 29)), static_cast<int>(random.integer(0, 19))}, start{static_cast<int>(random.integer(0, 29)), static_cast<int>(random.integer(0, 19))};
    if (blocked[graph.index(goal)] != 0 || blocked[graph.index(start)] != 0) continue;
    const Wavefront front = wavefront(graph, {goal}, never_asked, never_stops);
    GridQuery query;
    query.starts = {{start, 0.0}};
    query.goals = {{goal, 0.0}};
    GridSearch search;
    const GridAnswer answer = search.run(graph, query);
    if (answer.ended != SearchEnd::found) {
      if (!(start == goal)) {
        EXPECT_FALSE(front.reaches(graph.index(start)));
      }
      continue;
    }
    ASSERT_EQ(front.values[graph.index(start)], Wavefront::goal_value + static_cast<std::uint32_t>(answer.counts.straight));
    EXPECT_EQ(way_down(front, graph, start, never_asked).size(), answer.cells.size());
  }
}

TEST(Wavefront, TiesAreResolvedForClearance) {
  const GridGraph graph{5, 3, std::vector<std::uint8_t>(15, 0), Neighbours::eight, CornerRule::strict};
  const Wavefront front = wavefront(graph, {{4, 1}}, never_asked, never_stops);
  const auto high = [](Cell c) { return static_cast<double>(2 - c.row); };  // the top row is the farthest from all
  const std::vector<Cell> way = way_down(front, graph, {0, 1}, never_asked, high);
  ASSERT_EQ(way.size(), 5u);
  EXPECT_EQ(way[1].row, 0);
  EXPECT_EQ(way[2].row, 0);
  EXPECT_EQ(way[3].row, 0);
}

TEST(Wavefront, StopsWhereItIsTold) {
  const GridGraph graph{100, 100, std::vector<std::uint8_t>(10'000, 0), Neighbours::eight, CornerRule::strict};
  int asked = 0;
  const Wavefront front = wavefront(graph, {{0, 0}}, never_asked, [&] { return ++asked > 3; });
  EXPECT_TRUE(front.is_stopped);
  EXPECT_LT(front.reached, 10'000);
}

}  // namespace
}  // namespace waywright
