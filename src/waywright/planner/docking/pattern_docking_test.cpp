#include "waywright/planner/docking/pattern_docking.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/curve/bezier.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/optimizer/lattice_search.hpp"
#include "waywright/planner/docking/candidate.hpp"
#include "waywright/planner/docking/fixture_stations.hpp"

namespace waywright {
namespace {

using fixture::Id;

PlanningResult plan_with(const Problem& problem, const PatternDockingOptions& options = {}) {
  Budget budget;
  return PatternDockingPlanner{options, std::make_shared<LatticeSearch>(), 1}.plan(problem, budget);
}

TEST(PatternDocking, SolvesTheFixtureStationsAndTheProofHolds) {
  for (const Id id : {Id::d0, Id::d1, Id::d2, Id::d3}) {
    const Problem problem = fixture::problem(id);
    const PlanningResult result = plan_with(problem);
    ASSERT_TRUE(result) << result.error().failure.reason;
    const Plan plan = judge(problem, result->path);
    EXPECT_EQ(plan.status, Status::solved) << plan.reason;
    EXPECT_EQ(plan.metrics.direction_changes, 1);
  }
}

TEST(PatternDocking, MeetsBothPosesExactlyAndStandsWithoutCurvature) {
  const Problem problem = fixture::problem(Id::d2);
  const PlanningResult result = plan_with(problem);
  ASSERT_TRUE(result);
  EXPECT_NEAR(distance(start_pose(result->path).position(), problem.start().position()), 0.0, 1e-14);
  EXPECT_NEAR(distance(end_pose(result->path).position(), problem.goal().position()), 0.0, 1e-14);
  EXPECT_NEAR(shorter_turn(start_pose(result->path).heading, problem.start().heading), 0.0, 1e-12);
  EXPECT_NEAR(shorter_turn(end_pose(result->path).heading, problem.goal().heading), 0.0, 1e-12);
  for (const Piece& piece : result->path.pieces) {
    EXPECT_NEAR(start_curvature(piece), 0.0, 1e-9);
    EXPECT_NEAR(end_curvature(piece), 0.0, 1e-9);
  }
}

TEST(PatternDocking, RunsStraightIntoTheShelfAsAsked) {
  const Problem problem = fixture::problem(Id::d0);
  PatternDockingOptions options;
  options.leads.dock = 1.25;
  const PlanningResult result = plan_with(problem, options);
  ASSERT_TRUE(result);
  const auto& spline = std::get<Spline>(result->path.pieces[1].curve);
  ASSERT_EQ(spline.spans.back().degree, 1);
  EXPECT_NEAR(distance(spline.spans.back().control[0], spline.spans.back().control[1]), 1.25, 1e-12);
}

// Up to what single precision decides at the edge of what is feasible.
TEST(PatternDocking, RotatedStationGivesTheRotatedAnswer) {
  const Pose place{12.5, -4.0, 37.0 * pi / 180.0};
  const PlanningResult a = plan_with(fixture::problem(Id::d2));
  const PlanningResult b = plan_with(fixture::problem(Id::d2, place));
  ASSERT_TRUE(a && b);
  const Frame frame{place};
  ASSERT_EQ(a->path.pieces.size(), b->path.pieces.size());
  for (std::size_t i = 0; i < a->path.pieces.size(); ++i) {
    EXPECT_NEAR(length(a->path.pieces[i]), length(b->path.pieces[i]), 0.01);
    const Pose moved = frame.to_world(end_pose(a->path.pieces[i])), end = end_pose(b->path.pieces[i]);
    EXPECT_NEAR(distance(moved.position(), end.position()), 0.0, 0.01);
    EXPECT_NEAR(shorter_turn(moved.heading, end.heading), 0.0, 0.01);
  }
  const auto cost = [](const PlanningResult& result) {
    double chosen = 0.0;
    for (const Alternative& one : result->alternatives) chosen = one.chosen ? one.cost.value() : chosen;
    return chosen;
  };
  EXPECT_NEAR(cost(a), cost(b), 1e-3 * cost(a));
}

TEST(PatternDocking, BlockedSideAloneIsAFailureThatSaysWhy) {
  Scenario scenario = fixture::station(Id::d1);
  scenario.map.lines.push_back({{1.0, -2.0}, {9.0, -2.0}});  // a wall along the right side
  PatternDockingOptions options;
  options.sides = SideChoice::right;
  const PlanningResult result = plan_with(Problem::prepare(scenario).value(), options);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().failure.status, Status::no_path);
  EXPECT_NE(result.error().failure.reason.find("line 0"), std::string::npos) << result.error().failure.reason;
}

TEST(PatternDocking, SameProblemSameBits) {
  const Problem problem = fixture::problem(Id::d2);
  const PlanningResult a = plan_with(problem);
  const PlanningResult b = plan_with(problem);
  ASSERT_TRUE(a && b);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& p = std::get<Spline>(a->path.pieces[i].curve);
    const auto& q = std::get<Spline>(b->path.pieces[i].curve);
    for (std::size_t k = 0; k < p.spans.size(); ++k) EXPECT_EQ(p.spans[k].control, q.spans[k].control);
  }
}

TEST(JoiningQuintic, MeetsCoursesAndHasNoCurvatureAtItsEnds) {
  Random random{3};
  for (int i = 0; i < 1000; ++i) {
    const Vec2 a{random.uniform(-5, 5), random.uniform(-5, 5)};
    const Vec2 b{random.uniform(-5, 5), random.uniform(-5, 5)};
    const double ca = random.uniform(-pi, pi);
    const double cb = random.uniform(-pi, pi);
    const BezierSpan span = joining_quintic(a, unit(ca), b, unit(cb));
    const CurvePoint p = evaluate(span, 0.0);
    const CurvePoint q = evaluate(span, 1.0);
    EXPECT_NEAR(distance(p.position, a), 0.0, 1e-14);
    EXPECT_NEAR(distance(q.position, b), 0.0, 1e-14);
    EXPECT_NEAR(shorter_turn(p.course, ca), 0.0, 1e-12);
    EXPECT_NEAR(shorter_turn(q.course, cb), 0.0, 1e-12);
    EXPECT_NEAR(p.curvature, 0.0, 1e-9);
    EXPECT_NEAR(q.curvature, 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace waywright
