// Plans of bases that do not face along their way, replanned while they move; and what a handover says of the speed at joints of the path.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/oracle/brute_force.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/docking/continuation.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/replan.hpp"
#include "waywright/planner/replan_seen.hpp"
#include "waywright/planner/rest_of_plan.hpp"
#include "waywright/speed/speed.hpp"

namespace waywright {
namespace {

Scenario example(const std::string& name) { return read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + name).value(); }

Plan planned(Scenario scenario) {
  Plan plan = *solve(Problem::prepare(std::move(scenario)).value());
  EXPECT_EQ(plan.status, Status::solved) << plan.reason;
  return plan;
}

Vehicle base() { return example("fields/mecanum_discs.json").vehicle; }

/// 12 m × 6 m, the base sideways along it with a turn of a quarter.
Scenario hall() {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {12, 6})};
  s.map.obstacles = {rectangle({5.5, 0}, {6.5, 2.2})};
  s.vehicle = base();
  s.start = {1.2, 2, 0.5 * pi};
  s.mission = Pose{10.8, 2, pi};
  s.clearance = 0.05;
  s.planner = {"harmonic", {}};
  return s;
}

void expect_sound(const Plan& plan) {
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  const Verification verification = verify(plan).value();
  EXPECT_TRUE(verification.holds) << verification.findings.front();
  const oracle::Scene scene{plan.scenario.map, {}, {}, plan.scenario.vehicle.footprint};
  for (const Sample& s : plan.samples) ASSERT_GT(scene.clearance(s.pose(), 1.0), plan.scenario.clearance - 1e-6) << s.s;
}

/// It takes over where the old plan has the vehicle then, as it moves there.
void expect_goes_on(const Plan& old, const Plan& plan, double t) {
  const Handover now = handover_at(old.path, old.samples, t);
  ASSERT_FALSE(plan.samples.empty()) << t;
  const Sample& first = plan.samples.front();
  EXPECT_NEAR(first.speed, std::abs(now.motion.speed), 2e-3 * std::abs(now.motion.speed)) << t;
  EXPECT_NEAR(distance(first.pose().position(), now.pose.position()), 0.0, 1e-6) << t;
  EXPECT_NEAR(shorter_turn(first.heading, now.pose.heading), 0.0, 1e-6) << t;
  if (now.motion.course) {
    EXPECT_NEAR(shorter_turn(first.course, *now.motion.course), 0.0, 1e-6) << t;
  }
}

// At a joint of two pieces that is driven through the vehicle moves as fast as its samples say, whatever it is: with 0 in place of it a plan would begin at rest.
TEST(ReplanSliding, NobodyStandsWhereTheProfileMoves) {
  for (const char* name : {"fields/mecanum_crossing.json", "fields/mecanum_discs.json", "waypoints_medium.json", "park_parallel.json", "grid_tugger.json", "dock_left.json"}) {
    SCOPED_TRACE(name);
    const Plan plan = planned(example(name));
    ASSERT_FALSE(plan.samples.empty());
    int moving_joints = 0;
    for (std::size_t i = 1; i + 1 < plan.samples.size(); ++i) {
      const Sample &a = plan.samples[i], &b = plan.samples[i + 1];
      for (const double t : {a.t - 1e-6, a.t, a.t + 1e-6}) {
        const Handover now = handover_at(plan.path, plan.samples, t);
        // Within 0.1 mm of where it comes to rest it is taken to stand: at 2 m/s² that is 2 cm/s.
        if (a.speed > 0.05) {
          ASSERT_NEAR(std::abs(now.motion.speed), a.speed, 1e-4 + 1e-3 * a.speed) << a.s << ' ' << t;
        } else if (a.speed == 0.0) {
          ASSERT_LT(std::abs(now.motion.speed), 0.03) << a.s;
        }
      }
      moving_joints += a.piece != b.piece && a.speed > 0.05 ? 1 : 0;
    }
    EXPECT_GT(moving_joints, std::string_view{name} == "fields/mecanum_crossing.json" ? 20 : -1);
  }
}

TEST(ReplanSliding, ItGoesOnAsItMovesWhateverAppears) {
  const Plan old = planned(hall());
  int kept = 0, anew = 0, in_motion = 0, refused = 0;
  for (double t = 0.05; t < old.samples.back().t; t += 0.37) {
    for (const bool blocks : {false, true}) {
      SeenObstacles seen;
      seen.still.obstacles = {blocks ? rectangle({8.0, 1.6}, {8.3, 3.4}) : rectangle({8.0, 5.5}, {8.3, 5.9})};
      const auto plan = replan(old, t, seen);
      ASSERT_TRUE(plan) << plan.error().message();
      if (plan->status != Status::solved) {  // too near to stop, or under it
        ++refused;
        EXPECT_TRUE(blocks) << plan->reason;
        continue;
      }
      expect_sound(*plan);
      expect_goes_on(old, *plan, t);
      in_motion += plan->scenario.start_motion.course ? 1 : 0;
      const bool is_kept = std::any_of(plan->explanation.begin(), plan->explanation.end(), [](const std::string& text) { return text.find("is kept as it is") != std::string::npos; });
      (is_kept ? kept : anew) += 1;
      if (!blocks) {
        EXPECT_TRUE(is_kept) << t;
        EXPECT_NEAR(plan->samples.back().t, old.samples.back().t - t, 0.05 + 0.02 * old.samples.back().t) << t;
      }
    }
  }
  EXPECT_GT(kept, 20);
  EXPECT_GT(anew, 5);
  EXPECT_GT(in_motion, 20);
  EXPECT_LT(refused, 15);
}

TEST(ReplanSliding, AMovedGoalIsReachedFromTheMotion) {
  const Plan old = planned(hall());
  for (const double t : {1.0, 3.03, 6.2}) {
    const Handover now = handover_at(old.path, old.samples, t);
    ASSERT_TRUE(now.motion.course) << t;
    Scenario s = old.scenario;
    s.start = now.pose;
    s.start_motion = now.motion;
    s.mission = Pose{10.6, 4, 2.5};
    const auto plan = replan(Problem::prepare(s).value(), old.path, now.driven);
    ASSERT_TRUE(plan) << plan.error().message();
    expect_sound(*plan);
    expect_goes_on(old, *plan, t);
    EXPECT_NE(std::find_if(plan->explanation.begin(), plan->explanation.end(), [](const std::string& text) { return text.find("without facing along its way") != std::string::npos; }), plan->explanation.end());
  }
}

// Times that were planned with the way are the rest's, too.
TEST(ReplanSliding, OwnTimesAreKept) {
  const Plan old = planned(example("fields/mecanum_crossing.json"));
  for (double t = 0.4; t < 20.0; t += 1.71) {
    SeenObstacles seen;
    seen.still.obstacles = {rectangle({0.1, 0.1}, {0.3, 0.3})};
    const auto plan = replan(old, t, seen);
    ASSERT_TRUE(plan) << plan.error().message();
    ASSERT_EQ(plan->status, Status::solved) << t << ": " << plan->reason;
    EXPECT_TRUE(verify(*plan).value().holds) << t;
    expect_goes_on(old, *plan, t);
    EXPECT_NEAR(plan->samples.back().t, old.samples.back().t - t, 0.3) << t;
  }
}

TEST(ReplanSliding, SomebodyWhoComesIsPassedInTime) {
  const Plan old = planned(example("fields/mecanum_crossing.json"));
  int solved = 0, all = 0;
  for (double t = 0.7; t < 16.0; t += 2.3) {
    const Handover now = handover_at(old.path, old.samples, t);
    const Handover then = handover_at(old.path, old.samples, t + 5.0);
    SeenObstacles seen;
    MovingObstacle walker;
    walker.name = "walker";
    walker.footprint.disc = 0.3;
    const Vec2 there = then.pose.position();
    if (distance(there, now.pose.position()) < 2.0) continue;
    walker.track = {{0.0, make_pose(there + Vec2{0.0, 3.0}, 0.0)}, {10.0, make_pose(there - Vec2{0.0, 3.0}, 0.0)}};
    seen.moving = {walker};
    const auto plan = replan(old, t, seen);
    ASSERT_TRUE(plan) << plan.error().message();
    ++all;
    if (plan->status != Status::solved) {
      EXPECT_FALSE(plan->reason.empty());
      continue;
    }
    ++solved;
    EXPECT_TRUE(verify(*plan).value().holds) << t;
    expect_goes_on(old, *plan, t);
  }
  EXPECT_GE(2 * solved, all) << all;
}

/// As the samples have it at a time, headings too.
Pose pose_at(const std::vector<Sample>& samples, double t) {
  const auto after = std::upper_bound(samples.begin(), samples.end(), t, [](double time, const Sample& s) { return time < s.t; });
  if (after == samples.begin() || after == samples.end()) return after == samples.begin() ? samples.front().pose() : samples.back().pose();
  const Sample &a = *std::prev(after), &b = *after;
  const WithinStep within = within_step(a, b, t - a.t);
  const double share = b.s > a.s ? within.way / (b.s - a.s) : b.t > a.t ? (t - a.t) / (b.t - a.t) : 0.0;
  return make_pose(a.pose().position() + share * (b.pose().position() - a.pose().position()), wrap(a.heading + share * shorter_turn(a.heading, b.heading)));
}

// Wherever on a plan with turns on the spot and waits, also right after a turn, in turns of several pieces, and while it stands before or after one: the vehicle begins as it is.
TEST(ReplanSliding, ItBeginsWhereAndAsTheVehicleIsAtEveryTime) {
  Scenario crossed = example("moving_hall.json");
  Scenario tugger = example("grid_tugger.json");
  tugger.planner = {"clearance_optimal", {}};
  Scenario cells = hall();
  cells.vehicle.drive = Differential{0.4};
  cells.planner = {"astar", {}};
  SeenObstacles far;
  far.still.points = {{300, 300}};
  int turning = 0;
  for (const Scenario& s : {crossed, tugger, cells}) {
    const Plan old = planned(s);
    ASSERT_FALSE(old.samples.empty());
    const Problem was = Problem::prepare(old.scenario).value();
    const double end = old.samples.back().t;
    std::vector<double> times;
    for (double t = 0.0; t < end; t += 0.01) times.push_back(t);
    for (const Sample& at : old.samples) {
      for (const double t : {at.t, at.t + 0.003}) {
        if (t < end) times.push_back(t);
      }
    }
    for (const double t : times) {
      const auto rest = rest_of(old, was, t);
      ASSERT_TRUE(rest);
      const Pose is = start_pose(rest->path), should = pose_at(old.samples, t);
      ASSERT_NEAR(distance(is.position(), should.position()), 0.0, 1.5e-3) << s.name << ' ' << t;  // of chords, and 0.1 mm
      ASSERT_NEAR(shorter_turn(is.heading, should.heading), 0.0, 5e-3) << s.name << ' ' << t;
      turning += rest->stopping.pieces.empty() ? 0 : 1;
      if (!rest->stopping.pieces.empty()) {
        ASSERT_TRUE(start_pose(rest->stopping) == is);
      }
    }
    for (double t = 0.37; t < end; t += 1.31) {
      const auto plan = replan(old, t, far);
      if (!plan) {  // it turns, and something moves
        EXPECT_FALSE(s.moving.empty()) << plan.error().message();
        EXPECT_FALSE(rest_of(old, was, t)->stopping.pieces.empty());
        continue;
      }
      EXPECT_EQ(plan->status, Status::solved) << s.name << ' ' << t << plan->reason;
      EXPECT_TRUE(plan->status != Status::solved || verify(*plan).value().holds) << t;
    }
  }
  EXPECT_GT(turning, 100);
}

// Who turns on the spot cannot stand at once: what is planned anew begins where the turn ends at the soonest, and what stands in it is told.
TEST(ReplanSliding, ATurnOnTheSpotComesToRest) {
  Scenario s = hall();
  s.map.obstacles.clear();
  s.vehicle.drive = Differential{0.4};
  s.start = {6, 3, 0};
  s.mission = Pose{1.5, 3, pi};
  s.planner = {"visibility_graph", {}};
  const Plan old = planned(s);
  ASSERT_EQ(old.samples.front().direction, 0);
  const double t = 1.0, slows_down_by = *s.vehicle.limits.angular_acceleration;  // 3 rad/s²: it turns at its limit of 1.5 rad/s
  const auto rest = rest_of(old, Problem::prepare(s).value(), t);
  ASSERT_TRUE(rest);
  EXPECT_GE(rest->turning, 1.4);
  const double angle = std::abs(std::get<Turn>(rest->stopping.pieces.front().curve).angle);
  EXPECT_NEAR(angle, 0.5 * rest->turning * rest->turning / slows_down_by, 1e-9);
  EXPECT_LT(angle, 0.6);
  // Something on the way to the goal, not in the turn: the new way begins with the stop.
  SeenObstacles ahead;
  ahead.still.obstacles = {rectangle({3.0, 2.5}, {3.4, 3.5})};
  const Plan around = replan(old, t, ahead).value();
  expect_sound(around);
  const auto* first = std::get_if<Turn>(&around.path.pieces.front().curve);
  ASSERT_NE(first, nullptr);
  EXPECT_GE(std::abs(first->angle), angle - 1e-9);
  EXPECT_GT(first->angle * std::get<Turn>(rest->stopping.pieces.front().curve).angle, 0.0);
  // A point in front of the corner that sweeps, 0.2 rad ahead.
  const Pose then = rest->pose;
  double most = 0.0;
  Vec2 swept{};
  for (const Vec2 p : s.vehicle.footprint.polygon) {
    if (norm(p) > most) {
      most = norm(p);
      swept = p;
    }
  }
  const double sense = std::copysign(0.2, std::get<Turn>(rest->stopping.pieces.front().curve).angle);
  SeenObstacles in_it;
  in_it.still.points = {then.position() + (most - 0.01) * unit(angle_of(swept) + then.heading + sense)};
  const Plan blocked = replan(old, t, in_it).value();
  EXPECT_NE(blocked.status, Status::solved);
  EXPECT_FALSE(blocked.reason.empty());
}

// Times at which nothing new happened: what was seen long ago is as uncertain as it was.
TEST(ReplanSliding, WhatNobodyHasSeenAgainStaysUncertain) {
  MovingObstacle cart;
  cart.footprint.disc = 0.3;
  cart.track = {{0.0, make_pose({1, 1}, 0.0)}, {20.0, make_pose({5, 1}, 0.0)}};
  cart.spread = 0.05;
  const MovingObstacle later = seen_from(cart, 12.0);
  EXPECT_DOUBLE_EQ(later.seen, -12.0);
  for (const double t : {0.0, 3.0, 30.0}) {
    EXPECT_DOUBLE_EQ(later.off_by(t), cart.off_by(t + 12.0));
    EXPECT_NEAR(distance(later.at(t).position(), cart.at(t + 12.0).position()), 0.0, 1e-12);
  }
  EXPECT_DOUBLE_EQ(seen_from(later, 5.0).off_by(1.0), cart.off_by(18.0));
}

// A file whose vehicle stops or starts at once, or stands while it drives, does not verify.
TEST(ReplanSliding, NobodyStopsWithinNothing) {
  const Plan plan = planned(example("goal_pose.json"));
  ASSERT_TRUE(verify(plan).value().holds);
  const auto with_stand = [&](double speed_before, double speed_after, double time) {
    Plan lie = plan;
    std::size_t k = 0;
    while (!(lie.samples[k].speed > 0.3 && lie.samples[k + 1].s > lie.samples[k].s)) ++k;
    const double v = lie.samples[k].speed;
    Sample stands = lie.samples[k];
    stands.speed = speed_before * v;
    Sample last = stands;
    last.t += time;
    last.speed = speed_after * v;
    Sample goes = last;
    goes.speed = v;
    lie.samples.insert(lie.samples.begin() + static_cast<std::ptrdiff_t>(k) + 1, {stands, last, goes});
    for (std::size_t i = k + 4; i < lie.samples.size(); ++i) lie.samples[i].t += time;
    lie.metrics.travel_time = lie.samples.back().t;
    return verify(lie).value().holds;
  };
  EXPECT_TRUE(with_stand(1.0, 1.0, 0.0));
  EXPECT_FALSE(with_stand(0.0, 0.0, 10.0));
  EXPECT_FALSE(with_stand(1.0, 1.0, 10.0));
}

TEST(ReplanSliding, TurnsAreNoWaitsOfOwnTimes) {
  for (const char* name : {"moving_hall.json", "goal_pose.json", "grid_tugger.json"}) {
    Scenario s = example(name);
    s.planner = {"global_local", {}};
    const Plan old = planned(s);
    if (old.status != Status::solved) continue;
    SeenObstacles far;
    far.still.points = {{300, 300}};
    for (const double share : {0.0, 0.11, 0.5}) {
      const double t = share * old.samples.back().t;
      const auto plan = replan(old, t, far);
      ASSERT_TRUE(plan) << plan.error().message();
      ASSERT_EQ(plan->status, Status::solved) << name << plan->reason;
      EXPECT_NEAR(plan->samples.back().t, old.samples.back().t - t, 0.35) << name << ' ' << t;
    }
  }
}

TEST(ReplanSliding, TurningWhereItStandsIsNoStart) {
  Scenario s = hall();
  s.start_motion = {0.0, 0.0, 0.0, 1.4};
  EXPECT_EQ(Problem::prepare(s).error().field, "start.angular_velocity");
}

TEST(ReplanSliding, AStartThatCannotBeIsRefused) {
  Scenario s = hall();
  s.start_motion = {0.3, 0.0, 0.0, 0.1};
  const auto plan = *solve(Problem::prepare(s).value());
  expect_sound(plan);
  const StartMotion read = parse_plan(plan_json(plan), "plan.json").value().scenario.start_motion;
  EXPECT_EQ(read.course, s.start_motion.course);
  EXPECT_EQ(read.angular_velocity, s.start_motion.angular_velocity);
  s.start_motion.speed = -0.3;
  EXPECT_EQ(Problem::prepare(s).error().field, "start.speed");
  s.start_motion.speed = 1e3;
  EXPECT_EQ(Problem::prepare(s).error().field, "start.speed");
  s.start_motion = {0.3, 0.0, 0.0, 0.0};
  s.vehicle.drive = Differential{0.5};
  EXPECT_EQ(Problem::prepare(s).error().field, "start.course");
}

// A plan that begins with another course, turning or facing than the vehicle has is not proven.
TEST(ReplanSliding, AnotherCourseThanTheVehiclesIsFound) {
  Scenario s = hall();
  s.start_motion = {0.3, 0.0, 0.0, 0.05};
  const Plan plan = planned(s);
  const auto is_found = [&](auto change, const char* words) {
    Plan lie = plan;
    change(lie.scenario.start_motion);
    const Verification v = verify(lie).value();
    EXPECT_FALSE(v.holds) << words;
    bool is_said = false;
    for (const std::string& finding : v.findings) is_said = is_said || finding.find(words) != std::string::npos;
    EXPECT_TRUE(is_said) << words << " in " << (v.findings.empty() ? "" : v.findings.front());
  };
  is_found([](StartMotion& m) { m.course = 0.01; }, "the vehicle's course is 0.010000 rad");
  is_found([](StartMotion& m) { m = {0.3, 0.0}; }, "the vehicle moves along its heading when the plan begins");
}

}  // namespace
}  // namespace waywright
