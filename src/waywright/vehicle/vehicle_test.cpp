#include "waywright/vehicle/vehicle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace waywright {
namespace {

Footprint forklift() { return {.polygon = rectangle({-2.3, -0.45}, {0.4, 0.45}), .disc = 0.0}; }

Vehicle tricycle(SteeredAxle axle) {
  Vehicle vehicle;
  vehicle.footprint = forklift();
  vehicle.drive =
      Tricycle{.wheelbase = 1.9, .max_steering = pi / 3, .max_steering_rate = {}, .steered_axle = axle};
  return vehicle;
}

TEST(Footprint, MeasuresOfAPolygon) {
  const Footprint footprint = forklift();
  EXPECT_FALSE(footprint.is_disc());
  EXPECT_DOUBLE_EQ(footprint.radius(), std::hypot(2.3, 0.45));
  EXPECT_EQ(footprint.front(), 0.4);
  EXPECT_DOUBLE_EQ(footprint.least_width(), 0.9);
}

TEST(Footprint, OriginMayLieOutside) {
  const Footprint behind{.polygon = rectangle({-3, -0.5}, {-1, 0.5}), .disc = 0.0};
  EXPECT_EQ(behind.front(), -1.0);
  EXPECT_DOUBLE_EQ(behind.radius(), std::hypot(3.0, 0.5));
}

TEST(Footprint, MeasuresOfADisc) {
  const Footprint disc{.polygon = {}, .disc = 0.35};
  EXPECT_TRUE(disc.is_disc());
  EXPECT_EQ(disc.radius(), 0.35);
  EXPECT_EQ(disc.front(), 0.35);
  EXPECT_EQ(disc.least_width(), 0.7);
  EXPECT_EQ((Footprint{}.radius()), 0.0);  // a point
}

TEST(Vehicle, CurvatureLimitIsTheSmaller) {
  Vehicle vehicle = tricycle(SteeredAxle::rear);
  EXPECT_NEAR(vehicle.max_curvature(), std::sqrt(3.0) / 1.9, 1e-12);  // 0.91 1/m
  vehicle.limits.curvature = 0.8;
  EXPECT_EQ(vehicle.max_curvature(), 0.8);
  vehicle.limits.curvature = 2.0;
  EXPECT_NEAR(vehicle.max_curvature(), std::sqrt(3.0) / 1.9, 1e-12);
  vehicle.drive = Differential{0.5};
  EXPECT_EQ(vehicle.max_curvature(), 2.0);
  vehicle.limits.curvature = {};
  EXPECT_TRUE(std::isinf(vehicle.max_curvature()));
}

TEST(Vehicle, TurningOnTheSpot) {
  EXPECT_FALSE(tricycle(SteeredAxle::rear).can_turn_on_the_spot());
  Vehicle vehicle;
  EXPECT_TRUE(vehicle.can_turn_on_the_spot());
  vehicle.drive = Mecanum{0.1, 0.3, 0.3};
  EXPECT_TRUE(vehicle.can_turn_on_the_spot());
}

// No closed form needed: all wheels, all angles between.
TEST(Vehicle, WheelsOfAMecanumBaseBoundItsSpeed) {
  Mecanum drive{0.05, 0.3, 0.2};
  EXPECT_TRUE(std::isinf(drive.max_speed(0.3, 0.1, 2.0)));
  drive.max_wheel_speed = 12.0;
  for (const double off : {-3.1, -2.2, -0.8, -0.1, 0.0, 0.7, 0.78539, 1.5, 2.4, 3.0}) {
    for (const double change : {-1.7, -0.05, 0.0, 0.02, 0.9}) {
      for (const double turning : {-1.5, 0.0, 0.4}) {
        double fastest = 0.0;  // rad/s of a wheel at 1 m/s
        constexpr int steps = 2000;
        for (int i = 0; i <= steps; ++i) {
          const double angle = off + change * i / steps, x = std::cos(angle), y = std::sin(angle);
          for (const double side : {y, -y}) {
            for (const double arm : {0.5, -0.5}) fastest = std::max(fastest, std::abs(x + side + arm * turning) / 0.05);
          }
        }
        EXPECT_NEAR(drive.max_speed(off, change, turning) * fastest, 12.0, 1e-4) << off << " " << change << " " << turning;
      }
    }
  }
  Vehicle vehicle;
  EXPECT_FALSE(vehicle.max_turning_speed());
  vehicle.drive = drive;
  EXPECT_NEAR(*vehicle.max_turning_speed(), 12.0 * 0.05 / 0.5, 1e-12);
  vehicle.limits.angular_speed = 0.7;
  EXPECT_EQ(*vehicle.max_turning_speed(), 0.7);
  vehicle.limits.angular_speed = 5.0;
  EXPECT_NEAR(*vehicle.max_turning_speed(), 1.2, 1e-12);
}

// The wheel's axle points at the centre of the turn, (0, 1/κ) in the body frame.
TEST(Vehicle, SteeredAxlePointsAtTheCentreOfTheTurn) {
  for (const SteeredAxle axle : {SteeredAxle::rear, SteeredAxle::front}) {
    const Vehicle vehicle = tricycle(axle);
    const Vec2 wheel{axle == SteeredAxle::rear ? -1.9 : 1.9, 0};
    EXPECT_EQ(vehicle.steering_angle(0.0), 0.0);
    for (const double curvature : {-0.8, -0.1, 0.05, 0.5, 0.9}) {
      const double angle = vehicle.steering_angle(curvature);
      EXPECT_LT(std::abs(angle), pi / 2);
      EXPECT_NEAR(dot(unit(angle), Vec2{0, 1 / curvature} - wheel), 0.0, 1e-12);
      EXPECT_EQ(angle > 0, (axle == SteeredAxle::front) == (curvature > 0));
    }
    EXPECT_NEAR(std::abs(vehicle.steering_angle(vehicle.max_curvature())), pi / 3, 1e-12);
  }
  EXPECT_EQ(Vehicle{}.steering_angle(0.5), 0.0);
}

}  // namespace
}  // namespace waywright
