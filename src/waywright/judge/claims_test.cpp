// Honest plans verify; a plan with any one number falsified does not.
#include "waywright/judge/claims.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "waywright/curve/bezier.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/speed/speed.hpp"

namespace waywright {
namespace {

Vehicle tricycle() {
  Vehicle v;
  v.footprint.polygon = rectangle({-2.30, -0.45}, {0.40, 0.45});
  v.drive = Tricycle{1.9, 1.0472, 0.7, SteeredAxle::rear};
  v.limits = {1.2, 1.0, 0.5, 0.6, 0.4, 0.8, std::nullopt, 0.8, 1.5};
  return v;
}

Vehicle differential() {
  Vehicle v;
  v.footprint.disc = 0.4;
  v.drive = Differential{0.5};
  v.limits = {1.0, 0.6, 0.5, 0.5, 0.4, 0.8, 0.7, std::nullopt, std::nullopt};
  return v;
}

Plan judged(const Vehicle& vehicle, const Path& path) {
  Scenario s;
  s.map.points = {{2.0, 3.5}, {-4.0, -2.5}};
  s.vehicle = vehicle;
  s.start = start_pose(path);
  s.mission = end_pose(path);
  Plan plan = judge(Problem::prepare(s).value(), path);
  EXPECT_EQ(plan.status, Status::solved) << plan.reason;
  return plan;
}

/// Backwards on a bend, forwards straight, on an arc whose curvature jumps, on.
Plan tricycle_plan() {
  const BezierSpan bend = straight_ended_quintic({0, 0}, {4.0, 0}, {4, 1.5}, 4.0 * unit(0.6));
  Path path{{{Spline{SplineKind::quintic, {bend}}, -1}}};
  Pose at = end_pose(path);
  path.pieces.push_back({Line{at.position(), at.position() + 1.3 * unit(at.heading)}, 1});
  at = end_pose(path);
  path.pieces.push_back({Arc{at, 0.5, 0.8}, 1});
  at = end_pose(path);
  path.pieces.push_back({Line{at.position(), at.position() + 0.9 * unit(at.heading)}, 1});
  return judged(tricycle(), path);
}

/// Turns on the spot, between stretches, to both sides.
Plan differential_plan() {
  Path path{{{Line{{0, 0}, {1.5, 0}}, 1}, {Turn{{1.5, 0}, 0.0, 1.2}, 0}, {Turn{{1.5, 0}, 1.2, -0.4}, 0}}};
  path.pieces.push_back({Arc{{1.5, 0, 0.8}, -0.9, 1.1}, 1});
  const Pose at = end_pose(path);
  path.pieces.push_back({Line{at.position(), at.position() - 0.7 * unit(at.heading)}, -1});
  return judged(differential(), path);
}

std::vector<std::string> findings(const Plan& plan) { return verify(plan).value().findings; }

TEST(Claims, HonestPlansHold) {
  for (const Plan& plan : {tricycle_plan(), differential_plan()}) {
    for (const std::string& finding : findings(plan)) ADD_FAILURE() << finding;
  }
}

TEST(Claims, OtherSamplesOfTheSameCurvesAndSlowerDrivesHold) {
  for (Plan plan : {tricycle_plan(), differential_plan()}) {
    plan.samples = sample(plan.path, plan.scenario.vehicle.footprint.radius(), 5e-4, 0.013);
    Vehicle slow = plan.scenario.vehicle;
    slow.limits.speed *= 0.5;
    slow.limits.reverse_speed *= 0.5;
    slow.limits.acceleration *= 0.5;
    slow.limits.deceleration *= 0.5;
    slow.limits.angular_speed = 0.5 * *slow.limits.angular_speed;
    if (slow.limits.angular_acceleration)
      slow.limits.angular_acceleration = 0.25 * *slow.limits.angular_acceleration;
    plan.metrics.travel_time = assign_speed(plan.samples, slow);
    for (const std::string& finding : findings(plan)) ADD_FAILURE() << finding;
  }
}

TEST(Claims, EveryColumnIsHeldAgainstTheCurves) {
  using Change = std::function<void(Sample&)>;
  const std::vector<std::pair<const char*, Change>> columns{
      {"s", [](Sample& s) { s.s += 0.004; }},
      {"x", [](Sample& s) { s.x += 0.004; }},
      {"y", [](Sample& s) { s.y -= 0.004; }},
      {"heading", [](Sample& s) { s.heading += 0.02; }},
      {"course", [](Sample& s) { s.course = wrap(s.course + pi); }},
      {"curvature", [](Sample& s) { s.curvature += 0.3; }},
      {"direction", [](Sample& s) { s.direction = s.direction == 1 ? -1 : 1; }},
      {"t", [](Sample& s) { s.t += 0.5; }},
      {"t", [](Sample& s) { s.t -= 0.02; }},
      {"speed", [](Sample& s) { s.speed += 0.2; }},
      {"speed", [](Sample& s) { s.speed = -0.1; }},
  };
  for (const Plan& plan : {tricycle_plan(), differential_plan()}) {
    for (const std::size_t i : {plan.samples.size() / 7, plan.samples.size() / 3, plan.samples.size() / 2,
                                plan.samples.size() - 9}) {
      for (const auto& [name, change] : columns) {
        Plan other = plan;
        if (other.samples[i].direction == 0 && std::string{name} == "t")
          continue;  // a longer stand is honest
        change(other.samples[i]);
        EXPECT_FALSE(findings(other).empty()) << name << " of sample " << i;
      }
    }
  }
}

TEST(Claims, DrivingThroughStopsAndStandingWithoutTimeAreFound) {
  const auto falsified = [](const Plan& plan, const std::function<void(std::vector<Sample>&)>& change) {
    Plan other = plan;
    change(other.samples);
    other.metrics.travel_time = other.samples.back().t;
    return !findings(other).empty();
  };
  for (const Plan& plan : {tricycle_plan(), differential_plan()}) {
    // One direction all along, and the speeds that would be right then.
    EXPECT_TRUE(falsified(plan, [&](std::vector<Sample>& samples) {
      for (Sample& s : samples) s.direction = 1, s.curvature = s.curvature_rate = 0.0, s.course = 0.0;
      assign_speed(samples, plan.scenario.vehicle);
    }));
    // The right direction, but no stop where curvature jumps or the vehicle turns, and no time for it.
    EXPECT_TRUE(falsified(plan, [&](std::vector<Sample>& samples) {
      std::vector<Sample> free = samples;
      for (Sample& s : free) s.curvature = s.curvature_rate = s.heading = 0.0;
      assign_speed(free, plan.scenario.vehicle);
      for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i].speed = free[i].speed, samples[i].t = free[i].t;
    }));
    EXPECT_TRUE(falsified(plan, [](std::vector<Sample>& samples) {
      for (Sample& s : samples) s.speed = s.t = 0.0;
    }));
    // Standing at every sample, in the time of the drive.
    EXPECT_TRUE(falsified(plan, [](std::vector<Sample>& samples) {
      for (Sample& s : samples) s.speed = 0.0;
    }));
    // A vehicle that accelerates twice as fast.
    EXPECT_TRUE(falsified(plan, [&](std::vector<Sample>& samples) {
      Vehicle fast = plan.scenario.vehicle;
      fast.limits.acceleration *= 2.0;
      assign_speed(samples, fast);
    }));
    // The pose where the direction changes stands once.
    EXPECT_TRUE(falsified(plan, [](std::vector<Sample>& samples) {
      for (std::size_t i = 1; i < samples.size(); ++i) {
        if (!is_direction_change(samples[i - 1], samples[i])) continue;
        samples.erase(samples.begin() + static_cast<std::ptrdiff_t>(i));
        return;
      }
    }));
    // Samples left out.
    EXPECT_TRUE(falsified(
        plan, [](std::vector<Sample>& samples) { samples.erase(samples.begin() + 5, samples.begin() + 9); }));
  }
  // Steering and angular acceleration that take no time.
  Plan plan = tricycle_plan();
  EXPECT_TRUE(falsified(plan, [&](std::vector<Sample>& samples) {
    Vehicle other = plan.scenario.vehicle;
    std::get<Tricycle>(other.drive).max_steering_rate = 7.0;
    assign_speed(samples, other);
  }));
  plan = differential_plan();
  EXPECT_TRUE(falsified(plan, [&](std::vector<Sample>& samples) {
    Vehicle other = plan.scenario.vehicle;
    other.limits.angular_acceleration = 1.4;
    assign_speed(samples, other);
  }));
}

TEST(Claims, EveryMetricIsMeasuredAgain) {
  const Plan plan = tricycle_plan();
  for (double Metrics::*metric :
       {&Metrics::length, &Metrics::min_clearance, &Metrics::mean_clearance, &Metrics::max_curvature,
        &Metrics::max_curvature_rate, &Metrics::curvature_change, &Metrics::curvature_change_printed,
        &Metrics::turning, &Metrics::collision_risk, &Metrics::travel_time}) {
    for (const double factor : {0.0, 0.9, 1.1}) {
      Plan other = plan;
      other.metrics.*metric *= factor;
      if (factor > 0.0 && plan.metrics.*metric < 0.1) continue;
      EXPECT_EQ(findings(other).size(), plan.metrics.*metric == 0.0 ? 0U : 1U) << plan.metrics.*metric;
    }
  }
  Plan other = plan;
  ++other.metrics.direction_changes;
  EXPECT_EQ(findings(other).size(), 1U);
}

TEST(Claims, TheCertificateClaimsNoMoreThanWasProven) {
  const Plan plan = tricycle_plan();
  Plan other = plan;
  other.certificate.clearance += 1e-5;
  EXPECT_EQ(findings(other).size(), 1U);
  other = plan;
  other.certificate.checked_length += 0.01;
  EXPECT_EQ(findings(other).size(), 1U);
  other = plan;
  other.certificate.pocket_clearance = 0.01;
  EXPECT_EQ(findings(other).size(), 1U);
}

}  // namespace
}  // namespace waywright
