#include "waywright/drive/odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

constexpr double tight = 1e-12;

TEST(Odometry, StraightAndAQuarterOfACircle) {
  const Pose straight = midpoint_step({}, 1.0, 0.0);
  EXPECT_EQ(straight, (Pose{1.0, 0.0, 0.0}));
  Pose p{}, q{};
  for (int i = 0; i < 1000; ++i) {
    p = midpoint_step(p, 0.5 * pi / 1000.0, 0.5 * pi / 1000.0);
    q = arc_step(q, 0.5 * pi / 1000.0, 0.5 * pi / 1000.0);
  }
  EXPECT_NEAR(p.x, 1.0, 1e-6);
  EXPECT_NEAR(p.y, 1.0, 1e-6);
  EXPECT_NEAR(p.heading, 0.5 * pi, 1e-6);
  EXPECT_NEAR(q.x, 1.0, tight);
  EXPECT_NEAR(q.y, 1.0, tight);
  // Headed along +y it goes along +y: the axes are not mixed up.
  const Pose up = midpoint_step({2.0, 3.0, 0.5 * pi}, 1.5, 0.0);
  EXPECT_NEAR(up.x, 2.0, tight);
  EXPECT_NEAR(up.y, 4.5, tight);
}

TEST(Odometry, AnArcIsTheMotionItselfHoweverItIsCut) {
  Random random{1};
  for (int i = 0; i < 500; ++i) {
    const Pose from{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-pi, pi)};
    const Twist twist{random.uniform(-2, 2), i % 2 == 0 ? 0.0 : random.uniform(-2, 2), i % 7 == 0 ? 0.0 : random.uniform(-3, 3)};
    const double time = random.uniform(0.01, 1.0);
    Pose cut = from;
    for (int k = 0; k < 13; ++k) cut = arc_step(cut, twist, time / 13.0);
    const Pose whole = arc_step(from, twist, time);
    EXPECT_NEAR(distance(cut.position(), whole.position()), 0.0, tight);
    EXPECT_NEAR(shorter_turn(cut.heading, whole.heading), 0.0, tight);
    if (twist.left == 0.0) {
      const double way = twist.forward * time, turn = twist.turn * time;
      EXPECT_LT(distance(arc_step(from, way, turn).position(), whole.position()), tight);
      EXPECT_LE(distance(midpoint_step(from, way, turn).position(), whole.position()), std::abs(way) * turn * turn / 24.0 + tight);
    }
    const Twist back = twist_between(from, whole, time);
    EXPECT_NEAR(back.forward, twist.forward, 1e-11);
    EXPECT_NEAR(back.left, twist.left, 1e-11);
    EXPECT_NEAR(back.turn, twist.turn, 1e-11);
  }
}

void expect_same(const Twist& a, const Twist& b) {
  EXPECT_NEAR(a.forward, b.forward, tight);
  EXPECT_NEAR(a.left, b.left, tight);
  EXPECT_NEAR(a.turn, b.turn, tight);
}

TEST(Odometry, WheelsAndTwistsGoBothWays) {
  Random random{2};
  for (int i = 0; i < 2000; ++i) {
    const double v = random.uniform(-2, 2), turn = random.uniform(-2, 2);
    const Differential differential{random.uniform(0.2, 1.5)};
    const DifferentialWheels two = wheels_of(differential, v, turn);
    expect_same(twist_of(differential, two), {v, 0.0, turn});
    EXPECT_NEAR(two.right - two.left, differential.track * turn, tight);

    for (const SteeredAxle axle : {SteeredAxle::rear, SteeredAxle::front}) {
      const Tricycle tricycle{random.uniform(0.5, 2.5), 1.2, {}, axle};
      const SteeredWheel wheel = wheel_of(tricycle, v, turn, 0.0);
      expect_same(twist_of(tricycle, wheel), {v, 0.0, turn});
      EXPECT_LE(std::abs(wheel.angle), 0.5 * pi);
      // The angle is what the vehicle itself says of this curvature.
      Vehicle vehicle;
      vehicle.drive = tricycle;
      EXPECT_NEAR(wheel.angle, vehicle.steering_angle(turn / v), tight);
      // And back: any wheel, this side of across.
      const SteeredWheel any{random.uniform(-1.5, 1.5), random.uniform(0.1, 2.0) * (i % 2 == 0 ? 1.0 : -1.0)};
      const Twist twist = twist_of(tricycle, any);
      const SteeredWheel again = wheel_of(tricycle, twist.forward, twist.turn, 0.0);
      EXPECT_NEAR(again.angle, any.angle, tight);
      EXPECT_NEAR(again.speed, any.speed, tight);
    }

    const Mecanum mecanum{random.uniform(0.03, 0.2), random.uniform(0.1, 0.6), random.uniform(0.1, 0.6)};
    const Twist free{v, random.uniform(-2, 2), turn};
    const MecanumWheels four = wheels_of(mecanum, free);
    expect_same(twist_of(mecanum, four), free);
    EXPECT_NEAR(slip_residual(four), 0.0, 1e-10);
  }
}

TEST(Odometry, AStandingSteeredWheelKeepsItsAngle) {
  const SteeredWheel wheel = wheel_of(Tricycle{1.4, 1.2, {}}, 0.0, 0.0, 0.37);
  EXPECT_EQ(wheel.angle, 0.37);
  EXPECT_EQ(wheel.speed, 0.0);
}

TEST(Odometry, TheMecanumVectorOfTheSpecification) {
  const Mecanum youbot{0.0475, 0.235, 0.15};
  const MecanumWheels w = wheels_of(youbot, {0.4, 0.1, 0.5});
  EXPECT_NEAR(w.front_left, 2.26316, 5e-6);
  EXPECT_NEAR(w.front_right, 14.57895, 5e-6);
  EXPECT_NEAR(w.rear_left, 6.47368, 5e-6);
  EXPECT_NEAR(w.rear_right, 10.36842, 5e-6);
  expect_same(twist_of(youbot, w), {0.4, 0.1, 0.5});
  // Wheels that slip say so.
  EXPECT_NEAR(slip_residual({1.0, 1.0, 0.5, 0.5}), 1.0, tight);
}

}  // namespace
}  // namespace waywright
