#include "waywright/planner/steering/arc_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/oracle/brute_force.hpp"
#include "waywright/core/random.hpp"
#include "waywright/planner/steering/reeds_shepp.hpp"
#include "waywright/planner/steering/shortcut.hpp"

namespace waywright {
namespace {

constexpr MotionTestLimits no_limits{1'000'000'000, 1'000'000'000, 0.001};

Pose random_pose(Random& random, double scale) {
  return {random.uniform(-scale, scale), random.uniform(-scale, scale), random.uniform(-pi, pi)};
}

Map random_map(Random& random) {
  Map map;
  for (int i = 0; i < 2; ++i) {
    const Vec2 half{random.uniform(0.1, 0.6), random.uniform(0.1, 0.6)};
    map.obstacles.push_back(transformed(rectangle(-half, half), Frame{random_pose(random, 5.0)}));
  }
  for (int i = 0; i < 3; ++i) map.points.push_back({random.uniform(-5, 5), random.uniform(-5, 5)});
  map.boundaries.push_back(rectangle({-9, -9}, {9, 9}));
  return map;
}

/// Start and goal far from everything that is tested here.
Problem problem_with(Map map, Footprint footprint, double clearance) {
  Scenario scenario;
  scenario.map = std::move(map);
  scenario.vehicle.footprint = std::move(footprint);
  scenario.vehicle.drive = Tricycle{1.9, 1.0, std::nullopt, SteeredAxle::rear};
  scenario.start = {50.0, 50.0, 0.0};
  scenario.mission = Pose{60.0, 50.0, 0.0};
  scenario.clearance = clearance;
  return Problem::prepare(scenario).value();
}

TEST(MotionTest, FreeMeansFreeAtEveryMillimetreAndBlockedMeansNearlyBlocked) {
  Random random{11};
  const ReedsShepp curves{1.3};
  const Footprint l_shape{{{-1.5, -0.6}, {0.8, -0.6}, {0.8, 0.0}, {-0.5, 0.0}, {-0.5, 0.6}, {-1.5, 0.6}},
                          0.0};
  const Footprint forklift{rectangle({-2.3, -0.45}, {0.4, 0.45}), 0.0};
  const Footprint disc{{}, 0.5};
  int free = 0;
  int blocked = 0;
  for (int i = 0; i < 240; ++i) {
    const Footprint& footprint = i % 3 == 0 ? l_shape : i % 3 == 1 ? forklift : disc;
    const double clearance = i % 2 == 0 ? 0.0 : random.uniform(0.0, 0.2);
    const Problem problem = problem_with(random_map(random), footprint, clearance);
    const Path path{curves.between(random_pose(random, 5.0), random_pose(random, 5.0))};
    Budget budget;
    MotionTest test{problem, no_limits, budget};
    const double truth = oracle_path_clearance(problem.world().map(), {}, {}, footprint, path, 0.002);
    if (test.motion_free(path.pieces)) {
      ++free;
      EXPECT_GT(truth, clearance) << "motion " << i;
      EXPECT_EQ(test.worst_blocker().name, "");
    } else {
      ++blocked;
      // Its own reserve and half of the last interval, on which no corner moves more than three times as far
      // as the origin.
      EXPECT_LE(truth, clearance + 1e-4 + 3.0 * 0.0005 + 0.001) << "motion " << i;
    }
  }
  EXPECT_GT(free, 40);
  EXPECT_GT(blocked, 40);
}

TEST(MotionTest, ThinWallsBetweenSamplesAreSeen) {
  Map map;
  map.lines.push_back({{2.0, -0.0005}, {2.0, 0.0005}});
  const Problem problem =
      problem_with(map, Footprint{{}, 0.0}, 0.0);  // a point against a wall of a millimetre
  Budget budget;
  MotionTest test{problem, no_limits, budget};
  const Pieces through{{Line{{0.0, 0.0}, {7.3, 0.0}}, 1}};
  const Pieces beside{{Line{{0.0, 0.01}, {7.3, 0.01}}, -1}};
  EXPECT_FALSE(test.motion_free(through));
  EXPECT_TRUE(test.motion_free(beside));
  EXPECT_EQ(test.worst_blocker().name, "line 0");
}

TEST(MotionTest, EndsThatJustKeepTheClearanceCanBeLeft) {
  Scenario scenario;
  scenario.map.lines.push_back({{1.0, -2.0}, {1.0, 2.0}});
  scenario.vehicle.footprint.polygon = rectangle({-1.0, -0.4}, {0.5, 0.4});
  scenario.start = {0.2, 0.0, 0.0};  // 0.3 m from the wall
  scenario.mission = Pose{-5.0, 0.0, 0.0};
  scenario.clearance = 0.3;
  const Problem problem = Problem::prepare(scenario).value();
  Budget budget;
  MotionTest test{problem, no_limits, budget};
  EXPECT_TRUE(test.pose_free(problem.start()));
  const Pieces away{{Line{{0.2, 0.0}, {-5.0, 0.0}}, -1}};
  EXPECT_TRUE(test.motion_free(away));
  const Pieces nearer{{Line{{0.2, 0.0}, {0.203, 0.0}}, 1}};
  EXPECT_FALSE(test.motion_free(nearer));
  // The same just-kept clearance anywhere else is not taken for free.
  const Pieces from_elsewhere{{Line{{0.2, 0.5}, {-5.0, 0.5}}, -1}};
  EXPECT_FALSE(test.motion_free(from_elsewhere));
}

TEST(MotionTest, LimitsAndCancelEndAMotion) {
  Map map;
  map.lines.push_back({{-100.0, 0.002}, {100.0, 0.002}});
  const Problem problem = problem_with(map, Footprint{{}, 0.0}, 0.0);
  const Pieces along{{Line{{0.0, 0.0}, {40.0, 0.0}}, 1}};
  Budget budget;
  MotionTest few{problem, {100, 10, 0.001}, budget};
  EXPECT_FALSE(few.motion_free(along));
  EXPECT_EQ(few.placements(), 100);
  EXPECT_TRUE(few.spent());
  MotionTest none{problem, {1'000'000, 0, 0.001}, budget};
  EXPECT_FALSE(none.motion_free(along));
  EXPECT_EQ(none.placements(), 0);
  const std::atomic<bool> canceled{true};
  Budget stopped{{}, &canceled};
  MotionTest test{problem, no_limits, stopped};
  EXPECT_FALSE(test.motion_free(along));
  EXPECT_EQ(test.placements(), 0);
  MotionTest enough{problem, no_limits, budget};
  EXPECT_TRUE(enough.motion_free(along));
}

TEST(Shortcut, NeverLongerAlwaysFreeAndTheSameEnds) {
  Random random{12};
  const ReedsShepp curves{1.3};
  const Footprint forklift{rectangle({-2.3, -0.45}, {0.4, 0.45}), 0.0};
  int shorter = 0;
  int tried = 0;
  for (int i = 0; i < 400 && tried < 40; ++i) {
    const Problem problem = problem_with(random_map(random), forklift, 0.05);
    Budget budget;
    MotionTest test{problem, no_limits, budget};
    Path path;
    Pose at = random_pose(random, 5.0);
    for (int k = 0; k < 3; ++k) {
      const Pose to = random_pose(random, 5.0);
      for (const Piece& piece : curves.between(at, to)) append_merged(path.pieces, piece);
      at = to;
    }
    if (!test.motion_free(path.pieces)) continue;
    ++tried;
    const Path better = shortened(path, *make_steering(SteeringKind::reeds_shepp, {.radius = curves.radius()}), test, 200, 7);
    EXPECT_LE(length(better), length(path));
    shorter += length(better) < 0.9 * length(path) ? 1 : 0;
    EXPECT_LT(distance(start_pose(better).position(), start_pose(path).position()), 1e-9);
    EXPECT_LT(distance(end_pose(better).position(), end_pose(path).position()), 1e-9);
    EXPECT_LT(std::abs(shorter_turn(end_pose(better).heading, end_pose(path).heading)), 1e-9);
    for (std::size_t k = 1; k < better.pieces.size(); ++k) {
      EXPECT_LT(distance(end_pose(better.pieces[k - 1]).position(), start_pose(better.pieces[k]).position()),
                1e-8);
    }
    EXPECT_GT(oracle_path_clearance(problem.world().map(), {}, {}, forklift, better, 0.005), 0.05);
  }
  EXPECT_GE(tried, 10);
  EXPECT_GE(shorter, tried / 2);
}

}  // namespace
}  // namespace waywright
