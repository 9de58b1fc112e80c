// What appears while a plan is driven and stands still: kept, mended, planned anew, or an honest no.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cstring>

#include "tests/grid_scenarios.hpp"
#include "tests/oracle/brute_force.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/path/remainder.hpp"
#include "waywright/planner/replan_seen.hpp"
#include "waywright/planner/rest_of_plan.hpp"

namespace waywright {
namespace {

Scenario example(const std::string& name) { return read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + name).value(); }

Plan planned(Scenario scenario, const std::string& planner, Parameters parameters = {}) {
  if (!planner.empty()) scenario.planner = {planner, std::move(parameters)};
  return *solve(Problem::prepare(std::move(scenario)).value());
}

SeenObstacles seen(std::vector<Ring> rings) {
  SeenObstacles all;
  all.still.obstacles = std::move(rings);
  return all;
}

bool says(const Plan& plan, const std::string& words) {
  for (const std::string& sentence : plan.explanation) {
    if (sentence.find(words) != std::string::npos) return true;
  }
  return false;
}

/// Every sample far enough from everything, by brute force; the plan verifies.
void expect_sound(const Plan& plan) {
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  const Verification verification = verify(plan).value();
  EXPECT_TRUE(verification.holds) << verification.findings.front();
  const oracle::Scene scene{plan.scenario.map, {}, {}, plan.scenario.vehicle.footprint};
  for (const Sample& s : plan.samples) EXPECT_GT(scene.clearance(s.pose(), 1.0), plan.scenario.clearance - 1e-6) << s.s;
}

TEST(ReplanSeen, ABoxOnTheWayAfterEightMetres) {
  // The test of the RRT*-WOA publication's reconstruction: map 2, the box appears when the robot has driven 8 m.
  const Ring box = rectangle({11.5, 11.5}, {13.0, 13.0});
  int blocked = 0, mended = 0;
  for (const char* file : {"rrt_woa/point_2.json", "rrt_woa/wheelchair_2.json"}) {
    for (const char* planner : {"rrt_star", "rrt_star_woa_local", "rrt_star_woa_global", "astar", "visibility_graph"}) {
      const Parameters fewer = std::string_view{planner}.starts_with("rrt") ? Parameters{{"iterations", 1500.0}} : Parameters{};
      const Plan old = planned(example(file), planner, fewer);
      ASSERT_EQ(old.status, Status::solved) << planner;
      const auto plan = replan(old, time_at(old.samples, 8.0), seen({box}));
      ASSERT_TRUE(plan) << planner << plan.error().message();
      expect_sound(*plan);
      EXPECT_EQ(plan->planner, planner);
      // It goes on from where the robot is, and arrives where it was to.
      const Problem was = Problem::prepare(old.scenario).value();
      const auto rest = rest_of(old, was, time_at(old.samples, 8.0));
      EXPECT_LT(distance(start_pose(plan->path).position(), rest->pose.position()), 1e-6);
      EXPECT_NEAR(rest->driven, 8.0, 0.01);
      EXPECT_LT(distance(end_pose(plan->path).position(), old.scenario.map.boundaries.empty() ? Vec2{} : Vec2{18.5, 18.5}), 1e-6);
      blocked += says(*plan, "is blocked by new obstacle 1") ? 1 : 0;
      EXPECT_NE(says(*plan, "is blocked by"), says(*plan, "is kept as it is")) << planner;
      // And one that is on its way for sure, 4 m ahead.
      const Vec2 ahead = sample(remainder(old.path, 12.0), 0.0, 1e-3).front().pose().position();
      const auto around = replan(old, time_at(old.samples, 8.0), seen({rectangle(ahead - Vec2{0.4, 0.4}, ahead + Vec2{0.4, 0.4})}));
      ASSERT_TRUE(around);
      expect_sound(*around);
      EXPECT_TRUE(says(*around, "is blocked by new obstacle 1")) << planner;
      mended += says(*around, "So it is mended") ? 1 : 0;
    }
  }
  EXPECT_GE(blocked, 1);
  EXPECT_GE(mended, 1);
  EXPECT_LT(mended, 10);
}

TEST(ReplanSeen, WhatIsFreeIsKeptCurveForCurve) {
  Random random{5};
  int kept = 0, changed = 0;
  for (int i = 0; i < 80; ++i) {
    const Scenario s = test::hall(random, i % 2 == 0 ? test::disc : Footprint{rectangle({-0.3, -0.25}, {0.5, 0.25}), 0.0}, 0.05, 4);
    const Plan old = planned(s, i % 3 == 0 ? "visibility_graph" : "astar");
    const double x = random.uniform(0, 11), y = random.uniform(0, 8), share = random.uniform(0.0, 0.9);
    if (old.status != Status::solved) continue;
    const Ring box = rectangle({x, y}, {x + 0.6, y + 0.6});
    const double t = share * old.samples.back().t;
    const Problem was = Problem::prepare(old.scenario).value();
    const auto rest = rest_of(old, was, t);
    const auto plan = replan(old, t, seen({box}));
    ASSERT_TRUE(plan);
    // Brute force says which it must be.
    Map alone;
    alone.obstacles = {box};
    const oracle::Scene scene{alone, {}, {}, s.vehicle.footprint};
    double nearest = 10.0;
    for (const Sample& at : sample(rest->path, 1.0, 1e-4, 0.01)) nearest = std::min(nearest, scene.clearance(at.pose(), 10.0));
    if (nearest > s.clearance + 2e-3) {
      ++kept;
      expect_sound(*plan);
      EXPECT_TRUE(says(*plan, "is kept as it is"));
      ASSERT_EQ(plan->path.pieces.size(), rest->path.pieces.size());
      const std::vector<Sample> is = sample(plan->path, 1.0, 1e-3), should = sample(rest->path, 1.0, 1e-3);
      ASSERT_EQ(is.size(), should.size());
      for (std::size_t k = 0; k < is.size(); ++k) ASSERT_TRUE(is[k].pose() == should[k].pose() && is[k].s == should[k].s);  // to the last bit
      EXPECT_LE(plan->certificate.clearance, nearest + 1e-6);
      EXPECT_GE(plan->certificate.clearance, std::min(nearest, old.certificate.clearance) - 2.0 * ProofOptions{}.tolerance);
      EXPECT_EQ(plan->effort.evaluations + plan->effort.expansions, 0);
    } else if (nearest < s.clearance) {
      ++changed;
      EXPECT_FALSE(says(*plan, "is kept as it is"));
      if (plan->status == Status::solved) expect_sound(*plan);
      else EXPECT_FALSE(plan->reason.empty());
    }
  }
  EXPECT_GT(kept, 10);
  EXPECT_GT(changed, 3);
}

// Curves that are cut are bounded anew: what is kept of them claims no more than can be proven of it.
TEST(ReplanSeen, WhatIsKeptOfSplinesVerifies) {
  SeenObstacles far;
  far.still.points = {{300, 300}};
  for (const char* file : {"dock_rotated.json", "dock_cluttered.json", "spline_warehouse.json"}) {
    const Plan old = planned(example(file), "");
    ASSERT_EQ(old.status, Status::solved) << file;
    int kept = 0;
    for (double share = 0.013; share < 0.9; share += 0.031) {
      const auto plan = replan(old, share * old.samples.back().t, far);
      if (!plan) continue;  // in the shelf
      ASSERT_EQ(plan->status, Status::solved) << file << share << plan->reason;
      const Verification verification = verify(*plan).value();
      EXPECT_TRUE(verification.holds) << file << ' ' << share << ": " << verification.findings.front();
      kept += says(*plan, "is kept as it is") ? 1 : 0;
    }
    EXPECT_GT(kept, 20) << file;
  }
}

/// A disc that drives 12 m through a long hall at 1 m/s.
Scenario straight(double width) {
  Scenario s;
  s.map.boundaries = {rectangle({-1, -0.5 * width}, {13, 0.5 * width})};
  s.vehicle.footprint = {{}, 0.2};
  s.vehicle.drive = Differential{0.4};
  s.vehicle.limits.speed = 1.0;
  s.vehicle.limits.acceleration = 0.5;
  s.vehicle.limits.deceleration = 0.5;
  s.vehicle.limits.angular_speed = 1.0;
  s.start = {0, 0, 0};
  s.mission = Pose{12, 0, 0};
  s.clearance = 0.05;
  return s;
}

TEST(ReplanSeen, ItStopsWithinTheDecelerationLimitWhereThereIsRoom) {
  const Plan old = planned(straight(6.0), "visibility_graph");
  const double t = time_at(old.samples, 4.0);  // at 1 m/s: it stands 1 m on
  const auto at = [&](double x) { return replan(old, t, seen({rectangle({x, -0.5}, {x + 0.5, 0.5})})).value(); };
  const Plan far = at(7.0);
  expect_sound(far);
  EXPECT_DOUBLE_EQ(far.scenario.start_motion.speed, 1.0);
  EXPECT_DOUBLE_EQ(far.samples.front().speed, 1.0);
  EXPECT_TRUE(says(far, "comes to rest in 1.0")) << far.explanation[0];
  const Plan near = at(4.0 + 1.0 + 0.2 + 0.05 + 0.15);
  expect_sound(near);
  // 0.9 m to the first place that is too near: no plan, with both figures.
  const Plan late = at(4.0 + 0.9 + 0.25);
  EXPECT_NE(late.status, Status::solved);
  EXPECT_NE(late.reason.find("0.9"), std::string::npos) << late.reason;
  EXPECT_NE(late.reason.find("to come to rest from 1.00 m/s"), std::string::npos) << late.reason;
  EXPECT_NE(late.reason.find("new obstacle 1"), std::string::npos) << late.reason;
}

TEST(ReplanSeen, AnObstacleOnTheVehicleOrTheGoalIsSaid) {
  const Plan old = planned(straight(6.0), "astar");
  const double t = time_at(old.samples, 4.0);
  EXPECT_EQ(replan(old, t, seen({rectangle({3.9, -0.1}, {4.1, 0.1})})).value().status, Status::start_in_collision);
  EXPECT_EQ(replan(old, t, seen({rectangle({11.9, -0.1}, {12.1, 0.1})})).value().status, Status::goal_in_collision);
  // A wall across the hall: no way, and it is said that there is none.
  const Plan walled = replan(old, t, seen({rectangle({8.0, -3.0}, {8.2, 3.0})})).value();
  EXPECT_EQ(walled.status, Status::no_path);
  EXPECT_FALSE(walled.reason.empty());
}

TEST(ReplanSeen, TheBeginningAndTheEndOfALongWayAreKept) {
  Scenario s = straight(6.0);
  s.map.obstacles = {rectangle({5.5, -3.0}, {6.0, 1.0})};  // the way bends over it
  const Plan old = planned(s, "visibility_graph");
  ASSERT_EQ(old.status, Status::solved);
  const Plan plan = replan(old, 0.0, seen({rectangle({2.0, 0.0}, {2.3, 0.7})})).value();
  expect_sound(plan);
  EXPECT_TRUE(says(plan, "Not taken: ")) ;
  EXPECT_TRUE(says(plan, "It leaves the old way "));
  EXPECT_TRUE(says(plan, "joins it again at ("));
  EXPECT_TRUE(says(plan, fmt::format("({:.2f} m in place of {:.2f} m)", plan.metrics.length, old.metrics.length)));
  EXPECT_TRUE(says(plan, fmt::format("({:.1f} s in place of {:.1f} s)", plan.metrics.travel_time, old.metrics.travel_time)));
  for (const std::string& sentence : plan.explanation) {
    const std::string mark = "Of the new part: ";
    if (!sentence.starts_with(mark)) continue;
    EXPECT_FALSE(std::isupper(static_cast<unsigned char>(sentence[mark.size()])) && std::islower(static_cast<unsigned char>(sentence[mark.size() + 1]))) << sentence;
  }
}

TEST(ReplanSeen, DockingPlansAreKeptOrPlannedAnewInMotion) {
  const Plan old = planned(example("dock_middle.json"), "");
  ASSERT_EQ(old.status, Status::solved);
  const double t = 4.0;
  const Problem was = Problem::prepare(old.scenario).value();
  const RestOfPlan rest = rest_of(old, was, t).value();
  // Far from it, and on it.
  const Box area = bounding_box(std::get<Station>(old.scenario.mission).area);
  const Ring corner = rectangle(area.low + Vec2{0.05, 0.05}, area.low + Vec2{0.15, 0.15});
  const Plan kept = replan(old, t, seen({corner})).value();
  expect_sound(kept);
  EXPECT_TRUE(says(kept, "is kept as it is"));
  int solved = 0, tried = 0;
  const std::vector<Sample> ahead = sample(rest.path, 1.0, 1e-3);
  for (const double share : {0.35, 0.5, 0.65, 0.8}) {
    const Vec2 on = ahead[static_cast<std::size_t>(share * static_cast<double>(ahead.size() - 1))].pose().position();
    const Plan plan = replan(old, t, seen({rectangle(on - Vec2{0.05, 0.05}, on + Vec2{0.05, 0.05})})).value();
    ++tried;
    EXPECT_FALSE(says(plan, "is kept as it is"));
    if (plan.status == Status::solved) {
      ++solved;
      expect_sound(plan);
    } else {
      EXPECT_FALSE(plan.reason.empty());
    }
  }
  EXPECT_EQ(tried, 4);
  EXPECT_GE(solved, 1);
}

TEST(ReplanSeen, TheSameTwiceIsTheSame) {
  const Plan old = planned(example("rrt_woa/wheelchair_2.json"), "rrt_star", {{"iterations", 1000.0}});
  const auto text = [&] {
    Plan plan = replan(old, time_at(old.samples, 8.0), seen({rectangle({11.5, 11.5}, {13.0, 13.0})})).value();
    plan.timing = {};
    return plan_json(plan);
  };
  EXPECT_EQ(text(), text());
}

TEST(ReplanSeen, ATurnOnTheSpotIsGoneOnWith) {
  Scenario s = straight(6.0);
  s.start.heading = 2.0;
  const Plan old = planned(s, "astar");
  ASSERT_EQ(old.samples.front().direction, 0);
  const Plan plan = replan(old, 0.9, seen({rectangle({8.0, 1.0}, {9.0, 2.0})})).value();
  expect_sound(plan);
  EXPECT_GT(plan.scenario.start.heading, 0.0);
  EXPECT_LT(plan.scenario.start.heading, 2.0);
  EXPECT_LT(plan.samples.back().t, old.samples.back().t);
}

TEST(ReplanSeen, MissionsThatItDoesNotTakeAreRefused) {
  Plan old = planned(straight(6.0), "astar");
  old.scenario.waypoints = {{3.0, 0.0}};
  EXPECT_EQ(replan(old, 0.0, seen({rectangle({3, 1}, {4, 2})})).error().field, "waypoints");
}

}  // namespace
}  // namespace waywright
