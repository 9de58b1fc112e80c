// Laws of the speed profile on random paths and vehicles.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>

#include "waywright/core/random.hpp"
#include "waywright/speed/speed.hpp"
#include "waywright/speed/test_paths.hpp"

namespace waywright {
namespace {

using namespace speed_test;

/// A random path of some stretches with smooth curvature, changes of direction, jumps and turns.
std::vector<Sample> random_path(Random& random, bool turns) {
  std::vector<Sample> samples;
  const auto parts = random.integer(1, 4);
  for (std::int64_t p = 0; p < parts; ++p) {
    std::vector<Sample> part;
    if (turns && p > 0 && random.uniform() < 0.3) {
      part = turn(random.uniform(-3, 3), static_cast<std::size_t>(random.integer(1, 60)));
    } else {
      const double size = random.uniform(0, 0.8);
      const double wave = random.uniform(0.2, 3.0);
      const double phase = random.uniform(-pi, pi);
      part = stretch(
          random.uniform(0.01, 6.0), static_cast<std::size_t>(random.integer(1, 150)),
          [=](double s) { return size * std::sin(wave * s + phase); },
          [=](double s) { return size * wave * std::cos(wave * s + phase); },
          random.uniform() < 0.5 ? 1 : -1);
    }
    if (samples.empty())
      samples = part;
    else
      append(samples, part);
  }
  return samples;
}

Vehicle random_vehicle(Random& random) {
  Vehicle vehicle;
  if (random.uniform() < 0.5)
    vehicle = tricycle(random.uniform() < 0.7 ? std::optional{random.uniform(0.02, 1.0)} : std::nullopt);
  Limits& limits = vehicle.limits;
  limits.speed = random.uniform(0.1, 2.0);
  limits.reverse_speed = random.uniform(0.1, 2.0);
  limits.acceleration = random.uniform(0.05, 2.0);
  limits.deceleration = random.uniform(0.05, 2.0);
  if (random.uniform() < 0.5) limits.lateral_acceleration = random.uniform(0.01, 1.0);
  if (random.uniform() < 0.5) limits.angular_speed = random.uniform(0.02, 1.0);
  if (random.uniform() < 0.5) limits.angular_acceleration = random.uniform(0.01, 1.0);
  if (random.uniform() < 0.2) limits.curvature_rate = 1.0;
  return vehicle;
}

TEST(Speed, EveryLimitHoldsOnRandomPaths) {
  Random random{21};
  for (int i = 0; i < 3000; ++i) {
    const Vehicle vehicle = random_vehicle(random);
    auto samples = random_path(random, std::holds_alternative<Differential>(vehicle.drive));
    const double time = assign_speed(samples, vehicle);
    ASSERT_EQ(broken_limit(samples, vehicle), "") << "path " << i;
    ASSERT_GT(time, 0.0);
  }
}

// What begins at the greatest speed, or at any under it, comes to an end within the limits; what should begin faster does where braking is
// enough, and keeps them at its samples then; else it begins at the greatest.
TEST(Speed, EveryLimitHoldsFromAMovingStart) {
  Random random{23};
  SpeedWorkspace workspace;
  int moving = 0, braking = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vehicle vehicle = random_vehicle(random);
    auto samples = random_path(random, std::holds_alternative<Differential>(vehicle.drive));
    const double greatest = greatest_start_speed(samples, vehicle, workspace);
    if (greatest == 0.0) continue;
    ++moving;
    assign_speed(samples, vehicle, greatest, workspace);
    ASSERT_NEAR(samples.front().speed, greatest, 1e-12 * greatest) << "path " << i;
    ASSERT_EQ(broken_limit(samples, vehicle, 1e-6, samples.front().speed), "") << "path " << i;
    const double faster = greatest * random.uniform(1.0, 1.5);
    const bool can = can_start_with(samples, vehicle, faster, workspace);
    assign_speed(samples, vehicle, faster);
    ASSERT_NEAR(samples.front().speed, can ? faster : greatest, 1e-3 * faster) << "path " << i;
    ASSERT_EQ(broken_limit(samples, vehicle, 2e-3, samples.front().speed), "") << "path " << i;
    braking += can ? 1 : 0;
    const double slower = greatest * random.uniform(0.01, 0.999);
    assign_speed(samples, vehicle, slower);
    ASSERT_EQ(broken_limit(samples, vehicle, 1e-6, slower), "") << "path " << i;
  }
  EXPECT_GT(moving, 2000);
  EXPECT_GT(braking, 20);
}

// What is left of a path is driven no slower than as a part of the whole, whichever sample it begins with.
TEST(Speed, TheRestOfAPathGoesOnAtTheSpeedThatTheWholeHasThere) {
  Random random{24};
  int moving = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vehicle vehicle = random_vehicle(random);
    auto whole = random_path(random, std::holds_alternative<Differential>(vehicle.drive));
    assign_speed(whole, vehicle);
    const auto first = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(whole.size()) - 2));
    if (whole[first].direction == 0) continue;  // a turn on the spot begins at rest
    std::vector<Sample> rest(whole.begin() + static_cast<std::ptrdiff_t>(first), whole.end());
    const double time = assign_speed(rest, vehicle, whole[first].speed);
    moving += whole[first].speed > 0.0 ? 1 : 0;
    ASSERT_LE(time, whole.back().t - whole[first].t + 1e-9) << "path " << i;
    for (std::size_t k = 0; k < rest.size(); ++k) ASSERT_GE(rest[k].speed, whole[first + k].speed - 1e-9) << "path " << i << " sample " << first + k;
  }
  EXPECT_GT(moving, 1500);
}

// No sample can be driven faster while its neighbours stay as they are: the profile leaves nothing on the
// table.
TEST(Speed, NothingCanBeRaised) {
  Random random{22};
  int raised = 0;
  for (int i = 0; i < 300; ++i) {
    const Vehicle vehicle = random_vehicle(random);
    auto samples = random_path(random, false);
    assign_speed(samples, vehicle);
    for (std::size_t k = 1; k + 1 < samples.size(); ++k) {
      if (samples[k].speed == 0.0 || samples[k].s - samples[k - 1].s < 1e-9 ||
          samples[k + 1].s - samples[k].s < 1e-9)
        continue;
      // The limits of a step hold for the worse of its ends; so must those of this check.
      std::vector<Sample> part(samples.begin() + static_cast<std::ptrdiff_t>(k) - 1,
                               samples.begin() + static_cast<std::ptrdiff_t>(k) + 2);
      const double speed = samples[k].speed * 1.01;
      bool broken = false;
      for (const Sample& s : part) {
        std::vector<Sample> one{s};
        one.front().speed = speed;
        const Limits& l = vehicle.limits;
        broken =
            broken || speed > (s.direction < 0 ? l.reverse_speed : l.speed) ||
            (l.lateral_acceleration && speed * speed * std::abs(s.curvature) > *l.lateral_acceleration) ||
            (l.angular_speed && speed * std::abs(s.curvature) > *l.angular_speed);
        if (const auto* t = std::get_if<Tricycle>(&vehicle.drive); t != nullptr && t->max_steering_rate) {
          const double bend = t->wheelbase * s.curvature;
          broken = broken || t->wheelbase * std::abs(s.curvature_rate) * speed / (1 + bend * bend) >
                                 *t->max_steering_rate;
        }
      }
      const double before = part[0].speed;
      const double after = part[2].speed;
      const double up = (speed * speed - before * before) / (2 * (part[1].s - part[0].s));
      const double down = (after * after - speed * speed) / (2 * (part[2].s - part[1].s));
      broken = broken || up > vehicle.limits.acceleration || -down > vehicle.limits.deceleration;
      if (vehicle.limits.angular_acceleration) {
        const double bound = *vehicle.limits.angular_acceleration;
        const auto angular = [](const Sample& s, double a, double v) {
          return std::abs(s.curvature * a + s.curvature_rate * v * v);
        };
        broken = broken || angular(part[0], up, before) > bound || angular(part[1], up, speed) > bound ||
                 angular(part[1], down, speed) > bound || angular(part[2], down, after) > bound;
      }
      raised += broken ? 0 : 1;
      ASSERT_TRUE(broken) << "path " << i << " sample " << k;
    }
  }
  EXPECT_EQ(raised, 0);
}

}  // namespace
}  // namespace waywright
