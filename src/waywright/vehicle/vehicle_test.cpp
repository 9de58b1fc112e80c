#include "waywright/vehicle/vehicle.hpp"

#include <gtest/gtest.h>

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
