// Headings of their own along lines and arcs: ends, samples, the way back, what is left.
#include <gtest/gtest.h>

#include <cmath>

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
