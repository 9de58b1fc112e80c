// The planner `global_local` among what comes to stand, beside the goal too: random halls, and the single cases that they are made of.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "tests/moving_oracle.hpp"
#include "waywright/core/random.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/field/global_local.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

Vehicle mecanum() {
  Vehicle v;
  v.footprint = {rectangle({-0.29, -0.19}, {0.29, 0.19}), 0.0};
  v.drive = Mecanum{0.0475, 0.235, 0.15};
  v.limits.speed = v.limits.reverse_speed = 0.8;
  v.limits.acceleration = v.limits.deceleration = 1.0;
  v.limits.lateral_acceleration = 1.0;
  v.limits.angular_speed = 1.5;
  v.limits.angular_acceleration = 3.0;
  return v;
}
Vehicle differential(bool is_smooth) {
  Vehicle v;
  v.footprint = {{}, 0.35};
  v.drive = Differential{0.45};
  v.limits.speed = 1.2;
  v.limits.acceleration = v.limits.deceleration = 1.0;
  v.limits.angular_speed = 1.5;
  if (is_smooth) v.limits.angular_acceleration = 2.0;
  return v;
}

Scenario hall(double width, double length, Vehicle vehicle, Pose start, Pose goal) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {length, width})};
  s.vehicle = std::move(vehicle);
  s.start = start;
  s.mission = goal;
  s.planner.name = "global_local";
  return s;
}

MovingObstacle person(std::vector<MovingObstacle::Place> track, double radius = 0.3, Vec2 velocity = {}) {
  MovingObstacle obstacle;
  obstacle.name = "person";
  obstacle.footprint = {{}, radius};
  obstacle.track = std::move(track);
  obstacle.velocity = velocity;
  return obstacle;
}

struct Result {
  Plan plan;
  bool is_by_field = false;
};

Result planned(const Scenario& s) {
  const Problem problem = Problem::prepare(s).value();
  Budget budget;
  PlanningResult result = GlobalLocalPlanner{GlobalLocalOptions{}}.prepared(problem).plan(problem, budget);
  if (!result) return {failed_plan(problem, result.error().failure), false};
  const bool is_by_field = result->pace.has_value();
  Plan plan = judge(problem, problem.whole_path(std::move(result->path)), nullptr, {}, result->pace ? &*result->pace : nullptr);
  plan.explanation = std::move(result->explanation);
  return {std::move(plan), is_by_field};
}

void expect_sound(const Plan& plan) {
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  const Problem problem = Problem::prepare(plan.scenario).value();
  const Verification verification = verify(problem, plan);
  EXPECT_TRUE(verification.holds) << verification.findings.front();
  EXPECT_GT(oracle::least_in_time(plan, plan.scenario.vehicle.footprint, 0.02), plan.scenario.clearance);
}

/// A hall of some size, with boxes and people: of eight one comes to stand beside the goal, one somewhere, one stands; the others go through everything.
Scenario standing(std::uint64_t seed, int people) {
  Random random{77'000 + seed};
  const double length = random.uniform(8.0, 16.0), width = random.uniform(5.0, 12.0);
  Vehicle vehicle = seed % 4 == 0 ? differential(true) : seed % 4 == 2 ? differential(false) : mecanum();
  if (seed % 4 == 3) vehicle.footprint = {{}, 0.25};
  const Pose start{1.0, random.uniform(1.0, width - 1.0), random.uniform(-3.0, 3.0)};
  Scenario s = hall(width, length, vehicle, start, {length - 1.0, random.uniform(1.0, width - 1.0), random.uniform(-3.0, 3.0)});
  const int boxes = static_cast<int>(random.uniform(0.0, 4.0));
  for (int k = 0; k < boxes; ++k) {
    const Vec2 at{random.uniform(2.5, length - 4.0), random.uniform(0.5, width - 1.5)};
    s.map.obstacles.push_back(rectangle(at, at + Vec2{random.uniform(0.3, 1.5), random.uniform(0.3, 1.0)}));
  }
  const Vec2 goal = std::get<Pose>(s.mission).position();
  for (int k = 0; k < people; ++k) {
    Vec2 from{};
    do {
      from = {random.uniform(0.5, length - 0.5), random.uniform(0.5, width - 0.5)};
    } while (distance(from, s.start.position()) < 1.5);
    Vec2 to{random.uniform(0.5, length - 0.5), random.uniform(0.5, width - 0.5)};
    const double begins = random.uniform(0.0, 10.0), radius = random.uniform(0.15, 0.4);
    if (k % 8 == 0) to = goal + random.uniform(radius + 0.5, radius + 1.3) * unit(random.uniform(-3.14, 3.14));
    if (k % 8 < 2) {
      s.moving.push_back(person({{begins, make_pose(from, 0.0)}, {begins + distance(from, to) / random.uniform(0.3, 1.3), make_pose(to, 1.0)}}, radius));
    } else if (k % 8 == 2) {
      if (distance(from, goal) < 0.9) from = goal + Vec2{-1.2, 0.0};
      s.moving.push_back(person({{0.0, make_pose(from, random.uniform(-3.0, 3.0))}}, radius));
    } else {
      s.moving.push_back(person({{begins, make_pose(from, 0.0)}}, radius, random.uniform(0.2, 1.3) * unit(random.uniform(-3.14, 3.14))));
    }
    if (k % 3 == 2) s.moving.back().footprint = {rectangle({-0.4, -0.3}, {0.4, 0.3}), 0.0};
    if (k % 4 == 1) s.moving.back().patience = random.uniform(0.0, 20.0);
  }
  if (seed % 4 == 3) s.clearance = 0.05;
  if (seed % 5 == 4) s.pose_error = {0.01, 0.01, 0.005};
  if (seed % 7 == 6) s.moving.front().spread = 0.01;
  return s;
}

struct Tally {
  int solved = 0, by_field = 0;
};

Tally halls(int first, int seeds, int people) {
  Tally tally;
  double seconds = 0.0, metres = 0.0;
  for (int seed = first; seed < first + seeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << people << " that move");
    const Result result = planned(standing(static_cast<std::uint64_t>(seed), people));
    if (result.plan.status != Status::solved) {
      EXPECT_FALSE(result.plan.reason.empty());
      continue;
    }
    ++tally.solved;
    tally.by_field += result.is_by_field ? 1 : 0;
    seconds += result.plan.metrics.travel_time;
    metres += result.plan.metrics.length;
    expect_sound(result.plan);
  }
  std::cout << people << " that move or stand: solved " << tally.solved << " of " << seeds << ", by the field " << tally.by_field << "; driven " << metres / std::max(1, tally.solved) << " m in " << seconds / std::max(1, tally.solved) << " s\n";
  return tally;
}

TEST(GlobalLocalStanding, WhatIsSolvedAmongThemIsProven) {
  EXPECT_GE(halls(0, 3, 8).by_field, 3);
  EXPECT_GE(halls(100, 1, 20).by_field, 1);
}

TEST(GlobalLocalStanding, FullManyHalls) {
  EXPECT_GE(halls(0, 40, 8).by_field, 36);
  EXPECT_GE(halls(100, 40, 20).by_field, 31);
}

/// s, of the way to a goal in the middle of a hall, beside which somebody leaves so much room, from the start on or from 4 s on.
double time_beside_one(Vec2 towards, double room, bool comes) {
  Scenario s = hall(6.0, 12.0, mecanum(), {1.0, 3.0, 0.0}, {10.5, 3.0, 0.0});
  const Pose beside = make_pose(Vec2{10.5, 3.0} + (s.vehicle.footprint.radius() + 0.3 + 0.03 + room) * towards, 0.0);
  s.moving = {comes ? person({{0.0, {10.5, 5.5, 0.0}}, {4.0, beside}}) : person({{0.0, beside}})};
  const Result result = planned(s);
  expect_sound(result.plan);
  EXPECT_TRUE(result.is_by_field);
  return result.plan.metrics.travel_time;
}

// Nobody is waited for who stands beside the goal, and nobody pushes the vehicle off it.
TEST(GlobalLocalStanding, OneBesideTheGoalIsNotInTheWay) {
  Scenario s = hall(6.0, 12.0, mecanum(), {1.0, 3.0, 0.0}, {10.5, 3.0, 0.0});
  s.moving = {person({{0.0, {1.0, 5.6, 0.0}}})};  // nowhere near
  const double alone = planned(s).plan.metrics.travel_time;
  for (const double room : {0.03, 0.2, 0.5}) {
    for (const bool comes : {false, true}) EXPECT_LT(time_beside_one({0.0, 1.0}, room, comes), alone + 0.02) << room << comes;
    EXPECT_LT(time_beside_one({1.0, 0.0}, room, false), alone + 0.2) << room;  // beyond the goal
  }
}

// Who stands on the goal for good is told of, and nothing is simulated to find it out.
TEST(GlobalLocalStanding, AGoalThatStaysTakenIsToldOfAtOnce) {
  Scenario s = hall(6.0, 12.0, mecanum(), {1.0, 3.0, 0.0}, {10.5, 3.0, 0.0});
  s.moving = {person({{0.0, {10.5, 5.0, 0.0}}, {4.0, {10.5, 3.2, 0.0}}})};
  const Problem problem = Problem::prepare(s).value();
  Budget budget;
  const PlanningResult result = GlobalLocalPlanner{GlobalLocalOptions{}}.plan(problem, budget);
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->pace.has_value());
  EXPECT_LT(budget.evaluations(), 10);  // of motions it would be hundreds
  EXPECT_NE(result->shortcoming.find("person stands at the goal for good from 4.0 s after the start on"), std::string::npos) << result->shortcoming;
  s.moving.front().track.push_back({30.0, {10.5, 3.2, 0.0}});  // until it leaves
  s.moving.front().track.push_back({34.0, {10.5, 5.4, 0.0}});
  const Result later = planned(s);
  expect_sound(later.plan);
  EXPECT_GT(later.plan.metrics.travel_time, 30.0);
}

}  // namespace
}  // namespace waywright
