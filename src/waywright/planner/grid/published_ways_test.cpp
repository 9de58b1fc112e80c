// The safe-A* publication's own searches on its reconstructed maps: what its reconstruction asks of them.
#include "waywright/planner/grid/published_ways.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/map/published_maps.hpp"
#include "waywright/metrics/grid_metrics.hpp"

namespace waywright {
namespace {

struct Measured {
  PublishedWay way;
  double length = 0.0, turning = 0.0, risk = 0.0;
};

/// Between two blocked cells that touch at a corner a point may pass.
bool is_inside(const CellMap& cells, Vec2 p) {
  const Vec2 off = p - middle_of(cell_at(p));
  return cells.is_blocked(cell_at(p)) && std::abs(off.x) < 0.499999 && std::abs(off.y) < 0.499999;
}

Measured measured(const CellGrid& grid, const PublishedTask& task, PublishedMethod method, bool is_regularised = false) {
  const auto cell = [&](Vec2 node) { return Cell{static_cast<int>(node.x), grid.rows - 1 - static_cast<int>(node.y)}; };
  CellMap cells{grid.columns, grid.rows, grid.blocked, grid.blocked};
  if (is_regularised) cells.occupied = cells.blocked = with_regular_obstacles(grid.columns, grid.rows, grid.blocked, {cell(task.start), cell(task.goal)});
  const PublishedWays ways{cells, 1.0, method, {}};
  PublishedSearch search;
  Measured m{ways.way(cell(task.start), cell(task.goal), search, {}, nullptr), 0, 0, 0};
  m.length = way_length(m.way.points);
  m.turning = way_turning(m.way.points);
  m.risk = way_risk(m.way.points, cells.occupied, cells.columns, cells.rows, 1.0);
  for (const Vec2 p : with_points_between(m.way.points, 0.25)) EXPECT_FALSE(is_inside(cells, p)) << p.x << ", " << p.y;
  return m;
}

Measured measured(const char* map, PublishedMethod method) {
  const PublishedMap published = published_map(map).value();
  return measured(published.grid, published.tasks.front(), method);
}

TEST(PublishedWays, ShortestOnesHaveTheLengthsOfTheReconstruction) {
  for (const auto& [name, length] : {std::pair{"SA-CONVEX", 380.1320}, std::pair{"SA-NARROW", 422.1737}, std::pair{"SA-RAND1", 202.6346}, std::pair{"SA-RAND2", 209.0782},
                                     std::pair{"SA-RAND3", 209.6640}, std::pair{"SA-IRR", 257.9899}, std::pair{"SA-IRR-REG", 264.4335}}) {
    EXPECT_NEAR(measured(name, PublishedMethod::shortest).length, length, 1e-4) << name;
  }
}

TEST(PublishedWays, BoundaryPointsMakeThemShorterSmootherAndSafer) {
  for (const char* name : {"SA-CONVEX", "SA-NARROW", "SA-RAND1", "SA-RAND2", "SA-RAND3"}) {
    SCOPED_TRACE(name);
    const Measured shortest = measured(name, PublishedMethod::shortest), sha = measured(name, PublishedMethod::boundary);
    ASSERT_EQ(sha.way.ended, SearchEnd::found);
    EXPECT_EQ(sha.way.boundary.kind, BoundaryAnswer::Kind::joined) << sha.way.boundary.why;
    EXPECT_LT(sha.risk, 0.1 * shortest.risk);
    const std::string_view map{name};
    if (map != "SA-RAND2" && map != "SA-RAND3") {
      EXPECT_LT(sha.length, shortest.length);
    }
    if (map == "SA-CONVEX" || map == "SA-NARROW") {
      EXPECT_LE(sha.turning, 0.5 * shortest.turning);
    }
  }
}

// What a prototype of the same rules had, which shares no code with this.
TEST(PublishedWays, AgreeWithThePrototypeOfTheReconstruction) {
  struct Known {
    const char* map;
    double danger_length, danger_turning, danger_risk, sha_length, sha_turning, sha_risk;
    Cell last;  ///< as a node
  };
  for (const Known& k : {Known{"SA-CONVEX", 383.89, 62.0, 6.6, 364.17, 12.0, 3.7, {171, 88}}, Known{"SA-NARROW", 427.93, 58.9, 0.7, 405.76, 6.8, 1.4, {153, 114}},
                         Known{"SA-RAND2", 215.52, 14.9, 0.0, 209.75, 9.6, 5.7, {125, 189}}, Known{"SA-RAND3", 216.11, 21.2, 0.0, 207.90, 12.8, 0.0, {121, 165}}}) {
    SCOPED_TRACE(k.map);
    const Measured danger = measured(k.map, PublishedMethod::danger), sha = measured(k.map, PublishedMethod::boundary);
    EXPECT_NEAR(danger.length, k.danger_length, 0.006);
    EXPECT_NEAR(danger.turning, k.danger_turning, 0.06);
    EXPECT_NEAR(danger.risk, k.danger_risk, 0.06);
    EXPECT_EQ(sha.way.boundary.last, (Cell{k.last.column, 199 - k.last.row}));
    EXPECT_NEAR(sha.length, k.sha_length, 0.006);
    EXPECT_NEAR(sha.turning, k.sha_turning, 0.8);  // ties
    EXPECT_NEAR(sha.risk, k.sha_risk, 0.06);
  }
}

/// On the first random map ways of equal cost lead the two to cells beside each other, from which the goal is seen: the way to there is one of a hundredth of a percent less, and turns less.
TEST(PublishedWays, AgreeWithThePrototypeUpToATieOnRandom1) {
  const Measured danger = measured("SA-RAND1", PublishedMethod::danger), sha = measured("SA-RAND1", PublishedMethod::boundary);
  EXPECT_NEAR(danger.length, 204.98, 0.006);
  EXPECT_NEAR(danger.turning, 18.1, 0.06);
  EXPECT_NEAR(danger.risk, 0.0, 0.06);
  const Cell last = sha.way.boundary.last;
  EXPECT_LE(std::abs(last.column - 123), 2);
  EXPECT_LE(std::abs(last.row - (199 - 167)), 2);
  EXPECT_NEAR(sha.length, 198.01, 0.03);
  EXPECT_LE(sha.turning, 11.3 + 0.06);
  EXPECT_NEAR(sha.risk, 0.0, 0.06);
}

TEST(PublishedWays, LinesHaveTheirSearchesAroundWhatTheyCross) {
  for (const char* name : {"SA-CONVEX", "SA-NARROW", "SA-RAND1", "SA-RAND2", "SA-RAND3", "SA-IRR", "SA-IRR-REG"}) {
    SCOPED_TRACE(name);
    const Measured line = measured(name, PublishedMethod::line), shortest = measured(name, PublishedMethod::shortest);
    ASSERT_EQ(line.way.ended, SearchEnd::found);
    EXPECT_GT(line.way.local, 0U);
    EXPECT_GE(line.length, distance(line.way.points.front(), line.way.points.back()));
    EXPECT_LT(line.length, 1.5 * shortest.length);
  }
}

TEST(PublishedWays, WhatCannotBeReachedIsNot) {
  CellMap cells{9, 9, std::vector<std::uint8_t>(81, 0), {}};
  for (int r = 0; r < 9; ++r) cells.occupied[cells.index({4, r})] = 1;
  cells.blocked = cells.occupied;
  PublishedSearch search;
  for (const PublishedMethod m : {PublishedMethod::shortest, PublishedMethod::danger, PublishedMethod::line, PublishedMethod::boundary}) {
    const PublishedWay way = PublishedWays{cells, 1.0, m, {}}.way({1, 1}, {7, 7}, search, {}, nullptr);
    EXPECT_EQ(way.ended, SearchEnd::unreachable);
    EXPECT_TRUE(way.points.empty());
    EXPECT_EQ(PublishedWays(cells, 1.0, m, {}).way({4, 1}, {7, 7}, search, {}, nullptr).ended, SearchEnd::unreachable) << "from a blocked cell";
  }
}

TEST(CellDanger, AddsUpWhatIsNear) {
  std::vector<std::uint8_t> cells(49, 0);
  const auto at = [](int column, int row) { return static_cast<std::size_t>(row * 7 + column); };
  const auto danger = [&] { return CellDanger{7, 7, 1.0, cells, {}}.at({3, 3}); };
  EXPECT_EQ(danger(), 0.0);
  cells[at(3, 5)] = 1;  // two metres away
  EXPECT_EQ(danger(), 0.0);
  cells[at(4, 3)] = 1;
  EXPECT_NEAR(danger(), 2.0, 1e-12);
  cells[at(4, 4)] = 1;
  EXPECT_NEAR(danger(), 3.414, 5e-4);
  cells[at(4, 3)] = 0;
  EXPECT_NEAR(danger(), 1.414, 5e-4);
}

// Blocks of cells stand for their cells: against the sum over each, for a wall on finer and finer cells.
TEST(CellDanger, MeansTheSameOnFinerCells) {
  const auto beside_wall = [](double cell) {
    const int side = static_cast<int>(std::lround(8.0 / cell));
    std::vector<std::uint8_t> cells(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0);
    double sum = 0.0;
    const Cell here{side / 2, side / 2};
    for (int r = 0; r < side; ++r) {
      for (int c = 0; c < side; ++c) {
        const double d = distance(middle_of({c, r}), middle_of(here)) * cell;
        if ((c - here.column) * cell < 1.0) continue;
        cells[static_cast<std::size_t>(r * side + c)] = 1;
        if (d <= 1.5) sum += 2.0 / d * cell * cell;
      }
    }
    return std::pair{CellDanger{side, side, cell, cells, {}}.at(here), sum};
  };
  for (const double cell : {0.25, 0.1, 0.05, 0.02}) {
    const auto [quick, exact] = beside_wall(cell);
    EXPECT_NEAR(quick, exact, cell >= 0.3 ? 1e-12 : 0.2 * exact + 0.02) << cell;
  }
}

TEST(CellObstacles, HaveTheCornersOfTheirShapes) {
  const PublishedMap convex = published_map("SA-CONVEX").value();
  const CellObstacles obstacles{200, 200, convex.grid.blocked};
  ASSERT_EQ(obstacles.all().size(), 4U);
  for (const CellObstacles::Obstacle& o : obstacles.all()) {
    EXPECT_TRUE(o.is_convex);
    EXPECT_EQ(o.corners.size(), 3U);
  }
  const PublishedMap irregular = published_map("SA-IRR").value();
  const CellObstacles seven{200, 200, irregular.grid.blocked};
  ASSERT_EQ(seven.all().size(), 7U);
  for (const CellObstacles::Obstacle& o : seven.all()) EXPECT_FALSE(o.is_convex);
}

TEST(RegularObstacles, EncloseTheIrregularOnes) {
  const PublishedMap irregular = published_map("SA-IRR").value();
  const auto regular = with_regular_obstacles(200, 200, irregular.grid.blocked, {});
  for (std::size_t i = 0; i < regular.size(); ++i) EXPECT_GE(regular[i], irregular.grid.blocked[i]);
  // Nearly the rectangles around the polygons themselves, of which the cells are what lies within.
  const PublishedMap printed = published_map("SA-IRR-REG").value();
  const auto count = [](const std::vector<std::uint8_t>& cells) { return static_cast<double>(std::count(cells.begin(), cells.end(), 1)); };
  EXPECT_NEAR(count(regular), count(printed.grid.blocked), 0.03 * count(printed.grid.blocked));
  // And the way past them leaves them alone.
  const Measured sha = measured(irregular.grid, irregular.tasks.front(), PublishedMethod::boundary, true);
  ASSERT_EQ(sha.way.ended, SearchEnd::found);
  EXPECT_EQ(sha.risk, 0.0);
  // Not over the goal.
  const auto kept = with_regular_obstacles(200, 200, irregular.grid.blocked, {{62, 199 - 42}});
  EXPECT_EQ(kept[static_cast<std::size_t>((199 - 42) * 200 + 62)], 0);
}

TEST(RegularObstacles, EncloseTheirPoints) {
  Random random{5};
  for (int i = 0; i < 20'000; ++i) {
    Ring points;
    for (int k = 0; k < 10; ++k) points.push_back({random.uniform(-10, 10), random.uniform(-10, 10)});
    const Ring rectangle = regularised(points);
    for (const Vec2 p : points) {
      for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 side = rectangle[(k + 1) % 4] - rectangle[k];
        ASSERT_GE(cross(side, p - rectangle[k]) / norm(side), -1e-9) << i;
      }
    }
  }
}

// Blocks instead of cells must not hide what stands beside the one that asks, and danger grows towards a wall.
TEST(CellDanger, GrowsTowardsAWallAtAnyReach) {
  for (const double reach : {0.5, 0.6, 2.0, 5.0, 20.0}) {
    SCOPED_TRACE(reach);
    const int side = 101;
    std::vector<std::uint8_t> one(static_cast<std::size_t>(side) * side, 0), wall = one;
    one[50 * side + 51] = 1;
    for (int row = 0; row < side; ++row) wall[static_cast<std::size_t>(row) * side] = 1;
    DangerRule rule;
    rule.reach = reach;
    const CellDanger beside{side, side, 0.1, one, rule};
    EXPECT_NEAR(beside.at({50, 50}), 2.0 / 0.1 * 0.01, 1e-12);  // one cell, a cell away
    const CellDanger along{side, side, 0.1, wall, rule};
    for (int column = 1; column < 60; ++column) EXPECT_GE(along.at({column, 50}), along.at({column + 1, 50})) << column;
  }
}

}  // namespace
}  // namespace waywright
