// Identities of the curves: see the headers.
#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/curve/arc.hpp"
#include "waywright/curve/bezier.hpp"

namespace waywright {
namespace {

BezierSpan random_span(Random& random) {
  BezierSpan span;
  span.degree = static_cast<int>(random.integer(1, 5));
  for (Vec2& p : span.control) p = {random.uniform(-5, 5), random.uniform(-5, 5)};
  return span;
}

double chord_sum(const BezierSpan& span, double u0, double u1, int n) {
  double sum = 0.0;
  Vec2 before = derivatives(span, u0).p;
  for (int i = 1; i <= n; ++i) {
    const Vec2 now = derivatives(span, u0 + (u1 - u0) * i / n).p;
    sum += distance(before, now);
    before = now;
  }
  return sum;
}

TEST(Bezier, DerivativesAgreeWithDifferences) {
  Random random{1};
  for (int i = 0; i < 300; ++i) {
    const BezierSpan span = random_span(random);
    const double u = random.uniform(0.1, 0.9);
    const double h = 1e-5;
    const Derivatives d = derivatives(span, u);
    const Derivatives a = derivatives(span, u - h);
    const Derivatives b = derivatives(span, u + h);
    EXPECT_NEAR(distance((0.5 / h) * (b.p - a.p), d.d1), 0.0, 1e-5 * (1.0 + norm(d.d3)));
    EXPECT_NEAR(distance((0.5 / h) * (b.d1 - a.d1), d.d2), 0.0, 1e-4 * (1.0 + norm(d.d3)));
    EXPECT_NEAR(distance((0.5 / h) * (b.d2 - a.d2), d.d3), 0.0, 1e-3 * (1.0 + norm(d.d3)));
  }
}

TEST(Bezier, CurvatureAndItsRateAgreeWithDifferencesOfCourse) {
  Random random{2};
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    const BezierSpan span = random_span(random);
    const double u = random.uniform(0.1, 0.9);
    const double speed = norm(derivatives(span, u).d1);
    if (speed < 2.0) continue;
    ++compared;
    const double h = 1e-5;
    const CurvePoint a = evaluate(span, u - h);
    const CurvePoint b = evaluate(span, u + h);
    const CurvePoint p = evaluate(span, u);
    EXPECT_NEAR(shorter_turn(a.course, b.course) / (2 * h * speed), p.curvature, 1e-4 * (1.0 + std::abs(p.curvature)));
    EXPECT_NEAR((b.curvature - a.curvature) / (2 * h * speed), p.curvature_rate, 1e-3 * (1.0 + std::abs(p.curvature_rate)));
  }
  EXPECT_GT(compared, 100);
}

TEST(Bezier, HalvesJoinAndAreTheCurve) {
  Random random{3};
  for (int i = 0; i < 300; ++i) {
    const BezierSpan span = random_span(random);
    const auto [left, right] = halve(span);
    const double u = random.uniform();
    EXPECT_NEAR(distance(derivatives(left, u).p, derivatives(span, 0.5 * u).p), 0.0, 1e-12);
    EXPECT_NEAR(distance(derivatives(right, u).p, derivatives(span, 0.5 + 0.5 * u).p), 0.0, 1e-12);
  }
}

TEST(Bezier, ArcLengthTableInvertsItsLength) {
  Random random{4};
  for (int i = 0; i < 60; ++i) {
    const Vec2 a{}, b{random.uniform(1, 6), random.uniform(-3, 3)};
    const double m = norm(b) * random.uniform(0.5, 1.8);
    const BezierSpan span = straight_ended_quintic(a, m * unit(random.uniform(-1.2, 1.2)), b, m * unit(random.uniform(-1.2, 1.2)));
    const ArcLengthTable table{span};
    EXPECT_NEAR(table.length(), chord_sum(span, 0, 1, 40000), 1e-6 * table.length());
    for (const double share : {0.0, 0.1, 0.37, 0.5, 0.93, 1.0}) {
      const double u = table.parameter(share * table.length());
      EXPECT_NEAR(arc_length(span, 0.0, u, 32), share * table.length(), 1e-10 * table.length());
    }
  }
}

TEST(NaturalCubic, InterpolatesSmoothlyAndIsStraightAtItsEnds) {
  const std::vector<Vec2> points{{0, 0}, {1, 0.2}, {2.5, 1.5}, {2, 4}, {0, 5}};
  const auto spans = natural_cubic(points);
  ASSERT_EQ(spans.size(), 4U);
  for (std::size_t i = 0; i < spans.size(); ++i) {
    EXPECT_NEAR(distance(derivatives(spans[i], 0).p, points[i]), 0.0, 1e-14);
    EXPECT_NEAR(distance(derivatives(spans[i], 1).p, points[i + 1]), 0.0, 1e-14);
    if (i == 0) continue;
    EXPECT_NEAR(evaluate(spans[i - 1], 1).course, evaluate(spans[i], 0).course, 1e-12);
    EXPECT_NEAR(evaluate(spans[i - 1], 1).curvature, evaluate(spans[i], 0).curvature, 1e-12);
  }
  EXPECT_NEAR(evaluate(spans.front(), 0).curvature, 0.0, 1e-12);
  EXPECT_NEAR(evaluate(spans.back(), 1).curvature, 0.0, 1e-12);
}

TEST(Arc, EndsWhereTheCircleDoes) {
  const CurvePoint quarter = evaluate(Arc{{1, 2, 0}, 0.5, pi}, pi);  // radius 2, a quarter turn
  EXPECT_NEAR(quarter.position.x, 3.0, 1e-12);
  EXPECT_NEAR(quarter.position.y, 4.0, 1e-12);
  EXPECT_NEAR(quarter.course, pi / 2, 1e-12);
  Random random{5};
  for (int i = 0; i < 300; ++i) {
    const Arc arc{{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-pi, pi)}, random.uniform(-1, 1) * std::pow(10.0, random.uniform(-9, 0)),
                  random.uniform(0.1, 20)};
    const double s = random.uniform(0, arc.length);
    const CurvePoint middle = evaluate(arc, s);
    const Arc rest{make_pose(middle.position, middle.course), arc.curvature, arc.length - s};
    EXPECT_NEAR(distance(evaluate(rest, rest.length).position, evaluate(arc, arc.length).position), 0.0, 1e-11);
  }
}

}  // namespace
}  // namespace waywright
