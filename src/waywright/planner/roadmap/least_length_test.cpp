#include "waywright/planner/roadmap/least_length.hpp"

#include <gtest/gtest.h>

#include "waywright/core/random.hpp"
#include "waywright/planner/roadmap/tangent_graph.hpp"

namespace waywright {
namespace {

/// Boxes on a grid, a little out of place, so many that their corners are more than are searched whole.
Scenario crowd(int side, Random& random) {
  Scenario s;
  const double size = 1.5 * side;
  s.map.boundaries = {rectangle({-1, -1}, {size + 1, size + 1})};
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const Vec2 low{1.5 * i + random.uniform(0.1, 0.3), 1.5 * j + random.uniform(0.1, 0.3)};
      s.map.obstacles.push_back(rectangle(low, low + Vec2{random.uniform(0.4, 0.8), random.uniform(0.4, 0.8)}));
    }
  }
  s.vehicle.footprint = {{}, 0.1};
  s.vehicle.drive = Differential{0.2};
  s.start = {-0.5, -0.5, 0.0};
  s.mission = Pose{size + 0.5, size + 0.5, 0.0};
  return s;
}

TEST(LeastLength, ASearchThatIsEndedTellsABound) {
  Random random{3};
  const Problem problem = Problem::prepare(crowd(12, random)).value();
  const PlaneSpace space{problem};
  const TangentGraph graph{space, 0.1, 0.0999995, Rounding::optimistic};
  const PlaneTarget goal = target_of(problem, problem.goal().position());
  Budget budget;
  const TangentAnswer whole = graph.shortest(problem.start().position(), goal, budget);
  ASSERT_EQ(whole.ended, TangentEnd::found);
  const double straight = distance(problem.start().position(), problem.goal().position());
  double before = straight;
  int grew = 0;
  for (std::int64_t expansions = 1; expansions < whole.expansions; expansions = 2 * expansions) {
    const TangentAnswer part = graph.shortest(problem.start().position(), goal, budget, expansions);
    ASSERT_EQ(part.ended, TangentEnd::expansions);
    EXPECT_LE(part.least, whole.way.length + 1e-9);
    EXPECT_GE(part.least, before - 1e-9);
    grew += part.least > before + 1e-6 ? 1 : 0;
    before = part.least;
  }
  EXPECT_GT(grew, 1);
}

TEST(LeastLength, OfVeryManyCornersItIsLessThanTheWayAndMoreThanTheLine) {
  Random random{4};
  Scenario scenario = crowd(30, random);  // 3600 corners
  // A wall that the straight line crosses: the way about its end is longer by metres.
  scenario.map.obstacles.push_back(rectangle({-1.0, 20.0}, {40.0, 20.1}));
  const Problem problem = Problem::prepare(scenario).value();
  const PlaneSpace space{problem};
  Budget budget;
  const LeastLength least = least_length(space, budget);
  const double straight = distance(problem.start().position(), problem.goal().position());
  EXPECT_FALSE(least.is_straight);
  EXPECT_GT(least.metres, straight + 0.01);
  // Along the edge of the hall, past the wall's end.
  const Vec2 start = problem.start().position(), corner{45.5, -0.5}, goal = problem.goal().position();
  ASSERT_TRUE(space.is_free(start, corner) && space.is_free(corner, goal));
  const double around = distance(start, corner) + distance(corner, goal);
  EXPECT_LE(least.metres, around);
  ASSERT_TRUE(least.is_partial);
  EXPECT_NE(bound_sentence(least, around).find("searched in part"), std::string::npos);
}

}  // namespace
}  // namespace waywright
