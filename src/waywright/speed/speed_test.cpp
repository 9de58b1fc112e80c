#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "waywright/speed/speed.hpp"
#include "waywright/speed/test_paths.hpp"

namespace waywright {
namespace {

using namespace speed_test;

TEST(Speed, TrapezoidInClosedForm) {
  auto samples = line(10.0, 200);
  const double time = assign_speed(samples, differential());
  EXPECT_NEAR(time, 10.0 / 1.0 + 1.0 / (2 * 0.5) + 1.0 / (2 * 0.5), 1e-9);  // L/v + v/2a + v/2d
  EXPECT_DOUBLE_EQ(samples.back().t, time);
  EXPECT_NEAR(samples[100].speed, 1.0, 1e-12);
  EXPECT_NEAR(samples[5].speed, std::sqrt(2 * 0.5 * samples[5].s), 1e-12);
  EXPECT_NEAR(samples[5].t, samples[5].speed / 0.5, 1e-9);
  EXPECT_EQ(broken_limit(samples, differential()), "");
}

TEST(Speed, TriangleInClosedForm) {
  Vehicle vehicle = differential();
  vehicle.limits.acceleration = 0.25;
  vehicle.limits.deceleration = 1.0;
  vehicle.limits.speed = 10.0;
  const double length = 3.0;
  const double exact = std::sqrt(2.0 * length * (1.0 / 0.25 + 1.0 / 1.0));
  auto samples = line(length, 60);
  EXPECT_NEAR(assign_speed(samples, vehicle), exact, 0.01 * exact);
  samples = line(length, 6000);
  EXPECT_NEAR(assign_speed(samples, vehicle), exact, 1e-4 * exact);
  const auto peak = std::max_element(samples.begin(), samples.end(),
                                     [](const Sample& a, const Sample& b) { return a.speed < b.speed; });
  EXPECT_NEAR(peak->s, length * 1.0 / (0.25 + 1.0), 1e-3);  // where the ramps meet: L·d/(a+d)
}

TEST(Speed, BackwardsHasItsOwnLimit) {
  auto samples = line(10.0, 200, -1);
  EXPECT_NEAR(assign_speed(samples, differential()), 10.0 / 0.5 + 0.5 / 0.5, 1e-9);
  EXPECT_DOUBLE_EQ(samples[100].speed, 0.5);
}

TEST(Speed, OneStepFromRestToRest) {
  Vehicle vehicle = differential();
  auto samples = line(0.05, 1);
  EXPECT_NEAR(assign_speed(samples, vehicle), std::sqrt(2 * 0.05 * (2 + 2)), 1e-12);
  samples = line(30.0, 1);
  EXPECT_NEAR(assign_speed(samples, vehicle), 30.0 + 2.0, 1e-12);
}

TEST(Speed, CircleKeepsLateralAndAngularLimits) {
  Vehicle vehicle = differential();
  vehicle.limits.lateral_acceleration = 0.08;
  auto samples = circle(10.0, 400, -0.5);
  assign_speed(samples, vehicle);
  EXPECT_NEAR(samples[200].speed, std::sqrt(0.08 / 0.5), 1e-12);
  vehicle.limits.angular_speed = 0.1;
  assign_speed(samples, vehicle);
  EXPECT_NEAR(samples[200].speed, 0.1 / 0.5, 1e-12);
  // On a circle the angular acceleration is κ·a.
  vehicle.limits.angular_acceleration = 0.05;
  assign_speed(samples, vehicle);
  EXPECT_EQ(broken_limit(samples, vehicle), "");
  EXPECT_NEAR(samples[4].speed, std::min(0.2, std::sqrt(2 * 0.1 * samples[4].s)), 1e-9);
}

TEST(Speed, ClothoidKeepsTheSteeringRate) {
  const Vehicle vehicle = tricycle(0.3);
  auto samples = stretch(
      6.0, 600, [](double s) { return 0.1 * s; }, [](double) { return 0.1; });
  assign_speed(samples, vehicle);
  EXPECT_EQ(broken_limit(samples, vehicle), "");
  const double l = 1.9;
  const double bound = 0.3 * (1.0 + l * l * 0.3 * 0.3) / (l * 0.1);
  ASSERT_GT(bound, 1.0);  // no limit for this one; five times tighter it is
  const Vehicle slow = tricycle(0.06);
  assign_speed(samples, slow);
  EXPECT_EQ(broken_limit(samples, slow), "");
  EXPECT_NEAR(samples[300].speed, 0.06 * (1.0 + l * l * 0.09) / (l * 0.1), 2e-3);
}

TEST(Speed, ClothoidKeepsTheAngularAcceleration) {
  Vehicle vehicle = differential();
  vehicle.limits.angular_acceleration = 0.01;
  vehicle.limits.acceleration = vehicle.limits.deceleration = 5.0;
  // κ·a + κ′·v² = α from rest: κ = cs gives d(s·w)/ds + s·w′… = 2(α/c − w) − s·w′ = 0, so w = α/c is reached
  // from any start.
  auto samples = stretch(
      8.0, 1600, [](double s) { return 0.05 * s; }, [](double) { return 0.05; });
  assign_speed(samples, vehicle);
  EXPECT_EQ(broken_limit(samples, vehicle), "");
  EXPECT_NEAR(samples[600].speed * samples[600].speed, 0.01 / 0.05, 0.01);
}

TEST(Speed, SameTimeBothWays) {
  Vehicle vehicle = tricycle(0.2);
  vehicle.limits.lateral_acceleration = 0.1;
  vehicle.limits.angular_acceleration = 0.1;
  const auto curvature = [](double s) { return 0.5 * std::sin(s) * s / 7.0; };
  const auto rate = [](double s) { return 0.5 * (std::cos(s) * s + std::sin(s)) / 7.0; };
  auto there = stretch(7.0, 350, curvature, rate);
  auto back = stretch(
      7.0, 350, [&](double s) { return curvature(7.0 - s); }, [&](double s) { return -rate(7.0 - s); });
  const double time = assign_speed(there, vehicle);
  EXPECT_NEAR(assign_speed(back, vehicle), time, 1e-3 * time);
  EXPECT_EQ(broken_limit(there, vehicle), "");
  EXPECT_EQ(broken_limit(back, vehicle), "");
}

TEST(Speed, StopsAtChangesOfDirection) {
  auto samples = line(4.0, 80);
  append(samples, line(4.0, 80, -1));
  const Vehicle vehicle = differential();
  auto first = line(4.0, 80);
  auto second = line(4.0, 80, -1);
  const double apart = assign_speed(first, vehicle) + assign_speed(second, vehicle);
  EXPECT_NEAR(assign_speed(samples, vehicle), apart, 1e-9);
  EXPECT_EQ(samples[80].speed, 0.0);
  EXPECT_EQ(samples[81].speed, 0.0);
  EXPECT_EQ(samples[80].t, samples[81].t);
}

TEST(Speed, CurvatureJumpStopsWhatCannotFollowIt) {
  auto samples = line(4.0, 80);
  append(samples, circle(4.0, 80, 0.3));
  ASSERT_TRUE(is_curvature_jump(samples[80], samples[81]));
  ASSERT_FALSE(is_curvature_jump(samples[79], samples[80]));
  assign_speed(samples, differential());  // two driven wheels without a limit on turning
  EXPECT_GT(samples[80].speed, 0.9);
  EXPECT_EQ(samples[80].speed, samples[81].speed);
  EXPECT_EQ(samples[80].t, samples[81].t);

  const Vehicle steered = tricycle(0.5);
  assign_speed(samples, steered);
  EXPECT_EQ(samples[80].speed, 0.0);
  EXPECT_EQ(samples[81].speed, 0.0);
  EXPECT_NEAR(samples[81].t - samples[80].t, std::atan(1.9 * 0.3) / 0.5, 1e-9);  // the wheel turns meanwhile
  EXPECT_EQ(broken_limit(samples, steered), "");

  Vehicle smooth = differential();
  smooth.limits.curvature_rate = 1.0;
  assign_speed(samples, smooth);
  EXPECT_EQ(samples[80].speed, 0.0);
  Vehicle inert = differential();
  inert.limits.angular_acceleration = 1.0;
  assign_speed(samples, inert);
  EXPECT_EQ(samples[80].speed, 0.0);
}

TEST(Speed, TheWheelStaysWhereTheArcIsDrivenBack) {
  // The same circle there and back: travel bends the other way, the wheel does not move.
  auto samples = circle(2.0, 40, 0.3);
  append(samples, stretch(
                      2.0, 40, [](double) { return -0.3; }, [](double) { return 0.0; }, -1));
  assign_speed(samples, tricycle(0.5));
  EXPECT_EQ(samples[41].t, samples[40].t);
}

TEST(Speed, TurningOnTheSpot) {
  Vehicle vehicle = differential();
  auto samples = turn(pi / 2, 40);  // no limits given: 1 rad/s and 1 rad/s²
  EXPECT_NEAR(assign_speed(samples, vehicle), pi / 2 + 1.0, 1e-12);
  EXPECT_NEAR(samples[20].t, 0.5 * (pi / 2 + 1.0), 1e-12);
  vehicle.limits.angular_acceleration = 0.5;
  vehicle.limits.angular_speed = 5.0;
  samples = turn(-2.0, 50);
  EXPECT_NEAR(assign_speed(samples, vehicle), 2.0 * std::sqrt(2.0 / 0.5), 1e-12);
  for (std::size_t i = 0; i < 25; ++i) {
    EXPECT_NEAR(samples[i].t, std::sqrt(2.0 * 2.0 * static_cast<double>(i) / 50.0 / 0.5), 1e-9);
    EXPECT_NEAR(samples[50 - i].t, samples.back().t - samples[i].t, 1e-9);
  }
  for (const Sample& s : samples) EXPECT_EQ(s.speed, 0.0);
}

TEST(Speed, TurnsOfOppositeSenseStopBetween) {
  const Vehicle vehicle = differential();
  auto samples = turn(1.5, 30);
  append(samples, turn(-1.5, 30));
  EXPECT_NEAR(assign_speed(samples, vehicle), 2 * 2.5, 1e-9);
  samples = turn(1.5, 30);
  append(samples, turn(1.5, 30));
  EXPECT_NEAR(assign_speed(samples, vehicle), 4.0, 1e-9);  // one turn of 3 rad
  samples = turn(5.0, 100);                                // beyond half a circle
  EXPECT_NEAR(assign_speed(samples, vehicle), 6.0, 1e-9);
}

TEST(Speed, DriveTurnDrive) {
  const Vehicle vehicle = differential();
  auto samples = line(4.0, 80);
  append(samples, turn(1.0, 20));
  append(samples, line(4.0, 80));
  EXPECT_NEAR(assign_speed(samples, vehicle), 6.0 + 2.0 + 6.0, 1e-9);
  EXPECT_EQ(broken_limit(samples, vehicle), "");
}

TEST(Speed, OutsidePosesThatTurnOnTheSpotTakeTheirTime) {
  auto samples = line(4.0, 80);
  auto second = line(4.0, 80);
  for (Sample& s : second) s.heading = 1.0;
  append(samples, second);  // the heading jumps by 1 rad at one place, direction kept
  EXPECT_NEAR(assign_speed(samples, differential()), 6.0 + 2.0 + 6.0, 1e-9);
}

TEST(Speed, DegenerateInputIsFinite) {
  const Vehicle vehicle = tricycle(0.3);
  std::vector<Sample> none;
  EXPECT_EQ(assign_speed(none, vehicle), 0.0);
  auto samples = line(0.0, 3);
  EXPECT_EQ(assign_speed(samples, vehicle), 0.0);
  samples = line(5.0, 100);
  samples.insert(samples.begin() + 50, 3, samples[50]);  // one place four times
  EXPECT_NEAR(assign_speed(samples, vehicle), 7.0, 1e-9);
  EXPECT_EQ(broken_limit(samples, vehicle), "");
  // Cusps: endless curvature, endless rates, and no numbers at all.
  for (const double bad :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e300, 1e12}) {
    samples = line(5.0, 100);
    samples[40].curvature = bad;
    samples[60].curvature_rate = bad;
    samples[61].curvature_rate = bad;
    Vehicle all = vehicle;
    all.limits.lateral_acceleration = all.limits.angular_speed = all.limits.angular_acceleration = 0.4;
    const double time = assign_speed(samples, all);
    EXPECT_TRUE(std::isfinite(time)) << bad;
    EXPECT_GT(time, 7.0);
    for (std::size_t i = 1; i < samples.size(); ++i) EXPECT_GE(samples[i].t, samples[i - 1].t);
  }
}

}  // namespace
}  // namespace waywright
