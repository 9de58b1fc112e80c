#include "waywright/speed/zone_speed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/speed/test_paths.hpp"

namespace waywright {
namespace {

using namespace speed_test;

Zone slow(Ring area, double speed) {
  Zone zone;
  zone.type = ZoneType::speed_limit;
  zone.area = std::move(area);
  zone.speed = speed;
  return zone;
}

Scenario along_a_line(Footprint footprint, std::vector<Zone> zones) {
  Scenario s;
  s.vehicle = differential();
  s.vehicle.drive = Differential{0.5};
  s.vehicle.footprint = std::move(footprint);
  s.start = {0, 0, 0};
  s.mission = Pose{20, 0, 0};
  s.zones = std::move(zones);
  return s;
}

struct Driven {
  std::vector<Sample> samples;
  double time = 0.0;
};

Driven driven(const Problem& problem, const Path& path) {
  Driven d{sample(path, problem.footprint().radius(), 5e-4), 0.0};
  SpeedWorkspace workspace;
  d.time = assign_speed(d.samples, problem.vehicle(), 0.0, workspace, zone_limits(problem, d.samples, 5e-4));
  return d;
}

const Path line20{{{Line{{0, 0}, {20, 0}}, 1}}};

// A box from −1 to 0.5 m is in the zone from x = 8 to 12 while its origin is from 7.5 to 13: as long as that, and a step before and after it at most, it drives 0.4 m/s.
TEST(ZoneSpeed, OnALineInClosedForm) {
  const Problem problem = Problem::prepare(along_a_line({rectangle({-1.0, -0.3}, {0.5, 0.3}), 0.0}, {slow(rectangle({8, -2}, {12, 0}), 0.4)})).value();
  const Driven d = driven(problem, line20);
  EXPECT_EQ(broken_limit(d.samples, problem.vehicle()), "");
  double first = 1e9, last = 0.0;
  for (const Sample& s : d.samples) {
    const bool touches = s.x + 0.5 >= 8.0 && s.x - 1.0 <= 12.0;
    if (touches) {
      ASSERT_LE(s.speed, 0.4 + 1e-12) << s.x;
      first = std::min(first, s.s);
      last = std::max(last, s.s);
    }
  }
  // In between at the limit, as long as that and no longer than 5 cm more to each side: ramps of a = d = 0.5 from and to 1 m/s.
  const auto time_for = [](double begin, double end) {
    const double ramp = (1.0 - 0.4 * 0.4) / (2 * 0.5);  // m, and (1 − 0.4)/0.5 s
    const double before = begin - 1.0 - ramp, after = 20.0 - end - 1.0 - ramp;
    return 2.0 + 2.0 + before + after + 2 * (0.6 / 0.5) + (end - begin) / 0.4;
  };
  EXPECT_NEAR(first, 7.5, 0.051);
  EXPECT_NEAR(last, 13.0, 0.051);
  EXPECT_GE(d.time, time_for(7.5, 13.0) - 1e-6);
  EXPECT_LE(d.time, time_for(7.45, 13.05) + 0.01);  // where a ramp ends between samples it is a little less steep
  // What it would be without.
  auto free = sample(line20, 1.1, 5e-4);
  EXPECT_NEAR(assign_speed(free, problem.vehicle()), 22.0, 1e-6);
}

TEST(ZoneSpeed, TheSlowestOfSeveralHolds) {
  const Problem problem = Problem::prepare(along_a_line({{}, 0.2}, {slow(rectangle({5, -1}, {15, 1}), 0.6), slow(rectangle({9, -1}, {11, 1}), 0.2), slow(rectangle({30, 0}, {31, 1}), 0.1)})).value();
  const Driven d = driven(problem, line20);
  for (const Sample& s : d.samples) {
    if (s.x > 8.8 && s.x < 11.2) {
      ASSERT_LE(s.speed, 0.2 + 1e-12);
    }
    if (s.x > 4.8 && s.x < 15.2) {
      ASSERT_LE(s.speed, 0.6 + 1e-12);
    }
  }
  EXPECT_NEAR(d.samples[d.samples.size() / 2].speed, 0.2, 1e-9);
  EXPECT_NEAR(std::max_element(d.samples.begin(), d.samples.end(), [](const Sample& a, const Sample& b) { return a.speed < b.speed; })->speed, 1.0, 1e-9);
  ASSERT_NE(slowest_zone_at(problem, {10, 0, 0}), nullptr);
  EXPECT_EQ(slowest_zone_at(problem, {10, 0, 0})->speed, 0.2);
  EXPECT_EQ(slowest_zone_at(problem, {2, 0, 0}), nullptr);
}

// The zone lies between two samples' footprints: what is swept between them counts.
TEST(ZoneSpeed, NothingSlipsThroughBetweenSamples) {
  const Problem problem = Problem::prepare(along_a_line({{}, 0.0}, {slow(rectangle({10.020, -1}, {10.021, 1}), 0.1)})).value();
  const Driven d = driven(problem, line20);
  int slowed = 0;
  for (const Sample& s : d.samples) slowed += s.s > 9.9 && s.s < 10.1 && s.speed <= 0.1 + 1e-12 ? 1 : 0;
  EXPECT_GE(slowed, 2);
}

TEST(ZoneSpeed, ThePoseErrorIsAllowedFor) {
  Scenario s = along_a_line({{}, 0.2}, {slow(rectangle({5, 0.25}, {15, 1}), 0.3)});
  EXPECT_NEAR(driven(Problem::prepare(s).value(), line20).time, 22.0, 1e-6);  // passes beside it
  s.pose_error = {0.1, 0.0, 0.0};
  EXPECT_GT(driven(Problem::prepare(s).value(), line20).time, 40.0);
}

TEST(ZoneSpeed, WithoutSuchZonesThereIsNothing) {
  Zone forbidden = slow(rectangle({5, 5}, {6, 6}), 0.3);
  forbidden.type = ZoneType::forbidden;
  const Problem problem = Problem::prepare(along_a_line({{}, 0.2}, {forbidden})).value();
  const auto samples = sample(line20, 0.2, 5e-4);
  EXPECT_TRUE(zone_limits(problem, samples, 5e-4).steps.empty());
  EXPECT_TRUE(zone_limits(problem, samples, 5e-4).samples.empty());
}

// A vehicle that moves already may be braking towards a zone between the samples of another's plan.
TEST(ZoneSpeed, AMovingStartIsHeldToItsOwnPlaceAlone) {
  const Problem problem = Problem::prepare(along_a_line({{}, 0.2}, {slow(rectangle({2.21, -1}, {15, 1}), 0.3)})).value();
  SpeedWorkspace workspace;
  // Braking at 0.5 m/s² to 0.3 m/s at x = 2.0, before the footprint comes to the zone at x = 2.01: from x = 1.53 with this speed. Its samples lie at 1.98 and 2.03.
  const double speed = std::sqrt(0.3 * 0.3 + 2 * 0.5 * 0.47);
  auto samples = sample(Path{{{Line{{1.53, 0}, {20, 0}}, 1}}}, 0.2, 5e-4);
  EXPECT_TRUE(can_start_with(samples, problem.vehicle(), speed, workspace, zone_limits(problem, samples, 5e-4)));
  EXPECT_FALSE(can_start_with(samples, problem.vehicle(), 1.2 * speed, workspace, zone_limits(problem, samples, 5e-4)));
}

}  // namespace
}  // namespace waywright
