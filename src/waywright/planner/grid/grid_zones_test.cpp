// Moves through zones, and least costs over the graph against a plain search that knows only ZoneRules' definition.
#include "waywright/planner/grid/grid_zones.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <queue>

#include "waywright/core/random.hpp"
#include "waywright/planner/grid/disc_graph.hpp"
#include "waywright/planner/grid/grid_search.hpp"
#include "waywright/planner/grid/motion_check.hpp"

namespace waywright {
namespace {

Ring star(Random& random, Vec2 middle, double size) {
  Ring ring;
  const auto corners = random.integer(3, 8);
  for (std::int64_t i = 0; i < corners; ++i) ring.push_back(middle + random.uniform(0.3, 1.0) * size * unit(two_pi * static_cast<double>(i) / static_cast<double>(corners)));
  return ring;
}

/// A hall of cells somewhere, with zones of every kind that directs or weighs.
Scenario hall(Random& random, int columns, int rows) {
  Scenario s;
  CellGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.cell = 0.5;
  grid.origin = {random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-3, 3)};
  for (int i = 0; i < columns * rows; ++i) grid.blocked.push_back(random.uniform() < 0.12 ? 1 : 0);
  s.map.grids = {grid};
  s.vehicle.footprint.disc = 0.1;
  s.vehicle.drive = Differential{0.5};
  for (int k = 0; k < 6; ++k) {
    Zone zone;
    zone.area = star(random, grid.corner(random.uniform(0, columns), random.uniform(0, rows)), random.uniform(0.5, 5.0));
    zone.type = k % 3 == 0 ? ZoneType::directed : k % 3 == 1 ? ZoneType::penalty : ZoneType::preferred;
    zone.direction = random.uniform(-pi, pi);
    zone.factor = zone.type == ZoneType::penalty ? random.uniform(1.1, 8.0) : random.uniform(0.2, 0.9);
    s.zones.push_back(std::move(zone));
  }
  s.start = make_pose(grid.corner(0.5, 0.5), 0.0);
  s.mission = make_pose(grid.corner(columns - 0.5, rows - 0.5), 0.0);
  return s;
}

// Each move asked by itself.
TEST(GridZones, EveryMoveIsWhatItsLineSays) {
  Random random{12};
  std::int64_t against = 0, weighed = 0;
  for (int i = 0; i < 30; ++i) {
    const Problem problem = Problem::prepare(hall(random, 30, 24)).value();
    const GridFrame frame = make_grid_frame(problem, 0.0).value();
    const Neighbours neighbours = i % 3 == 0 ? Neighbours::four : i % 3 == 1 ? Neighbours::eight : Neighbours::sixteen;
    const GridZones zones = GridZones::make(problem.zones(), frame, neighbours).value();
    for (int row = 0; row < frame.rows; ++row) {
      for (int column = 0; column < frame.columns; ++column) {
        for (int move = 0; move < all_moves; move += steps_of(neighbours)) {
          const Move m = moves[static_cast<std::size_t>(move)];
          const Cell to{column + m.column, row + m.row};
          if (!frame.contains(to)) continue;
          const Vec2 a = frame.centre({column, row}), b = frame.centre(to);
          const auto cell = static_cast<std::size_t>(row * frame.columns + column);
          ASSERT_EQ(zones.is_against(cell, move), !problem.zones().may_be_driven(a, b)) << i;
          ASSERT_NEAR(zones.factor(cell, move), problem.zones().cost(a, b) / distance(a, b), 1e-9) << i;
          against += zones.is_against(cell, move) ? 1 : 0;
          weighed += zones.factor(cell, move) != 1.0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(against, 3000);
  EXPECT_GT(weighed, 10'000);
}

/// Dijkstra over cells in doubles, each move asked of the rules; the least cost in m, or infinity.
double plain_least(const Problem& problem, const GridFrame& frame, const GridGraph& free_graph, Cell start, Cell goal) {
  std::vector<double> cost(free_graph.cells(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  cost[free_graph.index(start)] = 0.0;
  open.push({0.0, free_graph.index(start)});
  while (!open.empty()) {
    const auto [sum, at] = open.top();
    open.pop();
    if (sum > cost[at]) continue;
    const Cell here{static_cast<int>(at) % frame.columns, static_cast<int>(at) / frame.columns};
    for (int move = 0; move < all_moves; ++move) {
      if ((free_graph.free_moves()[at] >> move & 1) == 0) continue;
      const Cell there{here.column + moves[static_cast<std::size_t>(move)].column, here.row + moves[static_cast<std::size_t>(move)].row};
      if (!problem.zones().may_be_driven(frame.centre(here), frame.centre(there))) continue;
      const double next = sum + problem.zones().cost(frame.centre(here), frame.centre(there));
      double& known = cost[free_graph.index(there)];
      if (next < known) {
        known = next;
        open.push({next, free_graph.index(there)});
      }
    }
  }
  return cost[free_graph.index(goal)];
}

TEST(GridZones, TheWayFoundCostsTheLeastThatAnyWayCan) {
  Random random{31};
  GridSearch search;
  int found = 0, none = 0;
  for (int i = 0; i < 150; ++i) {
    const Problem problem = Problem::prepare(hall(random, 40, 30)).value();
    const GridFrame frame = make_grid_frame(problem, 0.0).value();
    const CellBounds bounds{problem, frame};
    const Neighbours neighbours = i % 3 == 0 ? Neighbours::four : i % 3 == 1 ? Neighbours::eight : Neighbours::sixteen;
    const GridGraph free_graph = disc_graph(frame, bounds, neighbours, 0.1);
    GridGraph graph = free_graph;
    graph.set_zones(GridZones::make(problem.zones(), frame, neighbours).value());
    const Cell start{0, 0}, goal{39, 29};
    const double least = plain_least(problem, frame, free_graph, start, goal);
    for (const Heuristic heuristic : {Heuristic::free_way, Heuristic::none, Heuristic::euclidean, Heuristic::chebyshev}) {
      GridQuery query;
      query.starts = {{start, 0.0}};
      query.goals = {{goal, 0.0}};
      query.heuristic = heuristic;
      const GridAnswer answer = search.run(graph, query);
      ASSERT_EQ(answer.ended == SearchEnd::found, std::isfinite(least)) << i;
      if (answer.ended != SearchEnd::found) {
        ++none;
        continue;
      }
      ++found;
      ASSERT_NEAR(answer.cost * frame.cell, least, answer.error * frame.cell + 1e-9) << i << " " << to_string(heuristic);
      // And the cells are such a way.
      double sum = 0.0;
      for (std::size_t k = 1; k < answer.cells.size(); ++k) {
        const Vec2 a = frame.centre(answer.cells[k - 1]), b = frame.centre(answer.cells[k]);
        ASSERT_TRUE(problem.zones().may_be_driven(a, b));
        sum += problem.zones().cost(a, b);
      }
      ASSERT_NEAR(sum, least, answer.error * frame.cell + 1e-9);
    }
  }
  EXPECT_GT(found, 250);
  EXPECT_GT(none, 0);
}

// With danger on top: what both cost multiplies.
TEST(GridZones, DangerAndZonesMultiply) {
  Scenario s;
  CellGrid grid;
  grid.columns = 5;
  grid.rows = 1;
  grid.cell = 1.0;
  grid.blocked.assign(5, 0);
  s.map.grids = {grid};
  s.vehicle.drive = Differential{0.5};
  s.mission = Pose{4, 0.5, 0};
  Zone zone;
  zone.type = ZoneType::penalty;
  zone.factor = 3.0;
  zone.area = rectangle({1.5, -1}, {2.5, 2});
  s.zones = {zone};
  const Problem problem = Problem::prepare(s).value();
  const GridFrame frame = make_grid_frame(problem, 0.0).value();
  GridGraph graph{5, 1, grid.blocked, Neighbours::four, CornerRule::strict};
  graph.set_zones(GridZones::make(problem.zones(), frame, Neighbours::four).value());
  graph.set_danger(std::vector<std::uint16_t>{0, 0, 256, 256, 0});
  GridQuery query;
  query.starts = {{{0, 0}, 0.0}};
  query.goals = {{{4, 0}, 0.0}};
  const GridAnswer answer = GridSearch{}.run(graph, query);
  ASSERT_EQ(answer.ended, SearchEnd::found);
  // Factors of the moves are 1, 3, 1, 1 (from middle to middle), with danger 1, 1.5, 2, 1.5.
  EXPECT_NEAR(answer.cost, 1 + 3 * 1.5 + 2 + 1.5, 1e-3);
}

TEST(GridZones, WithoutZonesThereIsNothing) {
  const GridFrame frame{Frame{}, 0.1, 100, 100};
  EXPECT_TRUE(GridZones::make(ZoneRules{}, frame, Neighbours::eight)->empty());
}

// Outlines that fill the hall are refused in a sentence instead of taking minutes.
TEST(GridZones, TooMuchWorkIsRefused) {
  std::vector<Zone> zones;
  for (int k = 0; k < 20; ++k) {
    Zone zone;
    zone.type = ZoneType::penalty;
    zone.factor = 2.0;
    for (int i = 0; i < 499; ++i) zone.area.push_back({i * 0.4 + 0.01 * k, i % 2 == 0 ? 0.0 : 200.0});
    for (int i = 499; i-- > 0;) zone.area.push_back({i * 0.4 + 0.1 + 0.01 * k, i % 2 == 0 ? 0.0 : 200.0});
    zones.push_back(std::move(zone));
  }
  const auto refused = GridZones::make(ZoneRules{zones}, {Frame{}, 0.1, 2000, 2000}, Neighbours::sixteen);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("coarser resolution"), std::string::npos) << refused.error();
}

}  // namespace
}  // namespace waywright
