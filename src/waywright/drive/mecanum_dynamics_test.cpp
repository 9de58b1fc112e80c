#include "waywright/drive/mecanum_dynamics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

const Mecanum youbot{0.0475, 0.235, 0.15};
const MecanumBody frictionless{30.0, 1.1, 2e-4, 0.0};

Twist random_twist(Random& random) { return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-2, 2)}; }
MecanumTorques random_torques(Random& random) { return {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)}; }

// The vector that is printed with the publication's matrices, and the identity there and back.
TEST(MecanumKinematics, WheelsOfATwistAndBack) {
  const MecanumWheels w = wheels_of(youbot, {0.4, 0.1, 0.5});
  EXPECT_NEAR(w.front_left, 2.26316, 5e-6);
  EXPECT_NEAR(w.front_right, 14.57895, 5e-6);
  EXPECT_NEAR(w.rear_left, 6.47368, 5e-6);
  EXPECT_NEAR(w.rear_right, 10.36842, 5e-6);
  Random random{1};
  for (int i = 0; i < 10'000; ++i) {
    const Twist twist = random_twist(random), back = twist_of(youbot, wheels_of(youbot, twist));
    EXPECT_NEAR(back.forward, twist.forward, 1e-12);
    EXPECT_NEAR(back.left, twist.left, 1e-12);
    EXPECT_NEAR(back.turn, twist.turn, 1e-12);
    EXPECT_NEAR(slip_residual(wheels_of(youbot, twist)), 0.0, 1e-12);
  }
}

// The publication's own axes: x to the right, y forward; wheels front right, front left, rear left, rear right, positive driving backwards.
TEST(MecanumKinematics, AreThoseOfThePublicationInItsOwnAxes) {
  Random random{2};
  const double r = youbot.wheel_radius, l = youbot.half_length + youbot.half_width;
  for (int i = 0; i < 1000; ++i) {
    const Twist t = random_twist(random);
    const double x = -t.left, y = t.forward, turn = t.turn;
    const double one = -(-x + y + l * turn) / r, two = -(x + y - l * turn) / r, three = -(-x + y - l * turn) / r, four = -(x + y + l * turn) / r;
    const MecanumWheels w = wheels_of(youbot, t);
    EXPECT_NEAR(w.front_right, -one, 1e-12);
    EXPECT_NEAR(w.front_left, -two, 1e-12);
    EXPECT_NEAR(w.rear_left, -three, 1e-12);
    EXPECT_NEAR(w.rear_right, -four, 1e-12);
  }
}

TEST(MecanumDynamics, TorquesAndAccelerationAreInverse) {
  Random random{3};
  for (const double arm : {0.0, 0.002}) {
    MecanumBody body = frictionless;
    body.rolling_arm = arm;
    const MecanumDynamics dynamics{youbot, body};
    for (int i = 0; i < 1000; ++i) {
      const Twist twist = random_twist(random), wanted = random_twist(random), found = dynamics.acceleration(twist, dynamics.torques(twist, wanted));
      EXPECT_NEAR(found.forward, wanted.forward, 1e-12);
      EXPECT_NEAR(found.left, wanted.left, 1e-12);
      EXPECT_NEAR(found.turn, wanted.turn, 1e-12);
    }
  }
}

// d/dt of the kinetic energy, whatever the torques: what goes in less what friction takes.
TEST(MecanumDynamics, EnergyIsNeitherMadeNorLost) {
  Random random{4};
  MecanumBody body = frictionless;
  body.rolling_arm = 0.003;
  const MecanumDynamics dynamics{youbot, body};
  for (int i = 0; i < 1000; ++i) {
    const Twist t = random_twist(random);
    const MecanumTorques torques = random_torques(random);
    const Twist a = dynamics.acceleration(t, torques);
    constexpr double h = 1e-6;
    const Twist after{t.forward + h * a.forward, t.left + h * a.left, t.turn + h * a.turn}, before{t.forward - h * a.forward, t.left - h * a.left, t.turn - h * a.turn};
    const double change = (dynamics.kinetic_energy(after) - dynamics.kinetic_energy(before)) / (2.0 * h);
    const double power = dynamics.power_in(t, torques) - dynamics.power_lost(t);
    EXPECT_NEAR(change, power, 1e-6 * (1.0 + std::abs(power)));
    EXPECT_GE(dynamics.power_lost(t), 0.0);
  }
}

// Wheels that weigh nothing, no torque: the velocity in the world stays, however the body turns. (Printed, it would turn with the body.)
TEST(MecanumDynamics, AFreeBodyKeepsItsVelocityInTheWorld) {
  const MecanumDynamics dynamics{youbot, {30.0, 1.1, 0.0, 0.0}};
  Twist t{0.7, -0.2, 1.3};
  double heading = 0.4;
  const auto in_world = [](const Twist& twist, double facing) { return twist.forward * unit(facing) + twist.left * left_of(unit(facing)); };
  const Vec2 wanted = in_world(t, heading);
  constexpr double h = 1e-3;
  const auto at = [](const Twist& twist, const Twist& rate, double time) { return Twist{twist.forward + time * rate.forward, twist.left + time * rate.left, twist.turn + time * rate.turn}; };
  for (int i = 0; i < 5000; ++i) {  // Runge–Kutta of the fourth order over 5 s, more than a turn
    const Twist k1 = dynamics.acceleration(t, {}), k2 = dynamics.acceleration(at(t, k1, 0.5 * h), {}), k3 = dynamics.acceleration(at(t, k2, 0.5 * h), {}), k4 = dynamics.acceleration(at(t, k3, h), {});
    heading += h * t.turn;  // the turning stays
    t = {t.forward + h / 6.0 * (k1.forward + 2 * k2.forward + 2 * k3.forward + k4.forward), t.left + h / 6.0 * (k1.left + 2 * k2.left + 2 * k3.left + k4.left), t.turn};
  }
  EXPECT_NEAR(distance(in_world(t, heading), wanted), 0.0, 1e-9);
}

TEST(MecanumDynamics, APayloadAddsItsMassAndItsInertiaAboutTheOrigin) {
  const MecanumBody body = loaded(frictionless, 10.0, 0.4, {0.3, -0.4});
  EXPECT_DOUBLE_EQ(body.mass, 40.0);
  EXPECT_DOUBLE_EQ(body.inertia, 1.1 + 0.4 + 10.0 * 0.25);
  const Twist wanted{0.5, 0.2, 0.3};
  const MecanumTorques empty = MecanumDynamics{youbot, frictionless}.torques({}, wanted), full = MecanumDynamics{youbot, body}.torques({}, wanted);
  EXPECT_GT(full.front_right, empty.front_right);  // the one with all three in its favour
}

TEST(MecanumDynamics, EvenInertiaOfARectangleAndADisc) {
  Footprint box{rectangle({-0.29, -0.19}, {0.29, 0.19}), 0.0};
  EXPECT_NEAR(even_inertia(box, 30.0), 30.0 * (0.58 * 0.58 + 0.38 * 0.38) / 12.0, 1e-12);
  for (Vec2& p : box.polygon) p = p + Vec2{0.5, 0.0};  // Steiner
  EXPECT_NEAR(even_inertia(box, 30.0), 30.0 * ((0.58 * 0.58 + 0.38 * 0.38) / 12.0 + 0.25), 1e-12);
  EXPECT_NEAR(even_inertia({{}, 0.4}, 10.0), 0.8, 1e-12);
}

TEST(MecanumDynamics, NoMotorGivesMoreThanItCan) {
  Random random{6};
  MecanumBody body = frictionless;
  body.rolling_arm = 0.002;
  const MecanumDynamics dynamics{youbot, body};
  int cut = 0;
  for (int i = 0; i < 1000; ++i) {
    const Twist twist = random_twist(random), wanted = random_twist(random);
    const double most = random.uniform(0.1, 1.0), share = share_within(dynamics, twist, wanted, most);
    ASSERT_GE(share, 0.0);
    ASSERT_LE(share, 1.0);
    if (share == 0.0) continue;
    const MecanumTorques t = dynamics.torques(twist, {share * wanted.forward, share * wanted.left, share * wanted.turn});
    for (const double torque : {t.front_left, t.front_right, t.rear_left, t.rear_right}) EXPECT_LE(std::abs(torque), most + 1e-12);
    cut += share < 1.0 ? 1 : 0;
  }
  EXPECT_GT(cut, 100);
}

TEST(MecanumKinematics, SaturationKeepsTheWay) {
  const Twist fast{2.0, -1.0, 3.0}, slow = saturated(youbot, fast, 10.0);
  const MecanumWheels w = wheels_of(youbot, slow);
  EXPECT_NEAR(std::max({std::abs(w.front_left), std::abs(w.front_right), std::abs(w.rear_left), std::abs(w.rear_right)}), 10.0, 1e-12);
  EXPECT_NEAR(slow.left / slow.forward, fast.left / fast.forward, 1e-12);
  EXPECT_NEAR(slow.turn / slow.forward, fast.turn / fast.forward, 1e-12);
  const Twist same = saturated(youbot, slow, 10.1);
  EXPECT_EQ(same.forward, slow.forward);
}

}  // namespace
}  // namespace waywright
