#include "waywright/core/angle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

TEST(Angle, WrapsIntoTheHalfOpenCircle) {
  EXPECT_EQ(wrap(pi), pi);
  EXPECT_EQ(wrap(-pi), pi);
  EXPECT_EQ(wrap(0.0), 0.0);
  EXPECT_NEAR(wrap(3 * pi), pi, 1e-15);
  EXPECT_NEAR(wrap(-3 * pi), pi, 1e-15);
  EXPECT_NEAR(wrap(1.5 * pi), -0.5 * pi, 1e-15);
  EXPECT_EQ(wrap(1.25), 1.25);  // exact where nothing is to be done
}

TEST(Angle, LawsOfWrap) {
  Random random{1};
  for (int i = 0; i < 100000; ++i) {
    const double angle = random.uniform(-4, 4) * std::pow(10.0, random.uniform(-3, 6));
    const double wrapped = wrap(angle);
    ASSERT_GT(wrapped, -pi);
    ASSERT_LE(wrapped, pi);
    ASSERT_EQ(wrap(wrapped), wrapped);
    const double slack = 1e-15 * std::abs(angle) + 1e-15;
    ASSERT_NEAR(std::cos(wrapped), std::cos(angle), slack) << angle;
    ASSERT_NEAR(std::sin(wrapped), std::sin(angle), slack) << angle;
  }
}

TEST(Angle, NextToTheSeam) {
  const double below = std::nextafter(-pi, 0.0);
  EXPECT_EQ(wrap(below), below);
  EXPECT_GT(wrap(std::nextafter(-pi, -4.0)), 3.14);
  EXPECT_LT(wrap(std::nextafter(pi, 4.0)), -3.14);
}

TEST(Angle, ShorterTurn) {
  EXPECT_NEAR(shorter_turn(3.0, -3.0), two_pi - 6.0, 1e-15);
  EXPECT_NEAR(shorter_turn(-3.0, 3.0), 6.0 - two_pi, 1e-15);
  EXPECT_EQ(shorter_turn(0.5, 0.5), 0.0);
  EXPECT_EQ(shorter_turn(0.0, pi), pi);
  EXPECT_EQ(shorter_turn(pi, 0.0), pi);  // half a circle is told as a left turn
  Random random{2};
  for (int i = 0; i < 10000; ++i) {
    const double from = random.uniform(-pi, pi);
    const double to = random.uniform(-pi, pi);
    const double turn = shorter_turn(from, to);
    ASSERT_LE(std::abs(turn), pi);
    ASSERT_NEAR(std::cos(from + turn), std::cos(to), 1e-14);
    ASSERT_NEAR(std::sin(from + turn), std::sin(to), 1e-14);
  }
}

}  // namespace
}  // namespace waywright
