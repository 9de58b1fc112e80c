// Plans among obstacles that move: where they stop, when they go on, what is proven of it, what is said where nothing serves.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/grid_scenarios.hpp"
#include "tests/moving_oracle.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/replan_seen.hpp"
#include "waywright/planner/rest_of_plan.hpp"

namespace waywright {
namespace {

constexpr double radius = 0.2, person = 0.3;

/// A disc that drives 12 m along x at 1 m/s, 0.5 m/s².
Scenario straight(double width, std::vector<MovingObstacle> moving) {
  Scenario s;
  s.map.boundaries = {rectangle({-1, -0.5 * width}, {13, 0.5 * width})};
  s.vehicle.footprint = {{}, radius};
  s.vehicle.drive = Differential{0.4};
  s.vehicle.limits.speed = 1.0;
  s.vehicle.limits.acceleration = 0.5;
  s.vehicle.limits.deceleration = 0.5;
  s.vehicle.limits.angular_speed = 1.0;
  s.start = {0, 0, 0};
  s.mission = Pose{12, 0, 0};
  s.moving = std::move(moving);
  s.planner.name = "visibility_graph";
  return s;
}

MovingObstacle walker(std::vector<MovingObstacle::Place> track, Vec2 velocity = {}) {
  MovingObstacle obstacle;
  obstacle.name = "person";
  obstacle.footprint = {{}, person};
  obstacle.track = std::move(track);
  obstacle.velocity = velocity;
  return obstacle;
}

Plan planned(Scenario s) { return *solve(Problem::prepare(std::move(s)).value()); }

bool says(const Plan& plan, const std::string& words) {
  for (const std::string& sentence : plan.explanation) {
    if (sentence.find(words) != std::string::npos) return true;
  }
  return false;
}

void expect_sound(const Plan& plan) {
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  EXPECT_GT(oracle::least_in_time(plan, plan.scenario.vehicle.footprint, 0.01), plan.scenario.clearance);
  const Verification verification = verify(parse_plan(plan_json(plan), "p.json").value()).value();
  EXPECT_TRUE(verification.holds) << verification.findings.front();
}

TEST(Moving, WhatPassesBeforeOrBehindChangesNothing) {
  const Plan free = planned(straight(6.0, {}));
  for (const double y : {-30.0, -1.0e-3}) {  // comes when the vehicle has arrived, is gone before it starts
    const Plan plan = planned(straight(6.0, {walker({{0.0, {6.0, y < -1.0 ? y : 2.0, 0.0}}}, {0.0, 1.0})}));
    expect_sound(plan);
    EXPECT_TRUE(plan.waits.empty());
    EXPECT_EQ(plan.samples.back().t, free.samples.back().t);
  }
}

TEST(Moving, ItStopsOneMetreBeforeWhatCrossesAndGoesOnASecondAfterIt) {
  // It stands at (5, 0) until 20 s, then leaves at 1 m/s. The next metre of way, with the disc about it, touches it from x = 5 − 0.5 − 1 on. As it goes on the vehicle speeds up
  // from rest: its way ahead ends at 4.5 then, so what it meets first is what is left of the disc beside the line: gone when the middles are half a metre apart.
  const Plan plan = planned(straight(6.0, {walker({{0.0, {5.0, 0.0, 0.0}}, {20.0, {5.0, 0.0, 0.0}}}, {0.0, 1.0})}));
  expect_sound(plan);
  ASSERT_EQ(plan.waits.size(), 1U);
  const Wait& wait = plan.waits.front();
  EXPECT_LE(wait.s, 3.5);
  EXPECT_GT(wait.s, 3.5 - 0.12);  // samples are 5 cm apart, and a step is looked at whole
  EXPECT_GE(wait.until, 21.0);  // 20 s, and the second that it has to be free for
  EXPECT_LE(wait.until, 20.0 + std::sqrt(0.5 * 0.5) + 1.0 + 0.1);
  // From rest: 3.5 m in 2 s of speeding up, 2 s of slowing down and 1.5 m at 1 m/s.
  EXPECT_NEAR(wait.from, 2.0 + 2.0 + (wait.s - 2.0), 0.02);
  EXPECT_NEAR(plan.samples.back().t, wait.until + 2.0 + 2.0 + (12.0 - wait.s - 2.0), 0.02);
  EXPECT_TRUE(says(plan, "the vehicle stops for person"));
  EXPECT_TRUE(says(plan, "Proven in time"));
}

TEST(Moving, WhileItMovesItsNextMetreIsClear) {
  Random random{11};
  int waited = 0;
  for (int i = 0; i < 150; ++i) {
    const double speed = random.uniform(0.2, 1.5), x = random.uniform(3.0, 10.0), y = random.uniform(-6.0, -1.0), aside = random.uniform(-0.5, 0.5);
    const Plan plan = planned(straight(20.0, {walker({{0.0, {x, y, 0.0}}}, {aside, speed})}));
    if (plan.status != Status::solved) continue;
    expect_sound(plan);
    waited += plan.waits.empty() ? 0 : 1;
    const bool may_be_late = !plan.waits.empty() && plan.waits.front().ahead < 1.0;
    for (double t = 0.0; t < plan.samples.back().t && !may_be_late; t += 0.02) {
      const oracle::Driven now = oracle::driven_at(plan.samples, t);
      if (!now.moves) continue;
      for (double ahead = 0.0; ahead <= std::min(0.99, 12.0 - now.s); ahead += 0.05) {
        EXPECT_GT(oracle::between({{}, radius}, {now.pose.x + ahead, now.pose.y, 0.0}, {{}, person}, oracle::obstacle_at(plan.scenario.moving[0], t)), 0.0) << i << " at " << t;
      }
    }
  }
  EXPECT_GT(waited, 10);
}

TEST(Moving, WhatStaysInTheWayIsLedAroundAfterItsPatience) {
  MovingObstacle cart = walker({{0.0, {6.0, -2.0, 0.0}}, {4.0, {6.0, 0.0, 0.0}}});
  cart.footprint = {rectangle({-0.4, -0.6}, {0.4, 0.6}), 0.0};
  cart.patience = 5.0;
  for (const char* planner : {"visibility_graph", "astar", "rrt_star"}) {
    Scenario s = straight(6.0, {cart});
    s.planner = {planner, {}};
    const Plan plan = planned(s);
    expect_sound(plan);
    ASSERT_FALSE(plan.waits.empty()) << planner;
    EXPECT_TRUE(plan.waits.front().stays);
    EXPECT_NEAR(plan.waits.front().until - plan.waits.front().from, 5.0, 0.3) << planner;
    EXPECT_GT(plan.metrics.length, 12.0);
    EXPECT_TRUE(says(plan, "stays in the way")) << planner;
    // What is said of the way before it is not said of this one; the detour has its own sentences, and one that holds the two against each other.
    EXPECT_TRUE(says(plan, "Before what moves was looked at: ")) << planner;
    EXPECT_TRUE(says(plan, "Of the detour: ")) << planner;
    EXPECT_TRUE(says(plan, "It leaves the old way after 4.")) << planner;
    EXPECT_TRUE(says(plan, " m longer (")) << planner;
    EXPECT_TRUE(says(plan, " m in place of 12.")) << planner;
    for (const std::string& sentence : plan.explanation) EXPECT_FALSE(sentence.starts_with("It is 12.") || sentence.starts_with("The ")) << sentence;
  }
}

TEST(Moving, WhatComesToMeetItIsPassedWhereThereIsRoom) {
  const Plan plan = planned(straight(6.0, {walker({{0.0, {11.0, 0.0, 0.0}}}, {-1.0, 0.0})}));
  expect_sound(plan);
  EXPECT_GT(plan.metrics.length, 12.0);
  EXPECT_TRUE(says(plan, "leads beside what it is predicted to sweep"));
}

TEST(Moving, WhereNothingServesItIsSaidWithFigures) {
  // No room around it.
  const Plan blocked = planned(straight(1.0, {walker({{0.0, {6.0, 0.0, 0.0}}})}));
  EXPECT_EQ(blocked.status, Status::unproven);
  EXPECT_NE(blocked.reason.find("person stands in the way for good"), std::string::npos) << blocked.reason;
  // It walks towards the vehicle, and into it.
  const Plan head_on = planned(straight(1.0, {walker({{0.0, {11.0, 0.0, 0.0}}}, {-1.0, 0.0})}));
  EXPECT_EQ(head_on.status, Status::unproven);
  EXPECT_NE(head_on.reason.find("person comes to where the vehicle stands"), std::string::npos) << head_on.reason;
  EXPECT_FALSE(verify(head_on).value().holds);
  // It appears too near to a vehicle that drives: 1 m to stop, 0.6 m to where they touch.
  const Plan old = planned(straight(6.0, {}));
  SeenObstacles seen;
  seen.moving = {walker({{0.0, {4.0 + 0.6 + radius + person, 0.0, 0.0}}})};
  const Plan late = replan(old, time_at(old.samples, 4.0), seen).value();
  EXPECT_EQ(late.status, Status::unproven);
  EXPECT_NE(late.reason.find("the vehicle needs 1.0"), std::string::npos) << late.reason;
  EXPECT_NE(late.reason.find("0."), std::string::npos);
  // Room to stop, but nearer than it should be: it stops, and says so.
  seen.moving = {walker({{0.0, {4.0 + 1.3 + radius + person, 0.0, 0.0}}, {5.0, {4.0 + 1.3 + radius + person, 0.0, 0.0}}}, {0.0, 1.0})};
  const Plan near = replan(old, time_at(old.samples, 4.0), seen).value();
  expect_sound(near);
  EXPECT_TRUE(says(near, "and cannot stop before"));
  EXPECT_TRUE(says(near, "is kept as it is"));
}

TEST(Moving, WhatIsAtTheStartOrStaysAtTheGoalIsNamed) {
  MovingObstacle far = walker({{0.0, {12.0, 2.5, 0.0}}}), cart = walker({{0.0, {0.2, 0.0, 0.0}}});
  cart.name = "cart";
  const Plan for_good = planned(straight(6.0, {far, cart}));
  EXPECT_EQ(for_good.status, Status::start_in_collision);
  EXPECT_NE(for_good.reason.find("cart (moving obstacle 2) touches the footprint when the plan begins, and stays there for good"), std::string::npos) << for_good.reason;
  // Without a name, its number; gone when it has moved by 0.3 m.
  cart.name.clear();
  cart.track.push_back({3.0, {0.2, 0.0, 0.0}});
  cart.velocity = {0.0, 1.0};
  const Plan at_first = planned(straight(6.0, {cart, far}));
  EXPECT_EQ(at_first.status, Status::start_in_collision);
  EXPECT_NE(at_first.reason.find("moving obstacle 1 of the scenario's list"), std::string::npos) << at_first.reason;
  EXPECT_NE(at_first.reason.find("until 3.4"), std::string::npos) << at_first.reason;
  // Beside it by more than is asked for: no matter.
  Scenario beside = straight(6.0, {walker({{0.0, {0.0, radius + person + 0.06, 0.0}}})});
  beside.clearance = 0.05;
  EXPECT_EQ(planned(beside).status, Status::solved);
  beside.clearance = 0.07;
  const Plan near = planned(beside);
  EXPECT_EQ(near.status, Status::start_in_collision);
  EXPECT_NE(near.reason.find("nearer to the footprint than the 0.0700 m"), std::string::npos) << near.reason;

  // At the goal from the beginning, and from before the vehicle could be there.
  const Plan there = planned(straight(6.0, {walker({{0.0, {12.1, 0.0, 0.0}}})}));
  EXPECT_EQ(there.status, Status::goal_in_collision);
  EXPECT_NE(there.reason.find("person (moving obstacle 1) touches the footprint from 0.00 s after the start on, for good"), std::string::npos) << there.reason;
  const Plan sooner = planned(straight(6.0, {walker({{0.0, {12.1, 2.5, 0.0}}, {5.0, {12.1, 0.0, 0.0}}})}));
  EXPECT_EQ(sooner.status, Status::goal_in_collision);
  EXPECT_NE(sooner.reason.find("and the vehicle is there after 14.00 s at the soonest"), std::string::npos) << sooner.reason;
  for (const std::string& sentence : sooner.explanation) EXPECT_EQ(sentence.find("obstacle 0"), std::string::npos) << "no number for what has a name: " << sentence;
  // When the vehicle has arrived; and for a time: it waits.
  expect_sound(planned(straight(6.0, {walker({{0.0, {12.1, 2.5, 0.0}}, {30.0, {12.1, 2.5, 0.0}}, {35.0, {12.1, 0.0, 0.0}}})})));
  const Plan waits = planned(straight(6.0, {walker({{0.0, {12.1, 0.0, 0.0}}, {30.0, {12.1, 0.0, 0.0}}}, {0.0, 1.0})}));
  expect_sound(waits);
  EXPECT_EQ(waits.waits.size(), 1U);
  // What is seen on top of the vehicle while it drives.
  const Plan old = planned(straight(6.0, {}));
  SeenObstacles seen;
  seen.moving = {walker({{0.0, {4.1, 0.0, 0.0}}}, {0.0, 1.0})};
  seen.moving.front().name.clear();
  const Plan on_it = replan(old, time_at(old.samples, 4.0), seen).value();
  EXPECT_EQ(on_it.status, Status::start_in_collision);
  EXPECT_NE(on_it.reason.find("new moving obstacle 1 (moving obstacle 1) touches"), std::string::npos) << on_it.reason;
}

TEST(Moving, VerifyHoldsTheTimesOfAFileAgainstWhatMoves) {
  const Plan plan = planned(straight(6.0, {walker({{0.0, {6.0, 0.0, 0.0}}, {20.0, {6.0, 0.0, 0.0}}}, {0.0, 0.7})}));
  expect_sound(plan);
  ASSERT_EQ(plan.waits.size(), 1U);
  // Without its wait.
  Plan eager = plan;
  const Wait wait = plan.waits.front();
  for (Sample& s : eager.samples) s.t -= s.t >= wait.until ? wait.until - wait.from : 0.0;
  eager.metrics.travel_time = eager.samples.back().t;
  const Verification verification = verify(eager).value();
  ASSERT_FALSE(verification.holds);
  EXPECT_NE(verification.findings.front().find("person"), std::string::npos) << verification.findings.front();
  // A longer wait is as good where nothing else comes.
  Plan patient = plan;
  for (Sample& s : patient.samples) s.t += s.t >= wait.until ? 3.0 : 0.0;
  patient.metrics.travel_time = patient.samples.back().t;
  EXPECT_TRUE(verify(patient).value().holds);
  // Should it walk otherwise, the plan does not hold.
  Plan elsewhere = plan;
  elsewhere.scenario.moving.front().track.back().t = 30.0;
  EXPECT_FALSE(verify(elsewhere).value().holds);
}

TEST(Moving, NoPlanMeetsWhatMovesInRandomHalls) {
  Random random{23};
  int solved = 0, waited = 0, hindered = 0;
  for (int i = 0; i < 60; ++i) {
    Scenario s = test::hall(random, i % 2 == 0 ? test::disc : Footprint{rectangle({-0.3, -0.25}, {0.5, 0.25}), 0.0}, i % 3 == 0 ? 0.05 : 0.0, 4);
    for (int k = 0; k <= i % 3; ++k) {
      MovingObstacle obstacle;
      if (k % 2 == 0) obstacle.footprint = {{}, random.uniform(0.1, 0.4)};
      else obstacle.footprint = {rectangle({-0.4, -0.2}, {0.4, 0.2}), 0.0};
      obstacle.track.clear();
      double t = random.uniform(0.0, 3.0);
      for (int n = 0; n < 4; ++n) {
        obstacle.track.push_back({t, {random.uniform(0.5, 11.5), random.uniform(0.5, 8.5), random.uniform(-3, 3)}});
        t += random.uniform(2.0, 12.0);
      }
      obstacle.velocity = {random.uniform(-1, 1), random.uniform(-1, 1)};
      obstacle.spread = i % 4 == 3 ? 0.02 : 0.0;
      s.moving.push_back(obstacle);
    }
    s.planner.name = i % 5 == 0 ? "visibility_graph" : "astar";
    const Plan plan = planned(s);
    if (plan.status == Status::solved) {
      ++solved;
      waited += plan.waits.empty() ? 0 : 1;
      expect_sound(plan);
    } else if (plan.hindrance) {
      ++hindered;
      EXPECT_EQ(plan.status, Status::unproven);
    }
  }
  EXPECT_GT(solved, 25);
  EXPECT_GT(waited, 8);
  EXPECT_GT(hindered, 0);
}

// A spread that grows faster than what moves goes away, as fast, or about what stands: the times are settled at once, and what is solved is sound.
TEST(Moving, AnySpreadIsSettled) {
  int solved = 0;
  for (const double spread : {0.01, 0.05, 0.7, 1.5}) {
    for (const Vec2 velocity : {Vec2{0.0, 0.7}, Vec2{0.0, 0.0}, Vec2{0.05, 0.0}}) {
      MovingObstacle obstacle = walker({{0.0, {6.0, -4.0, 0.0}}}, velocity);
      obstacle.spread = spread;
      const Plan plan = planned(straight(6.0, {obstacle}));
      EXPECT_TRUE(plan.status == Status::solved || plan.status == Status::unproven) << plan.reason;
      if (plan.status != Status::solved) continue;
      ++solved;
      expect_sound(plan);
    }
  }
  EXPECT_GT(solved, 2);
}

TEST(Moving, TimesGoOnWhereAPlanIsReplanned) {
  // What was known to move is where it is by then: the same plan, from a later moment.
  const Plan old = planned(straight(6.0, {walker({{0.0, {6.0, -4.0, 0.0}}}, {0.0, 0.7})}));
  expect_sound(old);
  ASSERT_FALSE(old.waits.empty());
  const double t = 2.0;
  SeenObstacles nothing_near;
  nothing_near.still.points = {{0.0, 2.9}};
  const Plan plan = replan(old, t, nothing_near).value();
  expect_sound(plan);
  EXPECT_LT(distance(plan.scenario.moving[0].at(0.0).position(), old.scenario.moving[0].at(t).position()), 1e-12);
  EXPECT_NEAR(plan.samples.back().t, old.samples.back().t - t, 0.15);
}

TEST(Moving, TheSameTwiceIsTheSame) {
  const auto text = [] {
    Plan plan = planned(straight(6.0, {walker({{0.0, {6.0, -4.0, 0.0}}}, {0.0, 0.7})}));
    plan.timing = {};
    return plan_json(plan);
  };
  EXPECT_EQ(text(), text());
}

}  // namespace
}  // namespace waywright
