// Spans in which something that moves may be too near: held against single times by plain trigonometry, and against closed forms.
#include "waywright/proof/moving_clearance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

Problem problem_of(const Footprint& footprint, std::vector<MovingObstacle> moving) {
  Scenario s;
  s.vehicle.footprint = footprint;
  s.start = {0, 0, 0};
  s.mission = Pose{1, 0, 0};
  s.moving = std::move(moving);
  return Problem::prepare(std::move(s)).value();
}

MovingObstacle disc(double radius, std::vector<MovingObstacle::Place> track, Vec2 velocity = {}) {
  MovingObstacle obstacle;
  obstacle.footprint = {{}, radius};
  obstacle.track = std::move(track);
  obstacle.velocity = velocity;
  return obstacle;
}

bool is_in(const std::vector<TimeSpan>& spans, double t) {
  return std::any_of(spans.begin(), spans.end(), [&](const TimeSpan& s) { return s.begin <= t && t <= s.end; });
}

TEST(MovingClearance, ADiscThatPassesADiscIsTooNearForAsLongAsGeometrySays) {
  // Passes at a distance of 0.3 m at 0.5 m/s; radii 0.2 and 0.3, 0.1 m needed: too near while the middles are within 0.6 m.
  const Problem problem = problem_of({{}, 0.2}, {disc(0.3, {{0.0, {-10.0, 0.3, 0.0}}}, {0.5, 0.0})});
  const MovingClearance clearance{problem, 0.1, 0.0};
  std::vector<TimeSpan> spans;
  clearance.blocked({0, 0, 0}, {0, 0, 0}, 0, 0.0, MovingClearance::for_ever, spans);
  ASSERT_EQ(spans.size(), 1U);
  const double half = std::sqrt(0.36 - 0.09) / 0.5;
  EXPECT_LE(spans[0].begin, 20.0 - half);
  EXPECT_GE(spans[0].end, 20.0 + half);
  EXPECT_NEAR(spans[0].begin, 20.0 - half, 0.03);
  EXPECT_NEAR(spans[0].end, 20.0 + half, 0.03);
  // One that just misses it.
  const Problem beside = problem_of({{}, 0.2}, {disc(0.3, {{0.0, {-10.0, 0.61, 0.0}}}, {0.5, 0.0})});
  MovingClearance{beside, 0.1, 0.0}.blocked({0, 0, 0}, {0, 0, 0}, 0, 0.0, MovingClearance::for_ever, spans);
  EXPECT_TRUE(spans.empty());
}

TEST(MovingClearance, WhatStaysStaysForEverAndWhatIsUncertainGrows) {
  const Problem problem = problem_of({{}, 0.2}, {disc(0.3, {{0.0, {-4.0, 0.0, 0.0}}, {4.0, {0.4, 0.0, 0.0}}}), disc(0.3, {{0.0, {3.0, 0.0, 0.0}}})});
  const MovingClearance clearance{problem, 0.0, 0.0};
  std::vector<TimeSpan> spans;
  clearance.blocked({0, 0, 0}, {0, 0, 0}, 0, 0.0, MovingClearance::for_ever, spans);
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_TRUE(std::isinf(spans[0].end));
  EXPECT_NEAR(spans[0].begin, 3.5 / 1.1, 0.03);
  clearance.blocked({0, 0, 0}, {0, 0, 0}, 1, 0.0, MovingClearance::for_ever, spans);
  EXPECT_TRUE(spans.empty());
  MovingObstacle uncertain = disc(0.3, {{0.0, {3.0, 0.0, 0.0}}});
  uncertain.spread = 0.1;  // 2.5 m are gone after 25 s
  const Problem later = problem_of({{}, 0.2}, {uncertain});
  MovingClearance{later, 0.0, 0.0}.blocked({0, 0, 0}, {0, 0, 0}, 0, 0.0, 60.0, spans);
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_NEAR(spans[0].begin, 25.0, 0.05);
  EXPECT_EQ(spans[0].end, 60.0);
}

TEST(MovingClearance, NoMomentOutsideOfItsSpansIsTooNear) {
  Random random{4};
  int inside = 0, outside = 0, needless = 0;
  for (int i = 0; i < 150; ++i) {
    const Footprint vehicle = i % 2 == 0 ? Footprint{{}, random.uniform(0.0, 0.5)} : Footprint{rectangle({-0.3, -0.2}, {0.7, 0.2}), 0.0};
    MovingObstacle obstacle;
    obstacle.footprint = i % 3 == 0 ? Footprint{rectangle({-0.5, -0.1}, {0.5, 0.3}), 0.0} : Footprint{{}, random.uniform(0.0, 0.4)};
    obstacle.track.clear();
    double t = random.uniform(0.0, 2.0);
    for (int k = 0; k < 3; ++k) {
      obstacle.track.push_back({t, {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-3, 3)}});
      t += random.uniform(0.5, 5.0);
    }
    obstacle.velocity = {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
    const Problem problem = problem_of(vehicle, {obstacle});
    const double needed = i % 4 == 0 ? 0.1 : 0.0;
    const MovingClearance clearance{problem, needed, 5e-4};
    const Pose a{0, 0, random.uniform(-3, 3)}, b{a.x + random.uniform(-0.05, 0.05), a.y + random.uniform(-0.05, 0.05), a.heading + random.uniform(-0.05, 0.05)};
    std::vector<TimeSpan> spans;
    clearance.blocked(a, b, 0, 0.0, MovingClearance::for_ever, spans);
    for (std::size_t k = 0; k + 1 < spans.size(); ++k) EXPECT_LT(spans[k].end, spans[k + 1].begin);
    for (double at = 0.0; at < 25.0; at += 0.037) {
      double least = 10.0;
      for (double share = 0.0; share <= 1.0; share += 0.25) {
        const Pose pose{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), wrap(a.heading + share * (b.heading - a.heading))};
        least = std::min(least, clearance.distance_at(pose, 0, at, 10.0));
      }
      if (!is_in(spans, at)) {
        ++outside;
        ASSERT_GT(least, needed) << i << " at " << at;
      } else {
        ++inside;
        needless += least > needed + 0.03 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(inside, 2000);
  EXPECT_GT(outside, 20'000);
  EXPECT_LT(needless, inside / 50);
}

TEST(MovingClearance, AWayInTimeIsCheckedWhole) {
  // 4 m at 1 m/s along x; a disc stands at (2, 0) but for 0.6 s: from 1.7 s to 2.3 s the way is free there, which is when the vehicle passes with its middle alone.
  const auto way = [](double speed) {
    std::vector<Sample> samples;
    for (int i = 0; i <= 80; ++i) {
      Sample s;
      s.s = s.x = 0.05 * i;
      s.t = s.s / speed;
      s.speed = speed;
      samples.push_back(s);
    }
    return samples;
  };
  const Problem problem = problem_of({{}, 0.0}, {disc(0.1, {{0.0, {2.0, 0.0, 0.0}}, {1.5, {2.0, 0.0, 0.0}}, {1.7, {2.0, 1.0, 0.0}}, {2.3, {2.0, 1.0, 0.0}}, {2.5, {2.0, 0.0, 0.0}}})});
  EXPECT_TRUE(check_in_time(problem, way(1.0), 5e-4).empty());
  ASSERT_EQ(check_in_time(problem, way(0.7), 5e-4).size(), 1U);
  EXPECT_NE(check_in_time(problem, way(0.7), 5e-4).front().sentence.find("moving obstacle 1"), std::string::npos);
  EXPECT_EQ(check_in_time(problem, way(2.0), 5e-4).size(), 1U);
}

TEST(MovingClearance, WhatWouldTakeMinutesIsNotProven) {
  MovingObstacle walker = disc(0.1, {});
  for (int i = 0; i < 10'000; ++i) walker.track.push_back({0.1 * i, {1000.0 + 0.01 * i, 0.0, 0.0}});
  const Problem problem = problem_of({{}, 0.0}, {walker});
  EXPECT_FALSE(is_too_much_in_time(problem, 4000));
  EXPECT_TRUE(is_too_much_in_time(problem, 4001));
  std::vector<Sample> samples(5000);
  const auto violations = check_in_time(problem, samples, 5e-4);
  ASSERT_EQ(violations.size(), 1U);
  EXPECT_NE(violations.front().sentence.find("too many"), std::string::npos);
}

}  // namespace
}  // namespace waywright
