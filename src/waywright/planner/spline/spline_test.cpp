// Curves, candidates, guides and the published fitness by themselves. tests/spline_planner_test.cpp has the planners.
#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/curve/bezier.hpp"
#include "waywright/planner/spline/guide.hpp"
#include "waywright/planner/spline/spline_candidates.hpp"

namespace waywright {
namespace {

Scenario hall(const Pose& start, const Pose& goal, double disc) {
  Scenario s;
  s.map.boundaries = {{{-5, -5}, {25, -5}, {25, 15}, {-5, 15}}};
  s.vehicle.footprint = {{}, disc};
  s.vehicle.drive = Differential{0.5};
  s.start = start;
  s.mission = goal;
  return s;
}

Problem prepared(Scenario s) { return Problem::prepare(std::move(s)).value(); }

std::vector<double> random_point(const SearchSpace& space, Random& random) {
  std::vector<double> x;
  for (std::size_t k = 0; k < space.dimension(); ++k) x.push_back(random.uniform(space.low[k], space.high[k]));
  return x;
}

TEST(SplineCurve, GoesThroughItsControlPointsWithoutAJumpOfCurvature) {
  const Problem problem = prepared(hall({0, 0, 1.0}, {20, 8, 0.5}, 0.3));
  Random random{1};
  for (const SplineEnds ends : {SplineEnds::turned, SplineEnds::kept, SplineEnds::ignored}) {
    for (int k = 0; k < 50; ++k) {
      std::vector<Vec2> points;
      for (int i = 0; i < 6; ++i) points.push_back({random.uniform(0, 20), random.uniform(-3, 12)});
      const auto curve = spline_curve(problem, SplineForm::cubic, ends, points);
      ASSERT_TRUE(curve);
      ASSERT_EQ(curve->spans.size(), 7U);
      for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(curve->spans[i].control[3], points[i]);
        const CurvePoint before = evaluate(curve->spans[i], 1.0), after = evaluate(curve->spans[i + 1], 0.0);
        EXPECT_NEAR(before.curvature, after.curvature, 1e-6 * (1.0 + std::abs(before.curvature)));
      }
      if (ends == SplineEnds::kept) {
        EXPECT_NEAR(evaluate(curve->spans.front(), 0.0).course, 1.0, 1e-12);
        EXPECT_NEAR(evaluate(curve->spans.back(), 1.0).course, 0.5, 1e-12);
      }
      const Path path = path_of(problem, *curve);
      EXPECT_EQ(path.pieces.size(), ends == SplineEnds::turned ? 3U : 1U);
      if (ends == SplineEnds::ignored) continue;
      EXPECT_NEAR(shorter_turn(start_pose(path).heading, 1.0), 0.0, 1e-12);
      EXPECT_NEAR(shorter_turn(end_pose(path).heading, 0.5), 0.0, 1e-12);
    }
  }
}

TEST(SplineCurve, ABSplineKeepsItsHeadingsByLeads) {
  const Problem problem = prepared(hall({0, 0, 1.0}, {20, 8, -0.5}, 0.3));
  const std::vector<Vec2> points{{5, 3}, {9, -2}, {14, 7}};
  const auto curve = spline_curve(problem, SplineForm::bspline, SplineEnds::kept, points, {2.0, 1.5});
  ASSERT_TRUE(curve);
  EXPECT_EQ(curve->spans.size(), 4U);
  EXPECT_NEAR(evaluate(curve->spans.front(), 0.0).course, 1.0, 1e-12);
  EXPECT_NEAR(evaluate(curve->spans.back(), 1.0).course, -0.5, 1e-12);
  // Points that coincide have no course between them.
  EXPECT_FALSE(spline_curve(problem, SplineForm::cubic, SplineEnds::turned, std::vector<Vec2>{{5, 3}, {5, 3}}));
}

TEST(SplineCurve, SamplesAreOnTheCurveAtMostAStepApart) {
  const Problem problem = prepared(hall({0, 0, 2.0}, {20, 8, -0.5}, 0.3));
  const auto curve = spline_curve(problem, SplineForm::cubic, SplineEnds::turned, std::vector<Vec2>{{5, 3}, {9, -2}, {14, 7}});
  ASSERT_TRUE(curve);
  std::vector<SplineSample> samples;
  sample_by_step(problem, *curve, 0.1, samples);
  double length = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    EXPECT_LE(distance(samples[i - 1].pose.position(), samples[i].pose.position()), 0.2);
    EXPECT_LE(std::abs(shorter_turn(samples[i - 1].pose.heading, samples[i].pose.heading)), 0.5);
    length += samples[i].along;
  }
  double exact = 0.0;
  for (const BezierSpan& span : curve->spans) exact += arc_length(span);
  EXPECT_NEAR(length, exact, 1e-3 * exact);
  EXPECT_EQ(samples.front().pose, problem.start());
  EXPECT_EQ(samples.back().pose.position(), problem.goal().position());
  EXPECT_NEAR(shorter_turn(samples.back().pose.heading, problem.goal().heading), 0.0, 1e-12);
  for (const SplineForm form : {SplineForm::cubic, SplineForm::bspline}) {
    std::vector<Pose> poses;
    sample_by_parameter(form, *curve, 200, poses);
    ASSERT_EQ(poses.size(), 200U);
    EXPECT_EQ(poses.front().position(), problem.start().position());
    EXPECT_EQ(poses.back().position(), problem.goal().position());
  }
}

TEST(SplineFitness, WeightsAreThoseOfThePublicationForItsExtrema) {
  // Table 8: length 64.53, energy 92.37 of CAPSO, turning 3.85 (E14); 67.98, 6.562, 91.16 of the GA; risk 0.
  const SplineWeights capso = normalised_weights(64.53, 0.0, 68.25, 3.85, 92.37), ga = normalised_weights(67.98, 0.0, 69.95, 6.562, 91.16);
  EXPECT_EQ(capso.length, 1.0);
  EXPECT_EQ(capso.risk, 100.0);
  EXPECT_NEAR(capso.time, SplineWeights{}.time, 0.01);
  EXPECT_NEAR(capso.turning, SplineWeights{}.turning, 0.01);
  EXPECT_NEAR(capso.energy, SplineWeights{}.energy, 0.01);
  EXPECT_NEAR(ga.time, weights_of_ga.time, 0.01);
  EXPECT_NEAR(ga.turning, weights_of_ga.turning, 0.01);
  EXPECT_NEAR(ga.energy, weights_of_ga.energy, 0.01);
  EXPECT_EQ(normalised_weights(50.0, 0.1, 50.0, 0.0, -3.0).turning, 100.0);
  EXPECT_EQ(normalised_weights(50.0, 0.1, 50.0, 0.0, -3.0).risk, 100.0);
  EXPECT_EQ(normalised_weights(50.0, 0.1, 50.0, 0.0, -3.0).energy, 100.0);
}

TEST(SplineFitness, MeasuresAreThoseOfTheFormulas) {
  Scenario s = hall({0, 0, 0}, {20, 8, 0}, 1.0);
  s.vehicle.limits.speed = 2.0;
  s.map.points = {{3.0, 1.0}};
  CellGrid grid;  // one occupied cell with its centre at (10, 1), one out of reach
  grid.columns = 4;
  grid.rows = 6;
  grid.cell = 1.0;
  grid.origin = {8.5, 0.5, 0.0};
  grid.bounds = false;
  grid.blocked.assign(24, 0);
  grid.blocked[5 * 4 + 1] = 1;
  grid.blocked[0] = 1;
  s.map.grids = {grid};
  s.start = {0, -2, 0};
  const Problem problem = prepared(std::move(s));
  const SplineMeasurer measurer{problem};
  EXPECT_NEAR(measurer.risk_at({3.0, 0.0}), 0.7788, 1e-4);                                       // d = 1, q = 2, C = 1
  EXPECT_NEAR(measurer.risk_at({3.0, 2.6}), 0.0, 0.0);                                           // beyond 1.5 m
  EXPECT_NEAR(measurer.risk_at({10.0, 0.0}), std::exp(-0.25), 1e-12);                            // a cell's centre, not its edge
  EXPECT_NEAR(measurer.risk_at({9.0, 0.0}), std::exp(-0.25 * std::sqrt(2.0)), 1e-12);
  // A square corner: 3 m, 4 m, a quarter turn, clear of everything but the scan point.
  const std::vector<Pose> poses{{-2, -3, 0}, {1, -3, 0}, {1, 1, pi / 2}};
  const SplineMeasures m = measurer.measure(poses);
  EXPECT_DOUBLE_EQ(m.length, 7.0);
  EXPECT_DOUBLE_EQ(m.time, 3.5);
  EXPECT_NEAR(m.turning, pi / 2, 1e-15);
  EXPECT_NEAR(m.energy, 100.0 - 0.7 - 0.25, 1e-12);
  EXPECT_EQ(m.collisions, 0);
  EXPECT_EQ(measurer.measure(std::vector<Pose>{{1, 1, 0}, {2.5, 1, 0}}).collisions, 1);
  EXPECT_NEAR(fitness_of(m, {1, 100, 0.94, 16.76, 0.69}), 7.0 + 100 * m.risk + 0.94 * 3.5 + 16.76 * pi / 2 - 0.69 * m.energy, 1e-12);
}

TEST(SplineFitness, DoesNotChangeWhereEverythingIsMovedAndTurned) {
  Random random{3};
  for (int k = 0; k < 30; ++k) {
    Scenario s = hall({0, 0, 0.3}, {20, 8, -0.4}, 0.4);
    for (int i = 0; i < 4; ++i) {
      const Vec2 at{random.uniform(3, 17), random.uniform(-3, 12)};
      s.map.obstacles.push_back({at, at + Vec2{1.5, 0.2}, at + Vec2{0.7, 1.3}});
      s.map.points.push_back({random.uniform(3, 17), random.uniform(-3, 12)});
    }
    const Frame frame{Pose{random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-3, 3)}};
    Scenario moved = s;
    const auto move = [&](Vec2& p) { p = frame.to_world(p); };
    for (Ring& ring : moved.map.boundaries) for (Vec2& p : ring) move(p);
    for (Ring& ring : moved.map.obstacles) for (Vec2& p : ring) move(p);
    for (Vec2& p : moved.map.points) move(p);
    const auto pose = [&](const Pose& p) { return make_pose(frame.to_world(p.position()), wrap(p.heading + frame.heading())); };
    moved.start = pose(s.start);
    moved.mission = pose(std::get<Pose>(s.mission));
    const Problem here = prepared(s), there = prepared(moved);
    for (const SplineForm form : {SplineForm::cubic, SplineForm::bspline}) {
      SplineOptions options;
      options.curve = form;
      SplineCandidates a{here, options}, b{there, options};
      std::vector<Vec2> points, points_there;
      for (int i = 0; i < 6; ++i) {
        points.push_back({3.0 * i + random.uniform(1, 3), random.uniform(-2, 10)});
        points_there.push_back(frame.to_world(points.back()));
      }
      const auto curve = spline_curve(here, form, SplineEnds::turned, points), curve_there = spline_curve(there, form, SplineEnds::turned, points_there);
      ASSERT_TRUE(curve && curve_there);
      const SplineMeasures m = a.measures_of(*curve), n = b.measures_of(*curve_there);
      EXPECT_NEAR(fitness_of(m, {}), fitness_of(n, {}), 1e-6);
      EXPECT_EQ(m.collisions, n.collisions);
      const auto p = a.parts_of(*curve), q = b.parts_of(*curve_there);
      EXPECT_NEAR(p.sum(), q.sum(), 1e-6 * p.sum());
      EXPECT_NEAR(p.violation, q.violation, 1e-6);
    }
  }
}

TEST(SplineCandidates, PlainestIsTheStraightLineAndPointsStayInOrderInTheMap) {
  const Problem problem = prepared(hall({0, 0, 0}, {20, 8, 0}, 0.3));
  Random random{4};
  for (const ControlSpace space : {ControlSpace::line, ControlSpace::map, ControlSpace::guide}) {
    SplineOptions options;
    options.space = space;
    const SplineCandidates candidates{problem, options};
    EXPECT_EQ(candidates.space().dimension(), 12U);
    const auto points = candidates.control_points(candidates.plainest());
    for (std::size_t i = 0; i < 6; ++i) EXPECT_LT(distance(points[i], (static_cast<double>(i + 1) / 7.0) * Vec2{20, 8}), 1e-9);
    if (space != ControlSpace::map) continue;
    for (int k = 0; k < 100; ++k) {
      const auto drawn = candidates.control_points(random_point(candidates.space(), random));
      for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_TRUE((Box{{-5, -5}, {25, 15}}).contains(drawn[i]));
        if (i > 0) {
          EXPECT_LE(dot(drawn[i - 1], Vec2{20, 8}), dot(drawn[i], Vec2{20, 8}));
        }
      }
    }
  }
}

TEST(SplineCandidates, WhatTouchesIsNotFeasibleAndTheDeeperTheWorse) {
  Scenario s = hall({0, 0, 0}, {20, 0, 0}, 0.3);
  s.map.obstacles = {rectangle({9, -2}, {11, 2})};
  s.clearance = 0.1;
  const Problem problem = prepared(std::move(s));
  SplineOptions options;
  SplineCandidates candidates{problem, options};
  const auto with_middle_at = [&](double y) { return candidates.parts_of(*spline_curve(problem, SplineForm::cubic, SplineEnds::turned, std::vector<Vec2>{{8, y}, {12, y}})); };
  EXPECT_EQ(with_middle_at(4.0).violation, 0.0);
  EXPECT_GT(with_middle_at(2.2).violation, 0.0);
  double before = with_middle_at(2.2).violation;
  for (const double y : {1.6, 1.0, 0.4}) {
    const double now = with_middle_at(y).violation;
    EXPECT_GT(now, before) << y;
    before = now;
  }
}

TEST(Guide, LeadsAroundObstaclesAndGivesAsManyPointsAsAsked) {
  Scenario s = hall({0, 0, 0}, {20, 0, 0}, 0.3);
  s.map.obstacles = {rectangle({9, -5}, {11, 3})};
  const Problem problem = prepared(std::move(s));
  Budget budget;
  const Guide guide = guide_for(problem, 0.5, budget);
  EXPECT_EQ(budget.evaluations(), 0);
  ASSERT_GE(guide.corners.size(), 4U) << "around two corners";
  EXPECT_EQ(guide.corners.front(), problem.start().position());
  EXPECT_LT(distance(guide.corners.back(), problem.goal().position()), 1e-9);
  for (std::size_t count = 1; count <= 12; ++count) {
    const auto points = points_along(guide.corners, count);
    ASSERT_EQ(points.size(), count);
    for (const Vec2 p : points) {
      double off = 1e9;
      for (std::size_t i = 0; i + 1 < guide.corners.size(); ++i) off = std::min(off, point_segment_distance(p, guide.corners[i], guide.corners[i + 1]));
      EXPECT_LT(off, 1e-9);
    }
  }
  // Walled off: no guide, and a raised flag ends it.
  Scenario walled = hall({0, 0, 0}, {20, 0, 0}, 0.3);
  walled.map.obstacles = {rectangle({9, -5}, {11, 15})};
  Budget more;
  EXPECT_TRUE(guide_for(prepared(std::move(walled)), 0.5, more).corners.empty());
  std::atomic<bool> cancel{true};
  Budget canceled{{}, &cancel};
  EXPECT_TRUE(guide_for(problem, 0.5, canceled).corners.empty());
}

}  // namespace
}  // namespace waywright
