// Headings of their own along lines and arcs: ends, samples, the way back, what is left.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/curve/arc.hpp"
#include "waywright/path/path.hpp"
#include "waywright/path/remainder.hpp"

namespace waywright {
namespace {

/// 2 m straight on, a corner to the left, an arc; the heading turns by a radian and a half in all.
Path sliding() {
  Path path;
  path.pieces.push_back({Line{{0, 0}, {2, 0}}, 1, HeadingAlong{0.5, 1.0}});
  path.pieces.push_back({Arc{{2, 0, 0.5 * pi}, 0.5, 1.0}, 1, HeadingAlong{1.5, 0.5}});
  return path;
}

void expect_same(const Pose& a, const Pose& b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(shorter_turn(a.heading, b.heading), 0.0, 1e-12);
}

TEST(HeadingAlong, EndsAreThoseTold) {
  const Path path = sliding();
  expect_same(start_pose(path), {0, 0, 0.5});
  expect_same(end_pose(path.pieces[0]), {2, 0, 1.5});
  EXPECT_NEAR(end_pose(path).heading, 2.0, 1e-12);
  EXPECT_DOUBLE_EQ(length(path), 3.0);
}

TEST(HeadingAlong, SamplesTurnEvenlyAndTellTheirCourse) {
  const std::vector<Sample> samples = sample(sliding(), 1.0, 5e-4);
  int corners = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    EXPECT_FALSE(s.faces_along);
    EXPECT_NEAR(s.heading, 0.5 + 0.5 * s.s, 1e-9);
    EXPECT_DOUBLE_EQ(s.turning(), 0.5);
    EXPECT_EQ(s.turning_rate(), 0.0);
    if (s.piece == 0) {
      EXPECT_EQ(s.course, 0.0);
    }
    if (i == 0) continue;
    EXPECT_LE(std::abs(shorter_turn(samples[i - 1].heading, s.heading)), 0.05 + 1e-9);
    corners += is_course_jump(samples[i - 1], s) ? 1 : 0;
  }
  EXPECT_EQ(corners, 1);
  EXPECT_NEAR(samples.back().course, 0.5 * pi + 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(samples.back().curvature, 0.5);
}

// A turn of many rounds on a short way has as many samples as its turning needs.
TEST(HeadingAlong, TurningAloneMakesSamplesDense) {
  Path path;
  path.pieces.push_back({Line{{0, 0}, {0.01, 0}}, 1, HeadingAlong{0.0, 20.0}});
  const std::vector<Sample> samples = sample(path, 2.0, 5e-4);
  EXPECT_LE(static_cast<double>(samples.size()), samples_needed(path, 2.0, 5e-4));
  for (std::size_t i = 1; i < samples.size(); ++i) EXPECT_LE(std::abs(shorter_turn(samples[i - 1].heading, samples[i].heading)), 0.05 + 1e-9);
}

// A line and an arc that touch, turning at one rate: one sample at the joint, as nothing jumps but the curvature.
// Both the arc's chords and the turning's carry a point of the footprint off what lies between samples; together they keep the tolerance.
TEST(HeadingAlong, NoPointOfTheFootprintLeavesWhatLiesBetweenSamplesByMoreThanTheTolerance) {
  constexpr double radius = 1.5, tolerance = 5e-5;
  double greatest = 0.0;
  for (const double curvature : {0.0, 0.5, -2.0, 5.0}) {
    for (const double turn : {0.0, 1.0, 1.3, -4.0, 7.0}) {
      Path path;
      const Arc arc{{0, 0, 0}, curvature, 1.7};
      if (curvature == 0.0) path.pieces.push_back({Line{{0, 0}, {1.7, 0}}, 1, HeadingAlong{0.2, turn}});
      else path.pieces.push_back({arc, 1, HeadingAlong{0.2, turn}});
      const std::vector<Sample> samples = sample(path, radius, tolerance);
      for (std::size_t i = 1; i < samples.size(); ++i) {
        const Sample &a = samples[i - 1], &b = samples[i];
        const double s = 0.5 * (a.s + b.s), heading = 0.2 + turn * s / 1.7;
        const Vec2 at = curvature == 0.0 ? Vec2{s, 0.0} : evaluate(arc, s).position;
        for (int k = 0; k < 16; ++k) {
          const Vec2 corner = radius * unit(wrap(two_pi * k / 16.0));
          const Pose middle = make_pose({0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}, a.heading + 0.5 * shorter_turn(a.heading, b.heading));
          const Vec2 between = 0.5 * (Frame{a.pose()}.to_world(corner) + Frame{b.pose()}.to_world(corner));
          const Vec2 is = Frame{make_pose(at, heading)}.to_world(corner);
          EXPECT_LE(distance(is, Frame{middle}.to_world(corner)), tolerance);
          EXPECT_LE(distance(is, between), tolerance);
          greatest = std::max(greatest, distance(is, between));
        }
      }
    }
  }
  EXPECT_GT(greatest, 0.5 * tolerance) << "samples are not much denser than needed";
}

TEST(HeadingAlong, ASmoothJointStandsOnceWhereNothingJumps) {
  Path path;
  path.pieces.push_back({Line{{0, 0}, {1, 0}}, 1, HeadingAlong{0.0, 0.3}});
  path.pieces.push_back({Line{{1, 0}, {2, 0}}, 1, HeadingAlong{0.3, 0.3}});
  const std::vector<Sample> samples = sample(path, 1.0, 5e-4);
  for (std::size_t i = 1; i < samples.size(); ++i) EXPECT_GT(samples[i].s, samples[i - 1].s);
}

TEST(HeadingAlong, TwiceReversedIsTheSame) {
  const Path path = sliding();
  const Path back = reversed(path);
  expect_same(start_pose(back), end_pose(path));
  expect_same(end_pose(back), start_pose(path));
  const Path again = reversed(back);
  for (std::size_t i = 0; i < path.pieces.size(); ++i) {
    EXPECT_EQ(again.pieces[i].direction, 1);
    expect_same(start_pose(again.pieces[i]), start_pose(path.pieces[i]));
    expect_same(end_pose(again.pieces[i]), end_pose(path.pieces[i]));
    EXPECT_NEAR(again.pieces[i].heading->turn, path.pieces[i].heading->turn, 1e-12);
  }
}

TEST(HeadingAlong, WhatIsLeftGoesOnFromTheHeadingThere) {
  for (const double driven : {0.0, 0.7, 2.0, 2.4}) {
    const Path rest = remainder(sliding(), driven);
    EXPECT_NEAR(start_pose(rest).heading, 0.5 + 0.5 * driven, 1e-9) << driven;
    EXPECT_NEAR(length(rest), 3.0 - driven, 1e-9);
    expect_same(end_pose(rest), end_pose(sliding()));
  }
}

}  // namespace
}  // namespace waywright
