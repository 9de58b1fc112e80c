// `danger_astar`, `block_astar` and `safe_astar` from problem to proven plan.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/grid_scenarios.hpp"
#include "waywright/core/random.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/map/published_maps.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {
namespace {

using namespace waywright::test;

/// The publication's robot, a point, on one of its maps.
Scenario published(const char* name, double radius = 0.0, std::size_t task = 0) {
  const PublishedMap map = published_map(name).value();
  Scenario s;
  s.name = name;
  s.map.grids = {map.grid};
  s.vehicle.footprint = {{}, radius};
  s.vehicle.drive = Differential{0.6};
  s.vehicle.limits.angular_speed = 1.0;
  s.start = make_pose(map.tasks[task].start, 0.0);
  s.mission = make_pose(map.tasks[task].goal, 0.0);
  return s;
}

const Footprint box{{{-0.35, -0.25}, {0.3, -0.25}, {0.3, 0.25}, {-0.35, 0.25}}, 0.0};

// Of the corrected forms nothing is left for the proof to refuse, and they find a way where `astar` finds one for the disc.
TEST(SafePlanner, EveryCorrectedWayIsProven) {
  Random random{77};
  int solved = 0, straight = 0;
  for (int i = 0; i < 40; ++i) {
    Scenario s = hall(random, i % 3 == 0 ? box : disc, i % 4 == 0 ? 0.0 : 0.05, 14);
    if (i % 5 == 0) s.pose_error = {0.01, 0.01, 0.01};
    const Plan any = planned(s, "theta_star", {{"resolution", 0.2}});
    for (const char* name : {"danger_astar", "block_astar", "safe_astar"}) {
      SCOPED_TRACE(testing::Message() << i << " " << name);
      const Plan plan = planned(s, name, {{"resolution", 0.2}});
      ASSERT_NE(plan.status, Status::unproven) << plan.reason;
      ASSERT_EQ(plan.status, any.status) << plan.reason << " / " << any.reason;
      if (plan.status != Status::solved) {
        ASSERT_FALSE(plan.reason.empty());
        continue;
      }
      ++solved;
      straight += plan.explanation.front().find("From corner to corner") == 0 ? 1 : 0;
      ASSERT_GE(plan.certificate.clearance, s.clearance);
      const Plan read = parse_plan(plan_json(plan), "plan.json").value();
      ASSERT_TRUE(verify(read)->holds);
    }
  }
  EXPECT_GT(solved, 60);
  EXPECT_GT(straight, 5);
}

Scenario room_of(double width, double height, Vec2 start, Vec2 goal) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {width, height})};
  s.vehicle.footprint = {{}, 0.3};
  s.vehicle.drive = Differential{0.5};
  s.start = make_pose(start, 0.0);
  s.mission = make_pose(goal, 0.0);
  return s;
}

// The end of a detour lies inside a closed box of walls: free, and nowhere to go.
TEST(SafePlanner, DetoursThatLeadNowhereGrow) {
  Scenario s = room_of(40, 40, {2, 20}, {38, 20});
  s.map.lines = {{{10, 10}, {30, 10}, {30, 30}, {10, 30}, {10, 10}}};
  const Plan plan = planned(s, "block_astar", {{"resolution", 0.2}});
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  EXPECT_GT(plan.metrics.length, 40.0);
  EXPECT_NE(plan.explanation.front().find("longer where such a stretch led nowhere"), std::string::npos) << plan.explanation.front();
}

// The cell that the last boundary point joins may be seen from, and not be reached: one-way zones.
TEST(SafePlanner, WhereTheLastPointCannotBeReachedItSearchesAllTheWay) {
  Scenario s = room_of(40, 20, {2, 12}, {38, 12});
  s.map.obstacles = {rectangle({15, 6}, {17, 16})};
  const auto one_way = [&](Ring area, double direction) {
    Zone z;
    z.type = ZoneType::directed;
    z.area = std::move(area);
    z.direction = direction;
    s.zones.push_back(std::move(z));
  };
  one_way(rectangle({12, 16.02}, {17.2, 20}), pi);
  one_way(rectangle({17.2, 15.8}, {40, 20}), 1.3089969389957472);
  one_way(rectangle({17.0, 13.0}, {40, 15.8}), -0.5 * pi);
  const Plan safe = planned(s, "safe_astar", {{"resolution", 0.2}}), danger = planned(s, "danger_astar", {{"resolution", 0.2}, {"neighbours", 16.0}});
  ASSERT_EQ(danger.status, Status::solved) << danger.reason;
  ASSERT_EQ(safe.status, Status::solved) << safe.reason;
  EXPECT_NEAR(safe.metrics.length, danger.metrics.length, 1e-6);
}

TEST(SafePlanner, WhatIsFreeStraightOnIsDrivenStraight) {
  // The start stands nearer to a wall than straight parts keep.
  const Plan safe = planned(room_of(20, 10, {0.35, 5}, {17, 5}), "safe_astar", {{"resolution", 0.2}});
  ASSERT_EQ(safe.status, Status::solved) << safe.reason;
  EXPECT_NEAR(safe.metrics.length, 16.65, 1e-6);
  // An obstacle beside the line: cells are too near by their bounds alone.
  Scenario s = room_of(20, 10, {2, 5}, {18, 5});
  s.map.obstacles = {rectangle({8, 5.35}, {10, 7})};
  const Plan block = planned(s, "block_astar", {{"resolution", 0.2}});
  ASSERT_EQ(block.status, Status::solved) << block.reason;
  EXPECT_NEAR(block.metrics.length, 16.0, 1e-6);
  EXPECT_EQ(block.effort.expansions, 0);
}

// A corridor one cell wide that the robot fits: published forms go through, as they should.
TEST(SafePlanner, PublishedFormsEnterEveryCellThatTheRobotFits) {
  Scenario s;
  CellGrid grid;
  grid.name = "corridor";
  grid.columns = 9;
  grid.rows = 5;
  grid.cell = 1.0;
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 9; ++column) grid.blocked.push_back(row == 2 ? 0 : 1);
  }
  s.map.grids = {grid};
  s.vehicle.footprint = {{}, 0.4};
  s.vehicle.drive = Differential{0.5};
  s.start = {1.5, 2.5, 0.0};
  s.mission = Pose{7.5, 2.5, 0.0};
  for (const char* name : {"danger_astar", "block_astar", "safe_astar"}) {
    const Plan plan = planned(s, name, {{"form", std::string{"published"}}});
    EXPECT_EQ(plan.status, Status::solved) << name << ": " << plan.reason;
    EXPECT_NEAR(plan.metrics.length, 6.0, 1e-6);
  }
}

TEST(SafePlanner, DangerKeepsAwayAndCostsLength) {
  for (const char* map : {"SA-CONVEX", "SA-RAND1", "SA-RAND3"}) {
    SCOPED_TRACE(map);
    const Scenario s = published(map, 0.4);
    const Plan near = planned(s, "astar"), far = planned(s, "danger_astar");
    ASSERT_EQ(near.status, Status::solved) << near.reason;
    ASSERT_EQ(far.status, Status::solved) << far.reason;
    EXPECT_GE(far.metrics.length, near.metrics.length - 1e-9);
    EXPECT_LT(far.metrics.collision_risk, near.metrics.collision_risk);
    const Plan indifferent = planned(s, "danger_astar", {{"danger_weight", 0.0}});
    EXPECT_NEAR(indifferent.metrics.length, near.metrics.length, 1e-6);
  }
}

TEST(SafePlanner, BoundaryPointsHoldForAVehicleToo) {
  for (const char* map : {"SA-CONVEX", "SA-NARROW", "SA-RAND1"}) {
    SCOPED_TRACE(map);
    const Scenario s = published(map, 0.4);
    const Plan sha = planned(s, "safe_astar"), astar = planned(s, "astar"), danger = planned(s, "danger_astar", {{"neighbours", 16.0}});
    ASSERT_EQ(sha.status, Status::solved) << sha.reason;
    EXPECT_EQ(sha.explanation.front().find("From corner to corner"), 0U) << sha.explanation.front();
    EXPECT_LT(sha.metrics.length, astar.metrics.length);
    EXPECT_LT(sha.metrics.length, danger.metrics.length);
    EXPECT_LT(sha.effort.expansions, danger.effort.expansions);
  }
}

TEST(SafePlanner, PublishedFormsComeAsTheyAre) {
  // The publication's robot goes past single corners of blocked cells: a point touches them.
  const Plan danger = planned(published("SA-CONVEX"), "danger_astar", {{"form", std::string{"published"}}});
  EXPECT_NEAR(danger.metrics.length, 383.89, 0.01);
  const Plan shortest = planned(published("SA-RAND1"), "block_astar", {{"form", std::string{"published"}}});
  ASSERT_FALSE(shortest.samples.empty());
  EXPECT_EQ(shortest.status, Status::unproven) << "a corner is passed";
  const Plan sha = planned(published("SA-NARROW"), "safe_astar", {{"form", std::string{"published"}}});
  EXPECT_EQ(sha.status, Status::solved) << sha.reason;
  EXPECT_NEAR(sha.metrics.length, 405.76, 0.01);
  // Corrected, the point is proven.
  for (const char* name : {"danger_astar", "block_astar", "safe_astar"}) EXPECT_EQ(planned(published("SA-RAND1"), name).status, Status::solved) << name;
}

TEST(SafePlanner, RegularObstaclesAreWhereTheIrregularOnesWere) {
  const Scenario s = published("SA-IRR", 0.4);
  const Plan as_they_are = planned(s, "safe_astar"), regular = planned(s, "safe_astar", {{"regularise", true}});
  ASSERT_EQ(as_they_are.status, Status::solved) << as_they_are.reason;
  ASSERT_EQ(regular.status, Status::solved) << regular.reason;
  EXPECT_NE(as_they_are.metrics.length, regular.metrics.length);
  const auto tells = [](const Plan& plan) {
    return std::count(plan.explanation.begin(), plan.explanation.end(), "Rectangles stood in place of obstacles that are not convex while it was searched, except where start or goal would be in one.");
  };
  EXPECT_EQ(tells(regular), 1);
  EXPECT_EQ(tells(as_they_are), 0);
}

TEST(SafePlanner, WhatCannotBeReachedFailsWithItsReason) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {10, 8})};
  s.map.obstacles = {rectangle({6, 0.01}, {6.2, 7.99})};
  s.vehicle.footprint = disc;
  s.vehicle.drive = Differential{0.5};
  s.start = {1, 1, 0};
  s.mission = Pose{9, 7, 0};
  for (const char* name : {"danger_astar", "block_astar", "safe_astar"}) {
    for (const char* form : {"corrected", "published"}) {
      const Plan plan = planned(s, name, {{"form", std::string{form}}});
      EXPECT_EQ(plan.status, Status::no_path) << name << form;
      EXPECT_NE(plan.reason.find("no way over cells"), std::string::npos) << plan.reason;
    }
  }
}

TEST(SafePlanner, RefusesWhatCannotTurnOnTheSpot) {
  Scenario s = published("SA-RAND1");
  s.vehicle.drive = Tricycle{1.0, 1.0};
  for (const char* name : {"danger_astar", "block_astar", "safe_astar"}) {
    const auto taken = check_mission(name, s);
    ASSERT_FALSE(taken);
    EXPECT_EQ(taken.error().message().rfind("planner.name: " + std::string{name} + " plans straight lines with turns on the spot, which a tricycle cannot drive (allowed: ", 0), 0U)
        << taken.error().message();
  }
}

}  // namespace
}  // namespace waywright
