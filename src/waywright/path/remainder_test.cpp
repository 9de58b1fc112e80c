#include "waywright/path/remainder.hpp"

#include <gtest/gtest.h>

#include "waywright/core/random.hpp"
#include "waywright/curve/bezier.hpp"

namespace waywright {
namespace {

/// A line, an arc and a spline of three spans driven backwards, a turn, poses.
Path mixed() {
  const Vec2 a{3.0, 0.0};
  const Arc arc{make_pose(a, 0.0), 0.5, 1.2};
  Path path{{{Line{{0.0, 0.0}, a}, 1}, {arc, 1}}};
  const Pose end = end_pose(path);
  const Vec2 back = -unit(end.heading);
  const Vec2 p = end.position(), q = p + 0.7 * back, r{0.0, 2.5}, t{-0.5, 2.5};
  path.pieces.push_back({Spline{SplineKind::quintic, {straight_span(p, q), straight_ended_quintic(q, 2.0 * back, r, {-2.0, 0.0}), straight_span(r, t)}}, -1});
  path.pieces.push_back({Turn{t, 0.0, 1.0}, 0});
  path.pieces.push_back({PoseSequence{{make_pose(t, 1.0), make_pose(t + unit(1.0), 1.0), make_pose(t + 2.5 * unit(1.0), 1.2)}}, 1});
  return path;
}

TEST(Remainder, IsWhatTheSamplesOfTheWholeGoOnWith) {
  const Path path = mixed();
  const double whole = length(path);
  const std::vector<Sample> samples = sample(path, 1.0, 1e-3);
  for (const Sample& s : samples) {
    const Path rest = remainder(path, s.s);
    EXPECT_NEAR(length(rest), whole - s.s, 2e-9) << s.s;
    EXPECT_NEAR(distance(start_pose(rest).position(), s.pose().position()), 0.0, 2e-9) << s.s;
    EXPECT_EQ(end_pose(rest), end_pose(path));
    if (s.direction == 0 || rest.pieces.front().direction != s.direction) continue;
    EXPECT_NEAR(shorter_turn(start_pose(rest).heading, s.heading), 0.0, 1e-8) << s.s;
    if (s.piece == path.pieces.size() - rest.pieces.size() && !std::holds_alternative<PoseSequence>(rest.pieces.front().curve)) {
      EXPECT_NEAR(start_curvature(rest.pieces.front()), s.curvature, 1e-6) << s.s;
    }
  }
}

TEST(Remainder, TwiceIsOnceByTheSum) {
  const Path path = mixed();
  Random random{3};
  for (int i = 0; i < 200; ++i) {
    const double a = random.uniform(0.0, 0.5 * length(path)), b = random.uniform(0.0, 0.4 * length(path));
    const Path once = remainder(path, a + b), twice = remainder(remainder(path, a), b);
    ASSERT_EQ(once.pieces.size(), twice.pieces.size());
    EXPECT_NEAR(distance(start_pose(once).position(), start_pose(twice).position()), 0.0, 1e-8);
    EXPECT_NEAR(length(once), length(twice), 1e-8);
  }
}

TEST(Remainder, WithWhatLiesBeforeItIsThePath) {
  const Path path = mixed();
  const double whole = length(path);
  for (double s = 0.0; s <= whole; s += 0.0371) {
    const Path before = beginning(path, s), rest = remainder(path, s);
    EXPECT_NEAR(length(before), std::max(s, 1e-9), 3e-9) << s;
    EXPECT_EQ(start_pose(before), start_pose(path));
    EXPECT_NEAR(distance(end_pose(before).position(), start_pose(rest).position()), 0.0, 1e-8) << s;
    // Of the same direction they join without a bend.
    if (before.pieces.back().direction == rest.pieces.front().direction) {
      EXPECT_NEAR(shorter_turn(end_pose(before).heading, start_pose(rest).heading), 0.0, 1e-6) << s;
    }
    EXPECT_GE(before.pieces.size() + rest.pieces.size(), path.pieces.size());
  }
  EXPECT_EQ(length(beginning(path, 1e9)), whole);
}

TEST(Remainder, IsNeverEmpty) {
  const Path path = mixed();
  EXPECT_EQ(length(remainder(path, -1.0)), length(path));
  const Path end = remainder(path, 1e9);
  ASSERT_EQ(end.pieces.size(), 1U);
  EXPECT_NEAR(distance(start_pose(end).position(), end_pose(path).position()), 0.0, 1e-8);
}

}  // namespace
}  // namespace waywright
