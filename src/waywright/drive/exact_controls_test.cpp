// Commands of the exact method: against the plan, against what the wheels do by themselves, in a mirror.
#include <gtest/gtest.h>

#include <cmath>

#include "waywright/drive/controls.hpp"
#include "waywright/drive/plan_motion.hpp"
#include "waywright/drive/test_plans.hpp"

namespace waywright {
namespace {

using namespace drive_test;

std::vector<Plan> plans() {
  return {judged(forklift(), forklift_path()), judged(trolley(), trolley_path()), mecanum_plan()};
}

TEST(PlanMotion, PassesEverySampleInTimeAndKeepsTheLimitsBetween) {
  for (const Plan& plan : plans()) {
    const PlanMotion motion{plan.path, plan.samples, plan.scenario.vehicle};
    const Limits& limits = plan.scenario.vehicle.limits;
    double t = 0.0;
    for (const Stretch& stretch : motion.stretches()) {
      EXPECT_NEAR(plan.samples[stretch.first].t, t, 1e-12) << "no gap";
      for (std::size_t i = stretch.first; i <= stretch.last; ++i) {
        const Moment at = motion.at(stretch, plan.samples[i].t - t);
        EXPECT_NEAR(distance(at.pose.position(), {plan.samples[i].x, plan.samples[i].y}), 0.0, 1e-6);
        EXPECT_NEAR(shorter_turn(at.pose.heading, plan.samples[i].heading), 0.0, 1e-6);
        EXPECT_NEAR(at.s, plan.samples[i].s, 1e-9);
      }
      constexpr double step = 0.002;
      double last_speed = -1.0;
      for (double time = step; time < stretch.duration; time += step) {
        const Moment a = motion.at(stretch, time - step), b = motion.at(stretch, time);
        const double speed = (b.s - a.s) / step, turning = (b.heading - a.heading) / step;
        EXPECT_GE(speed, 0.0);
        EXPECT_LE(speed, (stretch.direction < 0 ? limits.reverse_speed : limits.speed) + 1e-9);
        EXPECT_LE(std::abs(turning), *limits.angular_speed + 1e-6);
        // The way is no longer nor shorter than what the curve has between.
        EXPECT_LE(distance(a.pose.position(), b.pose.position()), b.s - a.s + 1e-9);
        EXPECT_NEAR(distance(a.pose.position(), b.pose.position()), b.s - a.s, 1e-6);
        if (last_speed >= 0.0) {
          EXPECT_LE(std::abs(speed - last_speed) / step, std::max(limits.acceleration, limits.deceleration) + 1e-3);
        }
        last_speed = speed;
      }
      t += stretch.duration;
    }
    EXPECT_NEAR(t, plan.samples.back().t, 1e-9);
    EXPECT_EQ(motion.stretches().back().last, plan.samples.size() - 1);
  }
}

TEST(ExactControls, TheEndErrorFallsWithTheSquareOfThePeriod) {
  const Plan plan = judged(forklift(), forklift_path());
  double before = -1.0;
  for (const double period : {0.2, 0.1, 0.05, 0.025}) {
    const ExactControls c = exact_controls(plan, period);
    EXPECT_LT(c.end.position, 0.05 * period * period / (0.05 * 0.05) * 0.01) << period;
    EXPECT_LT(c.end.heading, 1e-9) << "headings are added up exactly";
    if (before >= 0.0) {
      EXPECT_LT(c.deviation, 0.4 * before) << period;
    }
    before = c.deviation;
  }
  EXPECT_LT(exact_controls(plan, 0.001).end.position, 1e-6);
  EXPECT_GT(exact_controls(plan, 0.5).end.position, 1e-5) << "long commands are no bends";
}

TEST(ExactControls, LinesArcsAndTurnsAreExactAtAnyPeriod) {
  for (const Plan& plan : {judged(trolley(), trolley_path()), mecanum_plan()}) {
    const Vehicle& vehicle = plan.scenario.vehicle;
    for (const double period : {0.5, 0.05, 0.013}) {
      const ExactControls c = exact_controls(plan, period);
      EXPECT_LT(c.end.position, 1e-7);
      EXPECT_LT(c.deviation, 1e-7);
      EXPECT_LT(c.end.heading, 1e-9);
    }
    // Midpoint odometry cuts arcs short, by the cube of a command's turn: it shows.
    const ExactControls coarse = exact_controls(plan, 0.5);
    if (std::holds_alternative<Differential>(vehicle.drive)) {
      EXPECT_GT(coarse.midpoint_end.position, 1e-4);
    }
  }
}

/// What the wheels' values alone do, in a hundred steps a command.
Pose driven_by_wheels(const Vehicle& vehicle, const ExactControls& controls) {
  Pose pose = controls.rows.front().pose;
  for (std::size_t k = 0; k + 1 < controls.rows.size(); ++k) {
    const auto w = wheel_values(vehicle.drive, controls.rows[k]);
    Twist twist;
    if (const auto* t = std::get_if<Tricycle>(&vehicle.drive)) {
      const double sign = t->steered_axle == SteeredAxle::rear ? -1.0 : 1.0;
      twist = {w[1] * std::cos(w[0]), 0.0, sign * w[1] * std::sin(w[0]) / t->wheelbase};
    } else if (const auto* d = std::get_if<Differential>(&vehicle.drive)) {
      twist = {0.5 * (w[0] + w[1]), 0.0, (w[0] - w[1]) / d->track};
    } else {
      const auto& m = std::get<Mecanum>(vehicle.drive);
      twist.forward = 0.25 * m.wheel_radius * (w[0] + w[1] + w[2] + w[3]);
      twist.left = 0.25 * m.wheel_radius * (-w[0] + w[1] + w[2] - w[3]);
      twist.turn = 0.25 * m.wheel_radius / (m.half_length + m.half_width) * (-w[0] + w[1] - w[2] + w[3]);
    }
    const double time = (controls.rows[k + 1].t - controls.rows[k].t) / 100.0;
    for (int i = 0; i < 100; ++i) {
      const double middle = pose.heading + 0.5 * twist.turn * time;
      pose.x += time * (twist.forward * std::cos(middle) - twist.left * std::sin(middle));
      pose.y += time * (twist.forward * std::sin(middle) + twist.left * std::cos(middle));
      pose.heading += twist.turn * time;
    }
  }
  return pose;
}

TEST(ExactControls, TheWheelsAloneArriveWithinTheLimits) {
  for (const Plan& plan : plans()) {
    const Vehicle& vehicle = plan.scenario.vehicle;
    const ExactControls c = exact_controls(plan, 0.05);
    const EndError e = end_error(driven_by_wheels(vehicle, c), plan.samples.back().pose());
    EXPECT_LT(e.position, 1e-4);
    EXPECT_LT(e.heading, 1e-6);
    const Limits& limits = vehicle.limits;
    for (std::size_t k = 0; k + 1 < c.rows.size(); ++k) {
      const ControlRow& row = c.rows[k];
      EXPECT_NEAR(row.t, 0.05 * static_cast<double>(k), 1e-9);
      EXPECT_LE(row.twist.forward, limits.speed + 1e-9);
      EXPECT_GE(row.twist.forward, -limits.reverse_speed - 1e-9);
      EXPECT_LE(std::abs(row.twist.turn), *limits.angular_speed + 1e-6);
      EXPECT_LE(std::abs(c.rows[k + 1].twist.forward - row.twist.forward), 0.05 * std::max(limits.acceleration, limits.deceleration) + 1e-6) << k;
      if (const auto* t = std::get_if<Tricycle>(&vehicle.drive)) {
        EXPECT_LE(std::abs(wheel_values(vehicle.drive, row)[0]), t->max_steering);
        EXPECT_LE(std::abs(c.rows[k + 1].steering - row.steering), 0.05 * *t->max_steering_rate * 1.1) << k;
      }
    }
    EXPECT_EQ(c.rows.back().twist.forward, 0.0);
    EXPECT_GE(c.rows.back().t, c.plan_time - 1e-9);
    EXPECT_LE(c.rows.back().t, c.plan_time + 0.05 * (c.stands + 1));
    EXPECT_GT(c.stands, 1);
  }
}

// Nine turns on the spot, each rounded up to a whole period; then something crosses, and the commands go on when the plan does.
TEST(ExactControls, WaitsEndWhenThePlanHasThemEnd) {
  std::vector<Vec2> corners{{0, 0}};
  for (int i = 1; i <= 10; ++i) corners.push_back({0.5 * i, i % 2 == 0 ? 0.0 : 0.3});
  corners.push_back({12, 0.0});
  const Path path = polyline(corners);
  Scenario scenario = scenario_of(trolley(), path);
  MovingObstacle crossing;
  crossing.footprint = {{}, 0.3};
  crossing.track = {{0.0, {9.0, 0.0, 0.0}}, {70.0, {9.0, 0.0, 0.0}}};
  crossing.velocity = {0.0, 1.0};
  scenario.moving = {crossing};
  const Plan plan = judge(Problem::prepare(scenario).value(), path);
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  ASSERT_EQ(plan.waits.size(), 1U);
  const Wait& wait = plan.waits.front();
  for (const double period : {0.3, 0.2, 0.05}) {
    const ExactControls c = exact_controls(plan, period);
    double driven = 0.0, leaves = -1.0;
    for (const ControlRow& row : c.rows) {
      if (driven > wait.s - 1e-6 && row.twist.forward > 0.0) {
        leaves = row.t;
        break;
      }
      driven += row.twist.forward * period;
    }
    EXPECT_GE(leaves, wait.until - 1e-9) << period << ": never sooner";
    EXPECT_LT(leaves, wait.until + period) << period;
    EXPECT_LT(c.end.position, 0.05);
  }
}

TEST(ExactControls, AMecanumBaseDrivesSideways) {
  const Plan plan = sideways_plan();
  const ExactControls c = exact_controls(plan, 0.05);
  EXPECT_LT(c.deviation, 1e-9);
  EXPECT_LT(end_error(driven_by_wheels(plan.scenario.vehicle, c), plan.samples.back().pose()).position, 1e-5);
  const Twist& middle = c.rows[c.rows.size() / 2].twist;
  EXPECT_GT(middle.left, middle.forward) << "mostly to its left";
}

TEST(ExactControls, AMirroredPlanHasMirroredControls) {
  for (const bool is_forklift : {true, false}) {
    const auto of = [&](double side) {
      return exact_controls(is_forklift ? judged(forklift(), forklift_path(side)) : judged(trolley(), trolley_path(side)), 0.05);
    };
    const ExactControls left = of(1.0), right = of(-1.0);
    ASSERT_EQ(left.rows.size(), right.rows.size());
    for (std::size_t k = 0; k < left.rows.size(); ++k) {
      EXPECT_NEAR(left.rows[k].twist.forward, right.rows[k].twist.forward, 1e-9);
      EXPECT_NEAR(left.rows[k].twist.turn, -right.rows[k].twist.turn, 1e-9);
      EXPECT_NEAR(left.rows[k].steering, -right.rows[k].steering, 1e-9);
      EXPECT_NEAR(left.rows[k].pose.y, -right.rows[k].pose.y, 1e-9);
    }
    if (!is_forklift) {
      const auto a = wheel_values(trolley().drive, left.rows[40]), b = wheel_values(trolley().drive, right.rows[40]);
      EXPECT_NEAR(a[0], b[1], 1e-9);
      EXPECT_NEAR(a[1], b[0], 1e-9);
    }
  }
}

TEST(ExactControls, NothingToDriveGivesNoCommands) {
  Plan plan;
  EXPECT_TRUE(exact_controls(plan, 0.05).rows.empty());
}

}  // namespace
}  // namespace waywright
