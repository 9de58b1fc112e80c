// Goals that leave the heading free: by hand, against every single pose, and what verify and the other planners say.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/command_line.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/solve_legs.hpp"

namespace waywright {
namespace {

/// An empty hall of 10 by 10 m, cells of 1 m, their middles at halves; a round robot.
Scenario hall(const Mission& mission, const char* planner = "astar") {
  Scenario s;
  s.map.boundaries = {rectangle({0.0, 0.0}, {10.0, 10.0})};
  s.vehicle.footprint.disc = 0.3;
  s.vehicle.drive = Differential{0.4};
  s.start = {1.5, 1.5, 0.0};
  s.mission = mission;
  s.planner = {planner, {{"resolution", 1.0}}};
  return s;
}

Plan solved(const Scenario& s) {
  const auto problem = Problem::prepare(s);
  EXPECT_TRUE(problem);
  Plan plan = solve(*problem).value();
  EXPECT_EQ(plan.status, Status::solved) << plan.reason;
  if (plan.status == Status::solved) {
    const auto verified = verify(parse_plan(plan_json(plan), "p").value());
    EXPECT_TRUE(verified->holds) << verified->findings.front();
  }
  return plan;
}

FreeGoal region(Vec2 low, Vec2 high) { return {rectangle(low, high)}; }

TEST(FreeGoal, APointIsReachedWithTheHeadingOfTheLastDrive) {
  for (const char* planner : {"astar", "dijkstra", "theta_star"}) {
    const Plan straight = solved(hall(FreeGoal{{{6.5, 1.5}}}, planner));
    EXPECT_NEAR(straight.metrics.length, 5.0, 1e-9) << planner;
    EXPECT_NEAR(straight.metrics.turning, 0.0, 1e-9) << planner;
    const Plan diagonal = solved(hall(FreeGoal{{{6.5, 6.5}}}, planner));
    EXPECT_NEAR(diagonal.metrics.length, 5.0 * std::sqrt(2.0), 1e-9) << planner;
    EXPECT_NEAR(diagonal.samples.back().heading, pi / 4, 1e-9) << planner;
    EXPECT_NEAR(diagonal.metrics.turning, pi / 4, 1e-9) << planner;
  }
  // Beside the middles of cells: half a metre beyond the last one.
  EXPECT_NEAR(solved(hall(FreeGoal{{{7.0, 1.5}}})).metrics.length, 5.5, 1e-9);
  // Within two cells there is nothing to search.
  const Plan near = solved(hall(FreeGoal{{{2.5, 2.5}}}));
  EXPECT_NEAR(near.metrics.length, std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(near.samples.back().heading, pi / 4, 1e-9);
}

TEST(FreeGoal, ARegionIsEnteredAtItsNearestMiddleByPath) {
  for (const char* planner : {"astar", "dijkstra", "theta_star"}) {
    // Middles from x = 5.5 on lie in it: straight on, 4 m.
    EXPECT_NEAR(solved(hall(region({5.0, 0.0}, {9.0, 9.0}), planner)).metrics.length, 4.0, 1e-9) << planner;
  }
  // A wall at x = 3 up to y = 8, and all behind it is the goal: one move aslant and six along the wall to (2.5, 8.5), which its end does not hinder,
  // then one across.
  Scenario s = hall(region({3.1, 0.1}, {9.9, 9.9}));
  s.map.lines = {{{3.0, 0.0}, {3.0, 8.0}}};
  for (const char* planner : {"astar", "dijkstra"}) {
    s.planner.name = planner;
    const Plan plan = solved(s);
    EXPECT_NEAR(plan.metrics.length, std::sqrt(2.0) + 6.0 + 1.0, 1e-9);
    EXPECT_NEAR(plan.samples.back().x, 3.5, 1e-9);
    EXPECT_NEAR(plan.samples.back().y, 8.5, 1e-9);
  }
}

TEST(FreeGoal, DangerIsTradedOnTheWayToItToo) {
  Scenario s = hall(FreeGoal{{{8.5, 2.5}}}, "danger_astar");
  const Plan point = solved(s);
  EXPECT_NEAR(distance(end_pose(point.path).position(), {8.5, 2.5}), 0.0, 1e-9);
  EXPECT_NE(point.path.pieces.back().direction, 0);
  s.mission = region({5.0, 0.0}, {9.0, 9.0});
  const Plan far = solved(s);
  EXPECT_NEAR(far.samples.back().x, 5.5, 1e-9);
  EXPECT_GE(far.metrics.length, 4.0 - 1e-9);
  s.planner.parameters["form"] = std::string{"published"};
  EXPECT_EQ(solve(Problem::prepare(s).value()).value().reason, "the published form searches to one cell, not to a region; take form corrected");
}

/// The optimum over the graph: no single middle of the region is nearer.
TEST(FreeGoal, NoPoseInTheRegionIsNearer) {
  std::mt19937 random{20261126};
  const auto uniform = [&](double low, double high) { return low + (high - low) * (static_cast<double>(random()) / 4294967296.0); };
  for (int round = 0; round < 12; ++round) {
    Scenario s = hall(FreeGoal{});
    for (int i = 0; i < 7; ++i) {
      const Vec2 at{uniform(2.5, 9.0), uniform(0.5, 9.0)};
      s.map.obstacles.push_back(rectangle(at, at + Vec2{uniform(0.2, 1.2), uniform(0.2, 1.2)}));
    }
    // An L, so that the middle of its box lies outside of it.
    const FreeGoal goal{{{4.0, 4.0}, {9.0, 4.0}, {9.0, 5.0}, {5.0, 5.0}, {5.0, 9.0}, {4.0, 9.0}}};
    s.planner = {round % 2 == 0 ? "astar" : "dijkstra", {{"resolution", 1.0}, {"neighbours", round % 3 == 0 ? 16.0 : 8.0}}};
    double least = 1e9;
    for (int column = 0; column < 10; ++column) {
      for (int row = 0; row < 10; ++row) {
        const Vec2 middle{column + 0.5, row + 0.5};
        if (!contains(goal.area, middle)) continue;
        Scenario single = s;
        single.mission = make_pose(middle, 0.0);
        const Plan plan = solve(Problem::prepare(single).value()).value();
        if (plan.status == Status::solved) least = std::min(least, plan.metrics.length);
      }
    }
    s.mission = goal;
    const Plan plan = solve(Problem::prepare(s).value()).value();
    ASSERT_EQ(plan.status == Status::solved, least < 1e9) << round << plan.reason;
    if (plan.status != Status::solved) continue;
    EXPECT_NEAR(plan.metrics.length, least, 1e-9) << round;
  }
}

double cost_of(const Plan& plan) {
  double cost = 0.05 * plan.metrics.turning;
  for (const Piece& piece : plan.path.pieces) cost += length(piece) * (piece.direction < 0 ? 3.0 : 1.0);
  return cost;
}

TEST(FreeGoal, OfAFootprintWithAShapeNoCellAndHeadingCostsLess) {
  Scenario s = hall(FreeGoal{});
  s.vehicle.footprint = {rectangle({-0.9, -0.3}, {0.6, 0.3}), 0.0};
  s.map.obstacles = {rectangle({3.0, 0.0}, {3.4, 2.4}), rectangle({5.0, 3.0}, {5.4, 9.0})};
  s.planner.parameters = {{"resolution", 0.5}};
  s.start = {1.75, 1.75, pi};
  for (const FreeGoal& goal : {region({7.0, 6.0}, {8.0, 7.0}), region({3.6, 0.1}, {4.4, 1.4})}) {
    double least = 1e9;
    for (double x = 0.25; x < 10.0; x += 0.5) {
      for (double y = 0.25; y < 10.0; y += 0.5) {
        if (!contains(goal.area, {x, y})) continue;
        for (int h = 0; h < 8; ++h) {
          Scenario single = s;
          single.mission = make_pose({x, y}, wrap(h * pi / 4));
          const Plan plan = solve(Problem::prepare(single).value()).value();
          if (plan.status == Status::solved) least = std::min(least, cost_of(plan));
        }
      }
    }
    s.mission = goal;
    EXPECT_NEAR(cost_of(solved(s)), least, 1e-5);
  }
  s.mission = FreeGoal{{{7.6, 6.1}}};
  const Plan point = solved(s);
  const Piece& last = point.path.pieces.back();
  EXPECT_NE(last.direction, 0);  // no turn where it has arrived
  EXPECT_NEAR(distance(end_pose(point.path).position(), {7.6, 6.1}), 0.0, 1e-9);
}

TEST(FreeGoal, VerifyFindsAnEndElsewhere) {
  const Plan point = solved(hall(FreeGoal{{{6.5, 1.5}}}));
  Plan moved = point;
  std::get<FreeGoal>(moved.scenario.mission).area = {{6.51, 1.5}};
  const auto verification = verify(moved).value();
  ASSERT_FALSE(verification.holds);
  EXPECT_NE(verification.findings.front().find("the path ends at (6.500000, 1.500000), 0.010000 m from the goal"), std::string::npos) << verification.findings.front();
  Plan shrunk = solved(hall(region({5.0, 0.0}, {9.0, 9.0})));
  shrunk.scenario.mission = region({5.6, 0.0}, {9.0, 9.0});
  EXPECT_FALSE(verify(shrunk).value().holds);
  shrunk.scenario.mission = region({5.5, 0.0}, {9.0, 9.0});  // on its edge is in it
  EXPECT_TRUE(verify(shrunk).value().holds);
}

TEST(FreeGoal, WhatCannotBeReachedIsToldInOneSentence) {
  const auto reason = [](const Scenario& s) { return solve(Problem::prepare(s).value()).value().reason; };
  EXPECT_EQ(reason(hall(region({5.1, 5.1}, {5.2, 5.2}))), "no cell of 1 m has its middle in the goal's region; try a finer resolution");
  EXPECT_EQ(reason(hall(region({1.0, 1.0}, {5.2, 5.2}))), "the start is at the goal already, there is nothing to drive");
  const Plan outside = solve(Problem::prepare(hall(region({20.0, 1.0}, {25.0, 5.2}))).value()).value();
  EXPECT_EQ(outside.status, Status::goal_outside);
  EXPECT_EQ(outside.reason, "the goal's region lies outside of the boundary");
  Scenario filled = hall(region({5.0, 5.0}, {9.0, 9.0}));
  filled.map.obstacles = {rectangle({4.0, 4.0}, {9.5, 9.5})};
  const Plan inside = solve(Problem::prepare(filled).value()).value();
  EXPECT_EQ(inside.status, Status::goal_in_collision);
  EXPECT_EQ(inside.reason, "no place in the goal's region is free: obstacle 0 blocks all of it, even for the largest disc in the footprint, 0.300 m");
  EXPECT_EQ(inside.effort.expansions, 0);
  Scenario shut = hall(region({5.0, 0.0}, {9.0, 9.0}));
  shut.map.lines = {{{4.0, 0.0}, {4.0, 10.0}}};
  EXPECT_EQ(reason(shut).rfind("no way over cells of 1 m leads from start to goal", 0), 0U) << reason(shut);
}

TEST(FreeGoal, APointThatNothingFitsAtIsToldLikeAPose) {
  Scenario s = hall(FreeGoal{{{6.5, 1.5}}});
  s.map.obstacles.push_back(rectangle({6.0, 1.0}, {7.0, 2.0}));
  Plan plan = solve(Problem::prepare(s).value()).value();
  EXPECT_EQ(plan.status, Status::goal_in_collision) << plan.reason;
  EXPECT_EQ(plan.effort.expansions, 0);
  s = hall(FreeGoal{{{-3.0, 1.5}}});
  plan = solve(Problem::prepare(s).value()).value();
  EXPECT_EQ(plan.status, Status::goal_outside) << plan.reason;
}

TEST(FreeGoal, OtherPlannersRefuseItAndSayWhoDoesNot) {
  std::string who;
  for (const PlannerDescription& planner : planners()) {
    if (planner.takes_free_goals) who += (who.empty() ? "" : ", ") + planner.name;
  }
  for (const char* name : {"astar", "theta_star", "danger_astar", "visibility_graph", "rrt_star", "ompl_rrt_star"}) EXPECT_NE(who.find(name), std::string::npos);
  for (const PlannerDescription& planner : planners()) {
    const auto taken = check_mission(planner.name, hall(FreeGoal{{{6.5, 1.5}}}));
    EXPECT_EQ(taken.has_value(), planner.takes_free_goals) << planner.name;
    if (taken) continue;
    EXPECT_EQ(taken.error().message(),
              "planner.name: " + planner.name + " plans to a goal pose, and this goal leaves the heading free (allowed: " + who + ")");
  }
}

TEST(FreeGoal, ALegMayEndInARegionAndTheNextBeginsThere) {
  Scenario s = hall(Pose{});
  Leg out, back;
  out.mission = region({5.0, 5.0}, {9.0, 9.0});
  back.mission = Pose{1.5, 1.5, 0.0};
  s.legs = {out, back};
  const Plan plan = solve_legs(s).value();
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  EXPECT_NEAR(plan.metrics.length, 2.0 * 4.0 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(plan.legs[0].end.x, 5.5, 1e-9);
  EXPECT_EQ(plan.legs[1].start, plan.legs[0].end);
  EXPECT_TRUE(verify(parse_plan(plan_json(plan), "p").value()).value().holds);
}

class FreeGoalOnTheCommandLine : public test::CommandLine {};

TEST_F(FreeGoalOnTheCommandLine, PlannedByAstarWhereNobodyIsNamedAndDrawn) {
  test::Json s = test::Json::parse(test::slurp(example("grid_region.json")));
  if (s["vehicle"].is_string()) s["vehicle"] = example(s["vehicle"].get<std::string>());
  const auto o = run("plan " + write(s) + " -o out");
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  EXPECT_NE(o.out.find("planner                astar"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("The goal leaves the heading free, and the place within its region: the vehicle ends at"), std::string::npos) << o.out;
  EXPECT_EQ(run("verify out/plan.json").status, 0);
  EXPECT_NE(test::slurp(folder_ / "out" / "plan.svg").find("class=\"region\""), std::string::npos);
  refused(run("plan s.json --planner pattern_docking"), {"planner.name: pattern_docking plans to a goal pose"});
  refused(run("replan out/plan.json --at 1"), {"scenario.goal: a goal that leaves the heading free is not planned anew"});
}

}  // namespace
}  // namespace waywright
