#include "waywright/core/pose.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

TEST(Vec2, Products) {
  constexpr Vec2 a{3, 4};
  constexpr Vec2 b{-1, 2};
  static_assert(dot(a, b) == 5.0);
  static_assert(cross(a, b) == 10.0);
  static_assert(cross(b, a) == -10.0);
  static_assert(left_of(a) == Vec2{-4, 3});
  EXPECT_EQ(norm(a), 5.0);
  EXPECT_EQ(distance(a, b), std::sqrt(20.0));
  EXPECT_EQ(a + b, (Vec2{2, 6}));
  EXPECT_EQ(2.0 * a - b, (Vec2{7, 6}));
  EXPECT_EQ(-a, (Vec2{-3, -4}));
}

TEST(Vec2, UnitAndAngle) {
  for (const double angle : {-3.0, -1.0, 0.0, 0.5, pi / 2, 3.1})
    EXPECT_NEAR(angle_of(unit(angle)), angle, 1e-15);
}

TEST(Vec2, Finite) {
  EXPECT_TRUE(is_finite(Vec2{1, 2}));
  EXPECT_FALSE(is_finite(Vec2{1, std::numeric_limits<double>::infinity()}));
  EXPECT_FALSE(is_finite(Pose{0, 0, std::numeric_limits<double>::quiet_NaN()}));
}

TEST(Frame, KnownPlacement) {
  // A forklift at (2, 1) that looks along +y: one metre ahead is (2, 2), one to its left is (1, 1).
  const Frame frame{Pose{2, 1, pi / 2}};
  EXPECT_NEAR(distance(frame.to_world(Vec2{1, 0}), {2, 2}), 0.0, 1e-15);
  EXPECT_NEAR(distance(frame.to_world(Vec2{0, 1}), {1, 1}), 0.0, 1e-15);
  const Pose pose = frame.to_world(Pose{1, 0, pi});
  EXPECT_NEAR(pose.heading, -pi / 2, 1e-15);
  EXPECT_EQ(Frame{}.to_world(Vec2{3, 4}), (Vec2{3, 4}));
}

TEST(Frame, RoundTripsAndKeepsDistances) {
  Random random{3};
  for (int i = 0; i < 10000; ++i) {
    const Frame frame{Pose{random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-10, 10)}};
    const Vec2 p{random.uniform(-50, 50), random.uniform(-50, 50)};
    const Vec2 q{random.uniform(-50, 50), random.uniform(-50, 50)};
    ASSERT_NEAR(distance(frame.to_local(frame.to_world(p)), p), 0.0, 1e-12);
    ASSERT_NEAR(distance(frame.to_world(p), frame.to_world(q)), distance(p, q), 1e-12);
    // Turning keeps the sense of turning.
    ASSERT_NEAR(cross(frame.rotate(p), frame.rotate(q)), cross(p, q), 1e-9);
    const Pose pose{p.x, p.y, random.uniform(-pi, pi)};
    const Pose back = frame.to_local(frame.to_world(pose));
    ASSERT_NEAR(distance(back.position(), pose.position()), 0.0, 1e-12);
    ASSERT_NEAR(shorter_turn(back.heading, pose.heading), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace waywright
