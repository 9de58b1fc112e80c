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
