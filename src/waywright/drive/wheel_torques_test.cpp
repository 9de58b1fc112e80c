#include "waywright/drive/wheel_torques.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/drive/test_plans.hpp"

namespace waywright {
namespace {

using drive_test::mecanum_plan;
using drive_test::sideways_plan;

Plan with_mass(Plan plan) {
  plan.scenario.vehicle.mass = 30.0;
  return plan;
}
WheelMotors motors(double rolling_arm = 0.0) { return {.inertia = 1.1, .wheel_inertia = 2e-4, .rolling_arm = rolling_arm}; }

double greatest(const MecanumTorques& t) { return std::max({std::abs(t.front_left), std::abs(t.front_right), std::abs(t.rear_left), std::abs(t.rear_right)}); }

// Work of the motors = change of kinetic energy + what rolling takes, along whole plans, with and without a load, from rest and from motion.
TEST(WheelTorques, EnergyIsKeptAlongAPlan) {
  for (const Plan& given : {mecanum_plan(), sideways_plan()}) {
    for (const double arm : {0.0, 0.002}) {
      for (const bool is_loaded : {false, true}) {
        for (const bool moves : {false, true}) {
          Plan plan = with_mass(given);
          if (is_loaded) {
            plan.scenario.vehicle.loads["box"] = {{rectangle({0.0, -0.2}, {0.3, 0.2}), 0.0}, 12.0};
            plan.scenario.carried_load = "box";
          }
          if (moves) assign_speed(plan.samples, plan.scenario.vehicle, 0.3);
          for (const double period : {0.01, 0.1}) {
            const WheelTorques t = wheel_torques(plan, exact_controls(plan, period), motors(arm));
            EXPECT_NEAR(t.work, t.kinetic_change + t.rolling_losses, 1e-6);
            if (!moves) {
              EXPECT_NEAR(t.kinetic_change, 0.0, 1e-9) << "it ends as it began, at rest";
            } else {
              EXPECT_LT(t.kinetic_change, -0.5);
            }
            EXPECT_EQ(t.rolling_losses > 0.0, arm > 0.0);
          }
        }
      }
    }
  }
}

// Motors that give these torques drive a base, simulated by its equations of motion, as the commands say.
TEST(WheelTorques, TheEquationsOfMotionFollowThem) {
  for (const Plan& given : {mecanum_plan(), sideways_plan()}) {
    const Plan plan = with_mass(given);
    const Vehicle& vehicle = plan.scenario.vehicle;
    const Mecanum& drive = std::get<Mecanum>(vehicle.drive);
    const MecanumDynamics dynamics{drive, {vehicle.mass, motors().inertia, motors().wheel_inertia, 0.0}};
    constexpr double period = 0.01;
    const ExactControls controls = exact_controls(plan, period);
    const WheelTorques torques = wheel_torques(plan, controls, motors());
    Twist at{};
    double worst = 0.0;
    for (std::size_t i = 0; i + 1 < controls.rows.size(); ++i) {
      const Twist begin = at;
      constexpr int steps = 10;
      for (int k = 0; k < steps; ++k) {
        constexpr double h = period / steps;
        const auto moved = [&](const Twist& rate, double time) { return Twist{at.forward + time * rate.forward, at.left + time * rate.left, at.turn + time * rate.turn}; };
        const Twist first = dynamics.acceleration(at, torques.rows[i]);
        const Twist middle = dynamics.acceleration(moved(first, 0.5 * h), torques.rows[i]);
        at = moved(middle, h);
      }
      const Twist& wanted = controls.rows[i].twist;
      worst = std::max({worst, std::abs(0.5 * (begin.forward + at.forward) - wanted.forward), std::abs(0.5 * (begin.left + at.left) - wanted.left), std::abs(0.5 * (begin.turn + at.turn) - wanted.turn)});
    }
    EXPECT_LT(worst, 0.02);
    EXPECT_NEAR(at.forward, 0.0, 1e-3);
    EXPECT_NEAR(at.left, 0.0, 1e-3);
    EXPECT_NEAR(at.turn, 0.0, 1e-3);
  }
}

TEST(WheelTorques, ALoadTakesMore) {
  Plan plan = with_mass(mecanum_plan());
  const double empty = wheel_torques(plan, exact_controls(plan, 0.02), motors(0.002)).greatest_torque;
  plan.scenario.vehicle.loads["box"] = {{rectangle({0.0, -0.2}, {0.3, 0.2}), 0.0}, 30.0};
  plan.scenario.carried_load = "box";
  const double full = wheel_torques(plan, exact_controls(plan, 0.02), motors(0.002)).greatest_torque;
  EXPECT_GT(full, 1.5 * empty);
  // Of a mission in legs that of each leg counts: the load is left after the first.
  LegResult first, second;
  first.load = "box";
  first.samples = plan.samples.size() / 2;
  second.samples = plan.samples.size() - first.samples;
  plan.legs = {first, second};
  const WheelTorques legs = wheel_torques(plan, exact_controls(plan, 0.02), motors(0.002));
  EXPECT_GT(legs.rolling_losses, wheel_torques(with_mass(mecanum_plan()), exact_controls(plan, 0.02), motors(0.002)).rolling_losses);
  EXPECT_NEAR(legs.work, legs.kinetic_change + legs.rolling_losses, 1e-6);
}

// Where a motor cannot the plan is driven as much slower as serves, on the same way.
TEST(WheelTorques, WeakMotorsAreDrivenSlower) {
  for (const Plan& given : {mecanum_plan(), sideways_plan()}) {
    const Plan plan = with_mass(given);
    constexpr double period = 0.02;
    const auto taken = [&](double factor, const WheelMotors& m) {
      const Plan slow = slowed(plan, factor);
      return wheel_torques(slow, exact_controls(slow, period), m);
    };
    const WheelTorques fast = taken(1.0, motors(0.001));
    EXPECT_EQ(slowing_within(plan, period, motors(0.001)), 1.0);
    for (const bool by_torque : {true, false}) {
      double before = 1.0;
      for (const double share : {0.8, 0.5, 0.35}) {
        WheelMotors weak = motors(0.001);
        (by_torque ? weak.most_torque : weak.most_speed) = share * (by_torque ? fast.greatest_torque : fast.greatest_speed);
        const auto factor = slowing_within(plan, period, weak);
        ASSERT_TRUE(factor) << share;
        EXPECT_GT(*factor, before);
        before = *factor;
        const Plan slow = slowed(plan, *factor);
        const ExactControls controls = exact_controls(slow, period);
        const WheelTorques torques = wheel_torques(slow, controls, weak);
        for (const MecanumTorques& each : torques.rows) {
          EXPECT_TRUE(!by_torque || greatest(each) <= weak.most_torque);
        }
        EXPECT_TRUE(by_torque || torques.greatest_speed <= weak.most_speed);
        EXPECT_LT(controls.end.position, 1e-2);
        const WheelTorques less = taken(1.0 + 0.9 * (*factor - 1.0), weak);
        EXPECT_TRUE(by_torque ? less.greatest_torque > weak.most_torque : less.greatest_speed > weak.most_speed) << "slower than it has to be";
      }
    }
    WheelMotors weak = motors(0.001);
    weak.most_torque = 1e-3;  // less than rolling takes
    EXPECT_FALSE(slowing_within(plan, period, weak));
  }
}

}  // namespace
}  // namespace waywright
