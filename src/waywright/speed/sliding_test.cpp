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

/// rad/s of the fastest wheel at the samples and between them, as positions go there.
double fastest_wheel(const std::vector<Sample>& samples, const Mecanum& drive) {
  double fastest = 0.0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const Sample &a = samples[i], &b = samples[i + 1];
    if (!(b.s > a.s)) continue;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double v = std::sqrt(a.speed * a.speed + share * (b.speed * b.speed - a.speed * a.speed));
      const double off = (1.0 - share) * (a.course - a.heading) + share * (a.course - a.heading + shorter_turn(a.course - a.heading, b.course - b.heading));
      const double x = v * std::cos(off), y = v * std::sin(off), turn = v * std::max(std::abs(a.turning()), std::abs(b.turning()));
      for (const double side : {y, -y}) {
        for (const double arm : {drive.half_length + drive.half_width, -drive.half_length - drive.half_width}) fastest = std::max(fastest, std::abs(x + side + arm * turn) / drive.wheel_radius);
      }
    }
  }
  return fastest;
}

TEST(SpeedOfSliding, NoWheelIsFasterThanItMay) {
  Vehicle vehicle = base();
  Path path;
  path.pieces.push_back({Line{{0, 0}, {6, 0}}, 1, HeadingAlong{0.0, 4.0}});                // turns while it drives
  path.pieces.push_back({Arc{{6, 0, 0}, 0.5, 3.0}, 1, HeadingAlong{4.0, -2.0}});
  path.pieces.push_back({Line{end_pose(Piece{Arc{{6, 0, 0}, 0.5, 3.0}, 1, {}}).position(), {12, 8}}, 1, HeadingAlong{2.0, 0.0}});
  const double free = fastest_wheel(profiled(path, vehicle), std::get<Mecanum>(vehicle.drive));
  ASSERT_GT(free, 25.0);
  for (const double most : {20.0, 8.0, 1.0}) {
    std::get<Mecanum>(vehicle.drive).max_wheel_speed = most;
    const double fastest = fastest_wheel(profiled(path, vehicle), std::get<Mecanum>(vehicle.drive));
    EXPECT_LE(fastest, most * (1.0 + 1e-12));
    EXPECT_GE(fastest, most * 0.999) << "as fast as it may";
  }
  // Straight ahead 10 rad/s are 0.5 m/s, askew 1/√2 of that.
  std::get<Mecanum>(vehicle.drive).max_wheel_speed = 10.0;
  for (const double off : {0.0, 0.25 * pi, 0.5 * pi}) {
    Path straight;
    straight.pieces.push_back({Line{{0, 0}, {6, 0}}, 1, HeadingAlong{off, 0.0}});
    double fastest = 0.0;
    for (const Sample& sample : profiled(straight, vehicle)) fastest = std::max(fastest, sample.speed);
    EXPECT_NEAR(fastest, off == 0.25 * pi ? 0.5 / std::sqrt(2.0) : 0.5, 1e-9) << off;
  }
  std::get<Mecanum>(vehicle.drive).max_wheel_speed = 2.0;  // on the spot 2 · 0.05/0.4 rad/s
  vehicle.limits.angular_acceleration = 1e6;
  Path turn;
  turn.pieces.push_back({Turn{{0, 0}, 0.0, 2.0}, 0});
  EXPECT_NEAR(profiled(turn, vehicle).back().t, 2.0 / 0.25, 1e-4);
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
