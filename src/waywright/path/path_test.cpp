#include "waywright/path/path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/curve/arc.hpp"
#include "waywright/curve/bezier.hpp"

namespace waywright {
namespace {

constexpr double radius = 2.4, tolerance = 5e-4;

void expect_dense(const std::vector<Sample>& samples) {
  for (std::size_t i = 1; i < samples.size(); ++i) {
    EXPECT_GE(samples[i].s, samples[i - 1].s);
    EXPECT_LE(samples[i].s - samples[i - 1].s, 0.05 + 1e-9);
    EXPECT_LE(std::abs(shorter_turn(samples[i - 1].heading, samples[i].heading)), 0.05 + 1e-9);
  }
}

TEST(Sampling, StraightInterpolationStaysWithinTheTolerance) {
  Random random{8};
  for (int i = 0; i < 100; ++i) {
    const Vec2 b{random.uniform(1, 6), random.uniform(-4, 4)};
    const double m = norm(b) * random.uniform(0.7, 1.5);
    const BezierSpan span = straight_ended_quintic({}, m * unit(random.uniform(-1.5, 1.5)), b, m * unit(random.uniform(-1.5, 1.5)));
    const Path path{{{Spline{SplineKind::quintic, {span}}, random.uniform() < 0.5 ? 1 : -1}}};
    const auto samples = sample(path, radius, tolerance);
    expect_dense(samples);
    EXPECT_NEAR(samples.back().s, length(path), 1e-9);
    const ArcLengthTable table{span};
    for (std::size_t k = 1; k < samples.size(); k += 7) {
      const Sample& a = samples[k - 1];
      const Sample& c = samples[k];
      const CurvePoint truth = evaluate(span, table.parameter(0.5 * (a.s + c.s)));
      const double heading = truth.course + (path.pieces[0].direction < 0 ? pi : 0.0);
      const Pose middle = make_pose(0.5 * (a.pose().position() + c.pose().position()), a.heading + 0.5 * shorter_turn(a.heading, c.heading));
      for (const Vec2 body : {Vec2{radius, 0}, Vec2{-radius, 0}, Vec2{0, radius}}) {
        EXPECT_LE(distance(Frame{middle}.to_world(body), Frame{make_pose(truth.position, heading)}.to_world(body)), tolerance);
      }
    }
  }
}

TEST(Sampling, PosesStandTwiceWhereTheVehicleStands) {
  const Arc back{{0, 0, pi}, 0.4, 2.0};  // course π: driven backwards the vehicle looks along +x
  Path path{{{back, -1}}};
  const Pose end = end_pose(path);
  path.pieces.push_back({Line{end.position(), end.position() + 1.5 * unit(end.heading)}, 1});
  path.pieces.push_back({Line{end_pose(path).position(), end_pose(path).position() + 1.0 * unit(end.heading)}, 1});
  path.pieces.push_back({Arc{end_pose(path), 0.3, 1.0}, 1});
  const auto samples = sample(path, radius, tolerance);
  expect_dense(samples);
  EXPECT_NEAR(samples.front().heading, 0.0, 1e-12);
  int twice = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) twice += samples[i].s == samples[i - 1].s ? 1 : 0;
  EXPECT_EQ(twice, 2);  // the change of direction and the jump of curvature; not the joint of the two lines
  EXPECT_NEAR(samples.back().s, 5.5, 1e-9);
}

/// Greatest distance of a footprint point between the straight interpolation of two samples and the true motion, looked up finely.
double interpolation_error(const Spline& spline, const std::vector<Sample>& samples) {
  double worst = 0.0;
  double before = 0.0;
  std::size_t i = 0;
  for (const BezierSpan& span : spline.spans) {
    const ArcLengthTable table{span};
    for (int k = 0; k <= 4000; ++k) {
      const double s = table.length() * k / 4000.0;
      const CurvePoint truth = evaluate(span, table.parameter(s));
      while (i + 2 < samples.size() && samples[i + 1].s < before + s) ++i;
      const Sample& a = samples[i];
      const Sample& b = samples[i + 1];
      const double t = b.s > a.s ? std::clamp((before + s - a.s) / (b.s - a.s), 0.0, 1.0) : 0.0;
      const Pose even = make_pose(a.pose().position() + t * (b.pose().position() - a.pose().position()), a.heading + t * shorter_turn(a.heading, b.heading));
      for (const Vec2 body : {Vec2{radius, 0}, Vec2{0, radius}}) {
        worst = std::max(worst, distance(Frame{even}.to_world(body), Frame{make_pose(truth.position, truth.course)}.to_world(body)));
      }
    }
    before += table.length();
  }
  return worst;
}

TEST(Sampling, SpansThatMeetWithDifferentCurvatureShareTwoSamples) {
  const double h = 4.0 / 3.0 * std::tan(0.25) * 2.0;
  const Vec2 end{2.003 + 2.0 * std::sin(1.0), 2.0 - 2.0 * std::cos(1.0)};
  const Spline spline{SplineKind::quintic, {straight_span({0, 0}, {2.003, 0}), {3, {Vec2{2.003, 0}, {2.003 + h, 0}, end - h * unit(1.0), end}}}};
  const auto samples = sample(Path{{{spline, 1}}}, radius, tolerance);
  expect_dense(samples);
  int twice = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples[i].s != samples[i - 1].s) continue;
    ++twice;
    EXPECT_NEAR(samples[i].x, 2.003, 1e-12);
    EXPECT_EQ(samples[i - 1].curvature, 0.0);
    EXPECT_NEAR(samples[i].curvature, 0.5, 0.01);
  }
  EXPECT_EQ(twice, 1);
  EXPECT_LE(interpolation_error(spline, samples), tolerance);
}

TEST(Sampling, TheToleranceHoldsAtPeaksOfAnyWidth) {
  Random random{17};
  for (int i = 0; i < 120; ++i) {
    BezierSpan span{5, {}};
    for (Vec2& p : span.control) p = {random.uniform(-2, 2), random.uniform(-2, 2)};
    const Spline spline{SplineKind::quintic, {span}};
    const Path path{{{spline, 1}}};
    if (!(samples_needed(path, radius, tolerance) < 20'000.0)) continue;
    const auto samples = sample(path, radius, tolerance);
    EXPECT_LE(static_cast<double>(samples.size()), samples_needed(path, radius, tolerance));
    EXPECT_LE(interpolation_error(spline, samples), tolerance) << i;
  }
}

TEST(Sampling, ThereAreNeverMoreThanTheMost) {
  PoseSequence far;
  for (int i = 0; i < 300; ++i) far.poses.push_back({i % 2 == 0 ? 0.0 : 500'000.0, 0.0, 0.0});
  const Path path{{{far, 1}, {Arc{{}, 1e6, 60.0}, 1}, {Turn{{}, 0.0, 1e5}, 0}}};
  EXPECT_GT(samples_needed(path, radius, tolerance), 1e9);
  EXPECT_LE(sample(path, radius, tolerance).size(), most_samples + 2 * 302);
}

// What is bounded at a glance is decided as by counting, on paths of any size, cusps among them.
TEST(Sampling, WhetherThereAreTooManyIsAsCounted) {
  Random random{12};
  int too_many = 0, few = 0;
  for (int i = 0; i < 2000; ++i) {
    BezierSpan span;
    span.degree = static_cast<int>(random.integer(1, 5));
    const double size = std::pow(10.0, random.uniform(-1.0, 6.0));
    for (Vec2& p : span.control) p = {size * random.uniform(-1, 1), size * random.uniform(-1, 1)};
    const Path path{{{Spline{SplineKind::quintic, {span}}, 1}}};
    const bool can = samples_needed(path, radius, tolerance) <= most_samples;
    EXPECT_EQ(can_be_sampled(path, radius, tolerance), can) << i;
    ++(can ? few : too_many);
  }
  EXPECT_GT(few, 500);
  EXPECT_GT(too_many, 50);
}

TEST(Sampling, TurnsOnTheSpotKeepTheirPlace) {
  const Path path{{{Turn{{1, 2}, 3.0, 1.0}, 0}}};
  const auto samples = sample(path, 1.0, tolerance);
  expect_dense(samples);
  EXPECT_EQ(samples.front().s, samples.back().s);
  EXPECT_NEAR(shorter_turn(samples.front().heading, samples.back().heading), 1.0, 1e-12);
  EXPECT_EQ(length(path), 0.0);
}

}  // namespace
}  // namespace waywright
