// GenerateControls: segments end where they should, nothing is touched, the vehicle's limits hold.
#include "waywright/drive/whale_controls.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/drive/drive_model.hpp"
#include "waywright/drive/test_plans.hpp"

namespace waywright {
namespace {

using namespace drive_test;

struct Case {
  Problem problem;
  Plan plan;
};
Case case_of(const Vehicle& vehicle, const Path& path, const std::vector<Vec2>& points = {}) {
  Problem problem = Problem::prepare(scenario_of(vehicle, path, points)).value();
  Plan plan = judge(problem, path);
  EXPECT_EQ(plan.status, Status::solved) << plan.reason;
  return {std::move(problem), std::move(plan)};
}

/// A trolley's polyline with points beside it.
Case trolley_case() { return case_of(trolley(), polyline({{0, 0}, {2, 0}, {3.2, 1.4}, {3.2, 3.2}, {1.5, 3.6}}), {{1.0, 0.6}, {2.9, 0.1}, {3.8, 2.0}, {2.5, 1.9}, {2.2, 2.9}}); }

TEST(DriveModel, FollowsWithinItsLimits) {
  Random random{1};
  for (const Vehicle& vehicle : {trolley(), forklift(), mecanum_base()}) {
    const DriveModel model{vehicle};
    const Limits& limits = vehicle.limits;
    DriveState state;
    const auto* tricycle = std::get_if<Tricycle>(&vehicle.drive);
    double v = 0.0, turn = 0.0;
    for (int i = 0; i < 20'000; ++i) {
      if (i % 37 == 0) {
        v = random.uniform(-3.0, 3.0);
        turn = random.uniform(-3.0, 3.0);
      }
      const DriveState before = state;
      const DriveStep step = i % 500 > 400 ? model.brake(state, 0.05) : model.advance(state, v, turn, 0.05);
      EXPECT_LE(state.v, limits.speed + 1e-12);
      EXPECT_GE(state.v, -limits.reverse_speed - 1e-12);
      EXPECT_LE(std::abs(state.v - before.v), 0.05 * std::max(limits.acceleration, limits.deceleration) + 1e-12);
      EXPECT_GE(before.v * state.v, 0.0) << "through a stand where it turns back";
      EXPECT_EQ(state.pose, arc_step(before.pose, 0.05 * step.v, 0.05 * step.turn));
      if (tricycle != nullptr) {
        EXPECT_LE(std::abs(state.curvature), vehicle.max_curvature() + 1e-12);
        EXPECT_NEAR(state.turn, state.curvature * state.v, 1e-12);
        EXPECT_LE(std::abs(vehicle.steering_angle(state.curvature) - vehicle.steering_angle(before.curvature)), 0.05 * *tricycle->max_steering_rate + 1e-9);
      } else {
        EXPECT_LE(std::abs(state.turn), *limits.angular_speed + 1e-12);
        EXPECT_LE(std::abs(state.turn - before.turn), 0.05 * *limits.angular_acceleration + 1e-12);
      }
      if (i % 500 == 499) {
        EXPECT_TRUE(model.stands(state));
      }
    }
  }
}

/// Whatever is commanded, at any period: every state and what each step is told as keep every limit.
TEST(DriveModel, NoCommandBreaksALimit) {
  Vehicle no_rate = forklift(), slim = trolley(), fast = forklift();
  no_rate.limits.curvature_rate.reset();
  slim.limits.curvature = 1.0;  // wider bends than its turns on the spot
  fast.limits.lateral_acceleration.reset();
  constexpr double hair = 1.0 + 1e-9, creeping = 0.01;
  Random random{2};
  for (const Vehicle& vehicle : {trolley(), forklift(), no_rate, slim, fast}) {
    const DriveModel model{vehicle};
    const Limits& limits = vehicle.limits;
    const auto* tricycle = std::get_if<Tricycle>(&vehicle.drive);
    for (const double period : {0.05, 0.2, 1.0}) {
      DriveState state;
      double v = 0.0, turn = 0.0, bent = 0.0, turned = 0.0;
      for (int i = 0; i < 30'000; ++i) {
        if (i % 23 == 0) {
          v = i % 5 == 0 ? 0.0 : random.uniform(-2.0, 2.0);
          turn = i % 3 == 0 ? 0.0 : random.uniform(-2.0, 2.0);
        }
        const DriveState before = state;
        const DriveStep step = i % 500 > 400 ? model.brake(state, period) : model.advance(state, v, turn, period);
        for (const DriveStep& at : {step, DriveStep{state.v, state.turn}}) {
          ASSERT_LE(std::abs(at.turn), *limits.angular_speed * hair);
          if (limits.lateral_acceleration) {
            ASSERT_LE(std::abs(at.v * at.turn), *limits.lateral_acceleration * hair) << i;
          }
        }
        if (std::abs(state.v) > creeping * hair) {
          ASSERT_LE(std::abs(state.turn), vehicle.max_curvature() * std::abs(state.v) * hair) << i;
        }
        ASSERT_LE(std::abs(state.v) - std::abs(before.v), period * limits.acceleration * hair);
        ASSERT_LE(std::abs(before.v) - std::abs(state.v), period * limits.deceleration * hair);
        if (tricycle != nullptr && limits.curvature_rate) {
          ASSERT_LE(std::abs(state.curvature - before.curvature), *limits.curvature_rate * period * std::abs(step.v) * hair + 1e-12) << i;
        }
        bent = std::max(bent, std::abs(state.v * state.turn));
        turned = std::max(turned, std::abs(state.turn));
        if (i % 500 == 499) {
          ASSERT_TRUE(model.stands(state)) << "it comes to a stand";
        }
      }
      EXPECT_GT(bent, 0.25) << "limits are used";
      EXPECT_GT(turned, 0.5);
    }
  }
}

TEST(ControlWaypoints, CutAPathWhereItTurnsAndInEqualParts) {
  const Case c = case_of(trolley(), trolley_path());
  const auto w = control_waypoints(c.problem, c.plan, 1.0);
  ASSERT_EQ(w.size(), 5U);  // 1.5 m in two, 1.1 m in two, 0.7 m back
  EXPECT_NEAR(w[0].pose.x, 0.75, 1e-12);
  EXPECT_NEAR(w[1].pose.heading, 0.8, 1e-9) << "the heading after both turns";
  EXPECT_FALSE(w[1].is_stand);
  EXPECT_TRUE(w[3].is_stand) << "it goes back from there";
  EXPECT_EQ(w[4].direction, -1);
  EXPECT_TRUE(w[4].is_stand);
  EXPECT_NEAR(w[2].pose.heading, 0.8 - 0.9 * 0.55, 1e-9) << "on a bend that of the bend";
  // A path that begins with a turn has that as a segment of its own.
  const Case turned = case_of(trolley(), Path{{{Turn{{0, 0}, 0.0, 1.0}, 0}, {Line{{0, 0}, unit(1.0)}, 1}}});
  const auto t = control_waypoints(turned.problem, turned.plan, 2.0);
  ASSERT_EQ(t.size(), 2U);
  EXPECT_EQ(t[0].direction, 0);
  EXPECT_NEAR(t[0].pose.heading, 1.0, 1e-9);
}

/// The simulated track, ten poses a row, touches nothing (by distances to the points, the footprint being a disc).
double least_distance(const Case& c, const WhaleControls& w) {
  double least = 1e9;
  for (std::size_t k = 0; k + 1 < w.rows.size(); ++k) {
    const double time = (w.rows[k + 1].t - w.rows[k].t) / 10.0;
    Pose pose = w.rows[k].pose;
    for (int i = 0; i < 10; ++i) {
      for (const Vec2 p : c.plan.scenario.map.points) least = std::min(least, distance(p, pose.position()));
      pose = arc_step(pose, w.rows[k].twist, time);
    }
    EXPECT_LT(distance(pose.position(), w.rows[k + 1].pose.position()), 1e-9) << "rows follow each other";
  }
  return least;
}

TEST(WhaleControls, EverySegmentEndsNearItsWaypointAndNothingIsTouched) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Case c = trolley_case();
    const WhaleControls w = whale_controls(c.problem, c.plan, {}, 0.05, seed);
    EXPECT_TRUE(w.arrives);
    EXPECT_TRUE(w.collision_free);
    for (const ControlSegment& segment : w.segments) {
      EXPECT_LT(segment.end.position, 0.10);
      EXPECT_TRUE(segment.collision_free);
      EXPECT_GE(segment.triplets.size(), 2U);
      EXPECT_EQ(segment.evaluations, segment.searches * 30 * 81);
    }
    EXPECT_LT(w.end.position, 0.10);
    EXPECT_GT(least_distance(c, w), 0.4);
    EXPECT_NEAR(w.least_clearance, least_distance(c, w) - 0.4, 0.02);
  }
}

TEST(WhaleControls, KeepTheVehiclesLimitsWithinAndBetweenSegments) {
  for (const Case& c : {trolley_case(), case_of(forklift(), forklift_path())}) {
    const WhaleControls w = whale_controls(c.problem, c.plan, {}, 0.05, 1);
    EXPECT_TRUE(w.arrives);
    EXPECT_TRUE(w.collision_free);
    const Limits& limits = c.plan.scenario.vehicle.limits;
    for (std::size_t k = 0; k + 1 < w.rows.size(); ++k) {
      const ControlRow& row = w.rows[k];
      EXPECT_LE(row.twist.forward, limits.speed + 1e-9);
      EXPECT_GE(row.twist.forward, -limits.reverse_speed - 1e-9);
      EXPECT_LE(std::abs(row.twist.turn), *limits.angular_speed + 1e-9);
      // Means over steps that are at most a period long.
      EXPECT_LE(std::abs(w.rows[k + 1].twist.forward - row.twist.forward), 0.05 * std::max(limits.acceleration, limits.deceleration) + 1e-9);
      if (limits.angular_acceleration) {
        EXPECT_LE(std::abs(w.rows[k + 1].twist.turn - row.twist.turn), 0.05 * *limits.angular_acceleration + 1e-9);
      }
    }
    // Where a segment ends, the next begins: times add up.
    double time = 0.0;
    for (const ControlSegment& segment : w.segments) time += segment.time;
    EXPECT_NEAR(time, w.rows.back().t, 1e-9);
    EXPECT_EQ(w.rows.front().pose, c.plan.samples.front().pose());
    EXPECT_EQ(w.rows.back().twist.forward, 0.0);
  }
}

/// Long steps bend far: what is told of the track is of what its commands do, not of chords.
TEST(WhaleControls, RowsLeadWhereTheySayAtLongPeriods) {
  Vehicle quick = trolley();
  quick.limits.angular_speed = 1.5;
  quick.limits.angular_acceleration = 3.0;
  const Case c = case_of(quick, polyline({{0, 0}, {2, 0}, {3.2, 1.4}, {3.2, 3.2}}), {{1.0, 0.6}, {2.9, 0.1}, {3.8, 2.0}});
  const WhaleControls w = whale_controls(c.problem, c.plan, {.tolerance = 0.1}, 0.8, 1);
  const double least = least_distance(c, w);
  if (w.collision_free) {
    EXPECT_GT(least, 0.4);
  }
  Pose end = w.rows.front().pose;
  for (std::size_t k = 0; k + 1 < w.rows.size(); ++k) end = arc_step(end, w.rows[k].twist, w.rows[k + 1].t - w.rows[k].t);
  EXPECT_NEAR(end_error(end, c.plan.samples.back().pose()).position, w.end.position, 1e-9);
}

TEST(WhaleControls, DirectionsAreThoseOfThePlan) {
  const Case c = case_of(forklift(), forklift_path());
  const WhaleControls w = whale_controls(c.problem, c.plan, {}, 0.05, 2);
  for (const ControlSegment& segment : w.segments) {
    for (const Triplet& triplet : segment.triplets) EXPECT_GE(triplet.v * segment.to.direction, 0.0);
  }
  EXPECT_EQ(w.segments.front().to.direction, -1);
  EXPECT_EQ(w.segments.back().to.direction, 1);
}

TEST(WhaleControls, ASeedGivesTheSameBits) {
  const Case c = case_of(trolley(), polyline({{0, 0}, {1, 0}, {1.5, 0.6}}));
  const auto of = [&](std::uint64_t seed) { return whale_controls(c.problem, c.plan, {.iterations = 20}, 0.05, seed); };
  const WhaleControls a = of(5), b = of(5), d = of(6);
  ASSERT_EQ(a.rows.size(), b.rows.size());
  for (std::size_t k = 0; k < a.rows.size(); ++k) {
    EXPECT_EQ(a.rows[k].pose, b.rows[k].pose);
    EXPECT_EQ(a.rows[k].t, b.rows[k].t);
  }
  EXPECT_NE(a.segments.front().triplets.front().v, d.segments.front().triplets.front().v);
}

TEST(WhaleControls, SayWhereATrackTouchesOrMisses) {
  // More room than there is: whatever is driven comes too near to a point.
  const Case c = case_of(trolley(), polyline({{0, 0}, {2, 0}}), {{1.0, 0.6}, {1.0, -0.6}});
  const WhaleControls w = whale_controls(c.problem, c.plan, {.iterations = 20, .restarts = 0, .most_triplets = 2, .backtracks = 2, .clearance = 0.3}, 0.05, 1);
  EXPECT_FALSE(w.collision_free && w.arrives);
  // Too little time to get there.
  const WhaleControls slow = whale_controls(c.problem, c.plan, {.iterations = 20, .restarts = 0, .most_triplets = 2, .backtracks = 2, .most_time = 0.5, .spacing = 2.0}, 0.05, 1);
  EXPECT_FALSE(slow.arrives);
  EXPECT_GT(slow.worst_end, 0.10);
  EXPECT_GT(slow.end.position, 0.10);
  // Near enough, but facing elsewhere.
  WhaleControlOptions careless{.iterations = 20, .restarts = 0, .most_triplets = 2, .backtracks = 0, .heading_weight = 0.0, .warm = false};
  careless.tolerance = 10.0;
  careless.heading_tolerance = pi + 1.0;
  const Case turn = case_of(trolley(), polyline({{0, 0}, {1.5, 0}, {1.5, 1.5}}));
  const WhaleControls off = whale_controls(turn.problem, turn.plan, careless, 0.05, 1);
  EXPECT_TRUE(off.arrives);
  ASSERT_GT(off.worst_heading, 0.10);
  careless.heading_tolerance = 0.10;
  EXPECT_FALSE(whale_controls(turn.problem, turn.plan, careless, 0.05, 1).arrives);
}

TEST(WhaleControls, APlanThatGoesNowhereStands) {
  Case c = case_of(trolley(), polyline({{0, 0}, {1, 0}}));
  c.plan.samples = {c.plan.samples.front(), c.plan.samples.front()};
  const WhaleControls w = whale_controls(c.problem, c.plan, {}, 0.05, 1);
  EXPECT_TRUE(w.segments.empty());
  ASSERT_EQ(w.rows.size(), 1U);
  EXPECT_EQ(w.rows.front().pose, c.plan.samples.front().pose());
  EXPECT_EQ(exact_controls(c.plan, 0.05).rows.size(), 1U);
}

TEST(WhaleControls, MoreTripletsWhereTwoDoNotDo) {
  // A turn on the spot by three quarters of a circle, slowly: one command cannot last long enough.
  Vehicle slow = trolley();
  slow.limits.angular_speed = 0.3;
  const Case c = case_of(slow, polyline({{0, 0}, {0.6, 0}, {0.1, 0.5}}));
  const WhaleControls two = whale_controls(c.problem, c.plan, {.most_triplets = 2}, 0.05, 1), four = whale_controls(c.problem, c.plan, {}, 0.05, 1);
  EXPECT_EQ(two.segments.front().triplets.size(), 2U);
  EXPECT_GT(four.segments.front().triplets.size(), 2U);
  EXPECT_LT(four.segments.front().end.heading, two.segments.front().end.heading);
}

}  // namespace
}  // namespace waywright
