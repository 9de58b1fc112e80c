// `capso_spline` and `ga_bspline` on whole problems: the publication's warehouse, a forklift in a ROS map, ways that are walled off.
#include <gtest/gtest.h>

#include <cmath>

#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {
namespace {

Scenario example(const char* name, const std::string& planner) {
  Scenario scenario = read_scenario(std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/" + name + ".json").value();
  scenario.planner = {planner, {}};
  return scenario;
}

Plan planned(const Scenario& scenario) { return *solve(Problem::prepare(scenario).value()); }

bool says(const Plan& plan, const char* what) {
  for (const std::string& sentence : plan.explanation) {
    if (sentence.find(what) != std::string::npos) return true;
  }
  return false;
}

class SplinePlanners : public testing::TestWithParam<std::string> {};

TEST_P(SplinePlanners, FindProvenWaysThroughThePublicationsWarehouse) {
  const struct {
    Pose start, goal;
    double shortest;  // m, of the publication's 8-neighbour search over cells: parking, goods, exit
  } legs[]{{{3, 5, 0}, {29, 19, 0}, 32.3848}, {{29, 19, 0}, {46, 44, 0}, 37.3137}, {{3, 5, 0}, {21, 35, 0}, 42.1421}, {{21, 35, 0}, {46, 44, 0}, 28.7279}};
  for (const auto& leg : legs) {
    Scenario scenario = example("spline_warehouse", GetParam());
    scenario.start = leg.start;
    scenario.mission = leg.goal;
    const Plan plan = planned(scenario);
    ASSERT_EQ(plan.status, Status::solved) << plan.reason;
    EXPECT_LT(plan.metrics.length, 1.12 * leg.shortest);
    EXPECT_GE(plan.certificate.clearance, scenario.clearance);
    EXPECT_TRUE(verify(parse_plan(plan_json(plan), "plan.json").value()).value().holds);
    // One curve, and turns on the spot at its ends.
    int curves = 0;
    for (const Piece& piece : plan.path.pieces) curves += std::holds_alternative<Spline>(piece.curve) ? 1 : 0;
    EXPECT_EQ(curves, 1);
    EXPECT_TRUE(says(plan, "a shortest way for a disc"));
    ASSERT_EQ(plan.alternatives.size(), 2U);
    EXPECT_TRUE(plan.alternatives[0].chosen);
  }
}

TEST_P(SplinePlanners, AForkliftKeepsItsHeadingsAndLimits) {
  Scenario scenario = example("waypoints_warehouse", GetParam());
  scenario.waypoints.clear();
  scenario.waypoint_radius = 0.0;
  const Plan plan = planned(scenario);
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  ASSERT_EQ(plan.path.pieces.size(), 1U);
  EXPECT_EQ(plan.path.pieces[0].direction, 1);
  EXPECT_NEAR(shorter_turn(plan.samples.front().heading, scenario.start.heading), 0.0, 1e-6);
  EXPECT_LE(plan.metrics.max_curvature, scenario.vehicle.max_curvature());
  EXPECT_TRUE(verify(parse_plan(plan_json(plan), "plan.json").value()).value().holds);
}

TEST_P(SplinePlanners, ThePublishedFormShowsWhatItChoseWithItsWeights) {
  Scenario scenario = example("spline_warehouse", GetParam());
  scenario.planner.parameters = {{"form", std::string{"published"}}};
  scenario.budget.evaluations = 1000;
  const Plan plan = planned(scenario);
  EXPECT_LE(plan.effort.evaluations, 1000);
  EXPECT_GT(plan.effort.evaluations, 900);
  EXPECT_TRUE(plan.status == Status::solved || plan.status == Status::unproven);
  EXPECT_FALSE(plan.path.pieces.empty());
  EXPECT_TRUE(says(plan, "f = 1 · length"));
  EXPECT_TRUE(says(plan, "searches for the least length"));
  scenario.planner.parameters["weights"] = std::string{"published"};
  EXPECT_TRUE(says(planned(scenario), "the published ones"));
}

TEST_P(SplinePlanners, EndWithTheReasonWhereTheWayIsWalledOff) {
  Scenario scenario = example("goal_pose", GetParam());
  const Box box = Problem::prepare(scenario).value().world().bounds();
  const Vec2 middle = 0.5 * (scenario.start.position() + std::get<Pose>(scenario.mission).position());
  scenario.map.lines.push_back({{middle.x - 40.0, middle.y - 40.0 * 1.2}, {middle.x + 40.0, middle.y + 40.0 * 1.2}});
  ASSERT_TRUE(box.contains(middle));
  const Plan plan = planned(scenario);
  EXPECT_EQ(plan.status, Status::no_path);
  EXPECT_NE(plan.reason.find("none can be driven; the best one"), std::string::npos) << plan.reason;
  EXPECT_TRUE(plan.path.pieces.empty());
  ASSERT_EQ(plan.alternatives.size(), 1U);
  EXPECT_FALSE(plan.alternatives[0].poses.empty());
}

TEST_P(SplinePlanners, OtherOptimizersSearchTheSameCurves) {
  for (const OptimizerDescription& o : optimizers()) {
    Scenario scenario = example("goal_pose", GetParam());
    scenario.planner.parameters = {{"optimizer", o.name}, {"evaluations", 600.0}};
    const Plan plan = planned(scenario);
    EXPECT_EQ(plan.status, Status::solved) << o.name << " " << plan.reason;
    EXPECT_EQ(says(plan, "lattice_search takes at most 6 variables"), o.name == "lattice_search");
  }
}

TEST_P(SplinePlanners, MoreEvaluationsAreNotWorse) {
  double before = INFINITY;
  for (const double evaluations : {1.0, 100.0, 3000.0}) {
    Scenario scenario = example("spline_warehouse", GetParam());
    scenario.planner.parameters = {{"evaluations", evaluations}, {"optimizer", std::string{"ga_spline"}}};
    const Plan plan = planned(scenario);
    const double cost = plan.status == Status::solved ? *plan.alternatives[0].cost : 1e9;
    EXPECT_LE(cost, before) << evaluations;
    before = cost;
  }
  EXPECT_LT(before, 40.0);
}

INSTANTIATE_TEST_SUITE_P(Both, SplinePlanners, testing::Values("capso_spline", "ga_bspline"), [](const auto& entry) { return entry.param; });

}  // namespace
}  // namespace waywright
