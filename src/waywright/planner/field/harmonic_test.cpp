#include "waywright/planner/field/harmonic.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

GridFrame frame_of(int columns, int rows) { return {Frame{Pose{0, 0, 0}}, 1.0, columns, rows, false, 0}; }

constexpr Cell sides[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

struct Maze {
  GridFrame frame;
  std::vector<std::uint8_t> blocked;
  bool is_free(Cell c) const { return frame.contains(c) && blocked[static_cast<std::size_t>(c.row * frame.columns + c.column)] == 0; }
};

Maze random_maze(Random& random, double share) {
  Maze maze{frame_of(40, 30), std::vector<std::uint8_t>(1200, 0)};
  for (auto& b : maze.blocked) b = random.uniform() < share ? 1 : 0;
  return maze;
}

HarmonicField field_on(const Maze& maze, Cell goal, double absorption) {
  return {maze.frame, {goal}, [&](Cell c) { return maze.is_free(c); }, [](Cell, Cell) { return true; }, {.absorption = absorption}};
}

// The law, on random mazes and long corridors: who has a value has a neighbour with a greater one.
TEST(HarmonicField, HasNoLocalMaximumButTheGoal) {
  Random random{1};
  for (int map = 0; map < 100; ++map) {
    const Maze maze = random_maze(random, 0.35);
    const Cell goal{static_cast<int>(random.integer(0, 39)), static_cast<int>(random.integer(0, 29))};
    if (!maze.is_free(goal)) continue;
    const double absorption = map % 3 == 0 ? 1.0 : map % 3 == 1 ? 0.1 : 0.001;
    const HarmonicField field = field_on(maze, goal, absorption);
    for (int row = 0; row < 30; ++row) {
      for (int column = 0; column < 40; ++column) {
        const Cell c{column, row};
        const double w = field.at(c);
        if (w == 0.0 || c == goal) continue;
        bool rises = false;
        double sum = 0.0, weight = 0.0;
        for (const Cell d : sides) {
          const Cell to{column + d.column, row + d.row};
          rises = rises || field.at(to) > w;
          sum += field.at(to);
          weight += maze.is_free(to) ? 1.0 : absorption;
        }
        ASSERT_TRUE(rises) << column << ", " << row;
        ASSERT_NEAR(sum / weight, w, 1e-9 * w);  // what it is defined by, to its own size
      }
    }
  }
}

TEST(HarmonicField, ReachesWhatIsConnectedAndNothingElse) {
  Maze maze{frame_of(9, 3), std::vector<std::uint8_t>(27, 0)};
  for (int row = 0; row < 3; ++row) maze.blocked[static_cast<std::size_t>(row * 9 + 4)] = 1;
  const HarmonicField field = field_on(maze, {0, 1}, 0.5);
  EXPECT_EQ(field.unknowns(), 11);
  EXPECT_GT(field.at(Cell{3, 2}), 0.0);
  EXPECT_EQ(field.at(Cell{5, 1}), 0.0);
  EXPECT_EQ(field.at(Cell{0, 1}), 1.0);
}

// A corridor one cell wide: w falls by one factor with each cell, λ + 1/λ = 2 + 2a with a of absorption on each side.
TEST(HarmonicField, FadesInACorridorAsTheClosedFormSays) {
  Maze maze{frame_of(400, 1), std::vector<std::uint8_t>(400, 0)};
  const double a = 0.1, b = 1.0 + a, rate = b - std::sqrt(b * b - 1.0);
  const HarmonicField field = field_on(maze, {0, 0}, a);
  for (const int column : {1, 10, 100, 300}) EXPECT_NEAR(field.at(Cell{column, 0}) / std::pow(rate, column), 1.0, 1e-9) << column;
}

TEST(HarmonicField, SlopeIsThatOfFiniteDifferences) {
  Random random{3};
  const Maze maze = random_maze(random, 0.2);
  const HarmonicField field = field_on(maze, {20, 15}, 0.1);
  for (int i = 0; i < 500; ++i) {
    const Vec2 q{random.uniform(0, 40), random.uniform(0, 30)};
    constexpr double h = 1e-6;
    if (std::floor(q.x - 0.5 - h) != std::floor(q.x - 0.5 + h) || std::floor(q.y - 0.5 - h) != std::floor(q.y - 0.5 + h)) continue;
    const auto value = field.at(q);
    EXPECT_NEAR(value.gradient.x, (field.at(q + Vec2{h, 0}).w - field.at(q - Vec2{h, 0}).w) / (2 * h), 1e-8);
    EXPECT_NEAR(value.gradient.y, (field.at(q + Vec2{0, h}).w - field.at(q - Vec2{0, h}).w) / (2 * h), 1e-8);
  }
}

}  // namespace
}  // namespace waywright
