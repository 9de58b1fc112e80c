// Speed of a vehicle that need not face along: corners, turning while driving.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/speed/speed.hpp"

namespace waywright {
namespace {

Vehicle base() {
  Vehicle v;
  v.drive = Mecanum{0.05, 0.2, 0.2};
  v.limits.speed = 1.0;
  v.limits.acceleration = v.limits.deceleration = 0.5;
  return v;
}

std::vector<Sample> profiled(const Path& path, const Vehicle& vehicle) {
  std::vector<Sample> samples = sample(path, 0.5, 5e-4);
  assign_speed(samples, vehicle);
  return samples;
}

double trapezoid(double length) { return length / 1.0 + 1.0 / 0.5; }  // from rest to rest at 1 m/s and 0.5 m/s²; s

TEST(SpeedOfSliding, StandsAtACornerAndWaitsForNothingElse) {
  Path path;
  path.pieces.push_back({Line{{0, 0}, {4, 0}}, 1, HeadingAlong{0.3, 0.0}});
  path.pieces.push_back({Line{{4, 0}, {4, 5}}, 1, HeadingAlong{0.3, 0.0}});
  const auto samples = profiled(path, base());
  EXPECT_NEAR(samples.back().t, trapezoid(4.0) + trapezoid(5.0), 1e-9);
  for (const Sample& s : samples) {
    if (s.s == 4.0) {
      EXPECT_EQ(s.speed, 0.0);
    }
  }
}

TEST(SpeedOfSliding, AnArcThatTouchesNeedsNoStand) {
  Vehicle vehicle = base();
  vehicle.limits.lateral_acceleration = 1.0;  // 1 m/s on a radius of 1 m is just allowed
  vehicle.limits.angular_speed = 0.1;         // of the heading, which does not turn
  vehicle.limits.angular_acceleration = 0.1;
  Path path;
  path.pieces.push_back({Line{{0, 0}, {4, 0}}, 1, HeadingAlong{0.3, 0.0}});
  path.pieces.push_back({Arc{{4, 0, 0}, 1.0, 0.5 * pi}, 1, HeadingAlong{0.3, 0.0}});
  path.pieces.push_back({Line{{5, 1}, {5, 5}}, 1, HeadingAlong{0.3, 0.0}});
  EXPECT_NEAR(profiled(path, vehicle).back().t, trapezoid(8.0 + 0.5 * pi), 1e-6);
}

TEST(SpeedOfSliding, TurningWhileDrivingKeepsTheAngularLimits) {
  Vehicle vehicle = base();
  vehicle.limits.angular_speed = 0.2;
  Path path;
  path.pieces.push_back({Line{{0, 0}, {10, 0}}, 1, HeadingAlong{0.0, 4.0}});  // 0.4 rad/m: 0.5 m/s at most
  const auto samples = profiled(path, vehicle);
  for (const Sample& s : samples) EXPECT_LE(s.speed, 0.5 + 1e-9);
  EXPECT_NEAR(samples.back().t, 10.0 / 0.5 + 0.5 / 0.5, 1e-6);
  vehicle.limits.angular_acceleration = 0.1;  // 0.4·a ≤ 0.1: a ≤ 0.25 m/s²
  EXPECT_NEAR(profiled(path, vehicle).back().t, 10.0 / 0.5 + 0.5 / 0.25, 1e-6);
}

TEST(SpeedOfSliding, WhatLeadsBackwardsKeepsItsOwnLimit) {
  Vehicle vehicle = base();
  vehicle.limits.reverse_speed = 0.25;
  for (const double off : {pi, pi - 1.0, 1.0}) {  // from the course to the heading
    Path path;
    path.pieces.push_back({Line{{0, 0}, {6, 0}}, 1, HeadingAlong{off, 0.0}});
    double fastest = 0.0;
    for (const Sample& s : profiled(path, vehicle)) fastest = std::max(fastest, s.speed);
    EXPECT_NEAR(fastest, off > 0.5 * pi ? std::min(1.0, 0.25 / -std::cos(off)) : 1.0, 1e-9) << off;
  }
}

TEST(SpeedOfSliding, StandsWhereTheTurningJumpsOnlyIfThatTakesTime) {
  Path path;
  path.pieces.push_back({Line{{0, 0}, {4, 0}}, 1, HeadingAlong{0.0, 0.0}});
  path.pieces.push_back({Line{{4, 0}, {8, 0}}, 1, HeadingAlong{0.0, 1.0}});
  EXPECT_NEAR(profiled(path, base()).back().t, trapezoid(8.0), 1e-9);
  Vehicle vehicle = base();
  vehicle.limits.angular_acceleration = 10.0;
  EXPECT_NEAR(profiled(path, vehicle).back().t, 2.0 * trapezoid(4.0), 1e-6);
}

}  // namespace
}  // namespace waywright
