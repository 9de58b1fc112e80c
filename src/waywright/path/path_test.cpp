#include "waywright/path/path.hpp"

#include <gtest/gtest.h>

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

TEST(Sampling, TurnsOnTheSpotKeepTheirPlace) {
  const Path path{{{Turn{{1, 2}, 3.0, 1.0}, 0}}};
  const auto samples = sample(path, 1.0, tolerance);
  expect_dense(samples);
  EXPECT_EQ(samples.front().s, samples.back().s);
  EXPECT_NEAR(shorter_turn(samples.front().heading, samples.back().heading), 1.0, 1e-12);
  EXPECT_EQ(length(path), 0.0);
}

TEST(Sample, WhatWouldTakeAllMemoryIsNotSampled) {
  PoseSequence far;
  for (int i = 0; i < 60; ++i) far.poses.push_back({i % 2 == 0 ? -1e6 : 1e6, 0.0, 0.0});
  EXPECT_TRUE(sample({{{far, 1}}}, 1.0, 5e-4).empty());
  EXPECT_TRUE(sample({{{Turn{{0, 0}, 0.0, 1e12}, 0}}}, 1.0, 5e-4).empty());
  EXPECT_TRUE(sample({{{Line{{-1e6, 0}, {1e6, 0}}, 1}}}, 1.0, 5e-4).empty());
  EXPECT_TRUE(sample({{{Arc{{0, 0, 0}, 1e6, 1e3}, 1}}}, 1.0, 5e-4).size() > 20000U) << "bends are cut off, lengths are not";
  expect_dense(sample({{{Line{{0, 0}, {3000, 0}}, 1}, {PoseSequence{{{3000, 0, 0}, {9000, 0, 0}}}, 1}}}, 1.0, 5e-4));
}

}  // namespace
}  // namespace waywright
