// What is known of cells and moves, against the World itself.
#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/planner/grid/disc_graph.hpp"
#include "waywright/planner/grid/heading_search.hpp"
#include "waywright/planner/grid/motion_check.hpp"

namespace waywright {
namespace {

Ring around(Vec2 middle, double radius, int corners, Random& random) {
  Ring ring;
  const double turn = random.uniform(0.0, 6.0);
  for (int i = 0; i < corners; ++i) ring.push_back(middle + random.uniform(0.3, 1.0) * radius * unit(turn + two_pi * i / corners));
  return ring;
}

/// Polygons, lines and points in a hall, or a rotated grid of cells with some of them on it.
Scenario random_scenario(Random& random, bool is_grid, bool is_mixed) {
  Scenario s;
  if (is_grid) {
    CellGrid grid;
    grid.columns = static_cast<int>(random.integer(5, 30));
    grid.rows = static_cast<int>(random.integer(5, 30));
    grid.cell = random.uniform(0.1, 0.4);
    grid.origin = {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-3, 3)};
    for (int i = 0; i < grid.columns * grid.rows; ++i) grid.blocked.push_back(random.uniform() < 0.1 ? 1 : 0);
    s.map.grids.push_back(grid);
  } else {
    s.map.boundaries = {{{0, 0}, {8, 0}, {8, 5}, {4, 5.5}, {0, 5}}};
  }
  if (!is_grid || is_mixed) {
    const Vec2 middle = is_grid ? s.map.grids.front().corner(6, 6) : Vec2{4, 3};
    const auto place = [&] { return middle + Vec2{random.uniform(-3, 3), random.uniform(-2, 2)}; };
    for (int i = 0; i < 5; ++i) s.map.obstacles.push_back(around(place(), 0.7, static_cast<int>(random.integer(3, 7)), random));
    s.map.lines.push_back({place(), place()});
    for (int i = 0; i < 5; ++i) s.map.points.push_back(place());
  }
  s.vehicle.footprint.disc = 0.2;
  s.vehicle.drive = Differential{0.3};
  s.start = {1, 1, 0};
  s.mission = Pose{7, 4, 0};
  return s;
}

TEST(CellBounds, TheTrueDistanceLiesBetweenThem) {
  Random random{3};
  for (int i = 0; i < 60; ++i) {
    const Problem problem = Problem::prepare(random_scenario(random, i % 2 == 0, i % 4 == 0)).value();
    const GridFrame frame = make_grid_frame(problem, i % 2 == 0 ? 0.0 : random.uniform(0.05, 0.4)).value();
    EXPECT_EQ(frame.is_native, i % 2 == 0);
    const CellBounds bounds{problem, frame};
    for (int k = 0; k < 200; ++k) {
      const Cell c{static_cast<int>(random.integer(0, frame.columns - 1)), static_cast<int>(random.integer(0, frame.rows - 1))};
      const Vec2 middle = frame.centre(c);
      const double exact = problem.world().clearance({&middle, 1}, 0.0, 100.0).clearance;
      ASSERT_LE(bounds.at_least(c), exact) << i;
      ASSERT_GE(bounds.at_most(c), exact) << i;
      ASSERT_LE(bounds.at_most(c) - std::max(0.0, bounds.at_least(c)), 1.4143 * frame.cell + 1e-5);
      const Vec2 back = frame.in_cells(middle);
      ASSERT_NEAR(back.x, c.column + 0.5, 1e-9);
      ASSERT_NEAR(back.y, c.row + 0.5, 1e-9);
    }
  }
}

TEST(DiscGraph, HasEveryMoveThatIsFreeAndNoOther) {
  Random random{8};
  int free = 0, asked = 0, blocked = 0;
  for (int i = 0; i < 60; ++i) {
    const Problem problem = Problem::prepare(random_scenario(random, i % 2 == 0, i % 4 == 0)).value();
    const GridFrame frame = make_grid_frame(problem, i % 2 == 0 ? 0.0 : random.uniform(0.1, 0.4)).value();
    const CellBounds bounds{problem, frame};
    const Neighbours neighbours = i % 3 == 0 ? Neighbours::four : i % 3 == 1 ? Neighbours::eight : Neighbours::sixteen;
    const double needed = i % 5 == 0 ? 0.001 : random.uniform(0.01, 0.3);
    const GridGraph graph = disc_graph(frame, bounds, neighbours, needed);
    for (int row = 0; row < frame.rows; ++row) {
      for (int column = 0; column < frame.columns; ++column) {
        for (int m = 0; m < all_moves; m += steps_of(neighbours)) {
          const Cell from{column, row}, to{column + moves[static_cast<std::size_t>(m)].column, row + moves[static_cast<std::size_t>(m)].row};
          if (!frame.contains(to)) continue;
          const Vec2 ends[]{frame.centre(from), frame.centre(to)};
          const bool truly = problem.world().is_free(ends, needed);
          const bool is_free = (graph.free_moves()[graph.index(from)] >> m & 1) != 0;
          const bool is_asked = !graph.asked_moves().empty() && (graph.asked_moves()[graph.index(from)] >> m & 1) != 0;
          ASSERT_FALSE(is_free && is_asked);
          if (!is_asked) {
            ASSERT_EQ(is_free, truly) << i;
          }
          ++(is_free ? free : is_asked ? asked : blocked);
        }
      }
    }
  }
  EXPECT_GT(free, 10'000);
  EXPECT_GT(asked, 1000);
  EXPECT_GT(blocked, 10'000);
}

const Ring with_a_notch{{-0.5, -0.3}, {0.6, -0.3}, {0.6, 0.3}, {0.1, 0.05}, {-0.5, 0.3}};

// What is called free is free at every pose between; what is not is nearly not.
TEST(MotionCheck, DrivesAndTurnsAreWhatManyPosesShow) {
  Random random{5};
  int free = 0, blocked = 0;
  for (int i = 0; i < 1500; ++i) {
    Scenario s = random_scenario(random, false, false);
    s.vehicle.footprint = {with_a_notch, 0.0};
    const Problem problem = Problem::prepare(s).value();
    MotionCheck test{problem};
    const double margin = random.uniform(0.001, 0.1);
    const Vec2 at{random.uniform(0.8, 7.2), random.uniform(0.8, 4.2)};
    const double heading = random.uniform(-3, 3);
    const bool is_turn = i % 2 == 0;
    const double angle = random.uniform(-3, 3);
    const Vec2 to = at + random.uniform(0.0, 1.0) * unit(random.uniform(-3, 3));
    const bool claimed = is_turn ? test.is_turn_free(at, heading, angle, margin) : test.is_drive_free(at, to, heading, margin);
    double least = 100.0;
    for (int k = 0; k <= 200; ++k) {
      const double t = k / 200.0;
      const Pose pose = is_turn ? make_pose(at, wrap(heading + t * angle)) : make_pose(at + t * (to - at), heading);
      least = std::min(least, problem.world().clearance(problem.footprint(), pose, 1.0).clearance);
    }
    if (claimed) {
      ASSERT_GT(least, margin);
    } else {
      ASSERT_LT(least, margin + 0.01);
    }
    ++(claimed ? free : blocked);
  }
  EXPECT_GT(free, 200);
  EXPECT_GT(blocked, 200);
}

// A search by hand over the same states: Dijkstra with a map, every move asked of the World.
TEST(HeadingSearch, CostsWhatAPlainSearchOverAllStatesCosts) {
  Random random{6};
  int found = 0;
  for (int i = 0; i < 40; ++i) {
    Scenario s = random_scenario(random, i % 2 == 0, i % 4 == 1);
    s.vehicle.footprint = {with_a_notch, 0.0};
    const Problem problem = Problem::prepare(s).value();
    const GridFrame frame = make_grid_frame(problem, i % 2 == 0 ? 0.0 : 0.3).value();
    const CellBounds bounds{problem, frame};
    const Neighbours neighbours = i % 4 == 0 ? Neighbours::sixteen : Neighbours::eight;
    const HeadingCosts costs{i % 3 == 0 ? 0.0 : 0.1, i % 5 == 0 ? 0.0 : 2.0};
    const HeadingSpace space{problem, frame, bounds, neighbours, costs};
    const int headings = space.headings();
    const auto id = [&](const HeadingState& h) { return static_cast<std::size_t>((h.cell.row * frame.columns + h.cell.column) * headings + h.heading); };
    MotionCheck test{problem};
    const double margin = lattice_margin(problem);
    const auto standing = [&](int heading) {
      HeadingState h;
      for (int tries = 0; tries < 500; ++tries) {
        h = {{static_cast<int>(random.integer(0, frame.columns - 1)), static_cast<int>(random.integer(0, frame.rows - 1))}, heading};
        if (test.is_drive_free(frame.centre(h.cell), frame.centre(h.cell), space.angle(heading), margin)) break;
      }
      return h;
    };
    const HeadingState start = standing(0), goal = standing(headings / 2);
    std::vector<double> cost(static_cast<std::size_t>(frame.columns * frame.rows * headings), 1e9);
    std::vector<HeadingState> open{start};
    cost[id(start)] = 0.0;
    while (!open.empty()) {
      const HeadingState at = open.back();
      open.pop_back();
      const auto reach = [&](const HeadingState& next, double step) {
        if (cost[id(at)] + step >= cost[id(next)] - 1e-12) return;
        cost[id(next)] = cost[id(at)] + step;
        open.insert(open.begin(), next);
      };
      const Move m = moves[static_cast<std::size_t>(space.move(at.heading))];
      for (const int direction : {1, -1}) {
        if (direction < 0 && costs.reverse == 0.0) continue;
        const Cell to{at.cell.column + direction * m.column, at.cell.row + direction * m.row};
        if (!frame.contains(to)) continue;
        if (!test.is_drive_free(frame.centre(at.cell), frame.centre(to), space.angle(at.heading), margin)) continue;
        const double way = std::sqrt(m.column * m.column + m.row * m.row) * frame.cell;
        reach({to, at.heading}, direction > 0 ? way : way * costs.reverse);
      }
      for (const int by : {1, -1}) {
        const int next = space.beside(at.heading, by);
        const double angle = by > 0 ? space.turn(at.heading) : -space.turn(next);
        if (test.is_turn_free(frame.centre(at.cell), space.angle(at.heading), angle, margin)) reach({at.cell, next}, costs.turn * std::abs(angle));
      }
    }
    const HeadingAnswer answer = HeadingSearch{}.run(space, {{start, 0.0}}, {{goal, 0.0}}, Heuristic::free_way, {}, nullptr, test);
    ASSERT_EQ(answer.ended == SearchEnd::found, cost[id(goal)] < 1e8) << i;
    if (answer.ended != SearchEnd::found) continue;
    ++found;
    ASSERT_NEAR(answer.cost, cost[id(goal)], 1e-3) << i;
  }
  EXPECT_GT(found, 5);
}

}  // namespace
}  // namespace waywright
