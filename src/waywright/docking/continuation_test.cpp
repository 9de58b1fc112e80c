#include "waywright/planner/docking/continuation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "waywright/core/random.hpp"
#include "waywright/docking/docking.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/path/remainder.hpp"
#include "waywright/planner/docking/fixture_stations.hpp"

namespace waywright {
namespace {

using fixture::Id;

Docking ready(Scenario scenario) {
  auto docking = Docking::prepare(std::move(scenario));
  EXPECT_TRUE(docking) << docking.error().message();
  return std::move(*docking);
}

/// The shelf turned and moved about its middle.
Shelf moved(const Scenario& scenario, double along, double across, double turned) {
  Shelf shelf = std::get<Station>(scenario.mission).shelf;
  const Frame frame{make_pose(shelf.center, shelf.heading)};
  shelf.center = frame.to_world(Vec2{along, across});
  shelf.heading = wrap(shelf.heading + turned);
  return shelf;
}

double greatest_distance(const std::vector<Sample>& samples, const std::vector<Sample>& from) {
  double greatest = 0.0;
  for (const Sample& s : samples) {
    double least = 1e9;
    for (const Sample& o : from) least = std::min(least, distance(s.pose().position(), o.pose().position()));
    greatest = std::max(greatest, least);
  }
  return greatest;
}

TEST(Handover, IsWhereTheSamplesHaveTheVehicle) {
  const Docking docking = ready(fixture::station(Id::d1, {3.0, -2.0, 0.4}));
  const DockingPlan plan = docking.plan();
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  for (const Sample& s : plan.samples) {
    const Handover h = handover_at(plan.path, plan.samples, s.t);
    EXPECT_NEAR(h.driven, s.s, 1e-8);
    EXPECT_NEAR(std::abs(h.motion.speed), s.speed, 1e-9);
    EXPECT_NEAR(distance(h.pose.position(), s.pose().position()), 0.0, 1e-8);
    EXPECT_FALSE(h.is_turning);
    if (s.speed > 1e-3) {
      EXPECT_EQ(h.motion.speed < 0.0, s.direction < 0) << s.s;
      EXPECT_NEAR(h.motion.curvature, s.curvature, 1e-6) << s.s;
    }
  }
  EXPECT_EQ(handover_at(plan.path, plan.samples, -1.0).driven, 0.0);
  EXPECT_NEAR(handover_at(plan.path, plan.samples, 1e9).driven, plan.samples.back().s, 1e-8);
}

TEST(Continuation, WithoutAnyChangeTheRestIsDrivenOnAsItIs) {
  for (const Id id : {Id::d0, Id::d1, Id::d2, Id::d3}) {
    Scenario scenario = fixture::station(id, {-4.0, 7.0, 2.0});
    scenario.vehicle.limits.lateral_acceleration = 0.2;  // speeds that the bends decide
    const Docking docking = ready(scenario);
    const DockingPlan plan = docking.plan();
    ASSERT_EQ(plan.status, Status::solved) << plan.reason;
    for (double share = 0.0; share < 1.0; share += 0.013) {
      const double t = share * plan.travel_time;
      const Handover now = handover_at(plan.path, plan.samples, t);
      const auto on = docking.from(now.pose, now.motion);
      ASSERT_TRUE(on) << on.error().message();
      const DockingPlan rest = on->replan(plan, now.driven);
      ASSERT_EQ(rest.status, Status::solved) << share << ": " << rest.reason;
      ASSERT_TRUE(rest.is_carried_on) << share;
      EXPECT_EQ(rest.moved, 0.0);
      EXPECT_NEAR(rest.length, plan.length - now.driven, 1e-8) << share;
      EXPECT_NEAR(rest.samples.front().speed, std::abs(now.motion.speed), 2e-6 + 1e-3 * std::abs(now.motion.speed)) << share;
      // As fast as before, but for what its own samples see of the bends.
      EXPECT_NEAR(rest.travel_time, plan.travel_time - t, 0.02 + 0.01 * plan.travel_time) << share;
    }
  }
}

/// Law of every plan that takes over: pose, curvature, direction and speed are those of the vehicle, and it is proven.
void takes_over(const Docking& docking, const DockingPlan& plan, const Handover& now, const char* what) {
  ASSERT_EQ(plan.status, Status::solved) << what;
  const Sample& first = plan.samples.front();
  EXPECT_NEAR(distance(first.pose().position(), now.pose.position()), 0.0, 1e-6) << what;
  EXPECT_NEAR(shorter_turn(first.heading, now.pose.heading), 0.0, 1e-6) << what;
  EXPECT_NEAR(first.speed, std::abs(now.motion.speed), 2e-6 + 1e-3 * std::abs(now.motion.speed)) << what;
  if (std::abs(now.motion.speed) > 1e-6) {
    EXPECT_EQ(first.direction, now.motion.speed < 0.0 ? -1 : 1) << what;
    EXPECT_NEAR(first.curvature, now.motion.curvature, 1e-6) << what;
  }
  const Plan judged = judge(docking.problem(), plan.path);
  EXPECT_EQ(judged.status, Status::solved) << what << ": " << judged.reason;
}

TEST(Continuation, FollowsAShelfThatIsElsewhereByCentimetres) {
  Random random{41};
  int carried = 0, anew = 0, none = 0, near_the_end = 0;
  for (const Id id : {Id::d0, Id::d1, Id::d2}) {
    Scenario scenario = fixture::station(id, {1.0, 2.0, -0.7});
    scenario.vehicle.limits.curvature_rate = 1.5;
    const Docking docking = ready(scenario);
    const DockingPlan plan = docking.plan();
    ASSERT_EQ(plan.status, Status::solved) << plan.reason;
    for (int i = 0; i < 60; ++i) {
      const double t = random.uniform(0.0, plan.travel_time);
      const Handover now = handover_at(plan.path, plan.samples, t);
      const Shelf shelf = moved(scenario, random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), random.uniform(-0.01, 0.01));
      const auto on = docking.from(now.pose, now.motion, shelf);
      ASSERT_TRUE(on) << on.error().message();
      const DockingPlan next = on->replan(plan, now.driven);
      const bool is_early = plan.length - now.driven > 3.0;
      if (next.status != Status::solved) {
        ++none;
        EXPECT_FALSE(is_early) << next.reason;
        continue;
      }
      takes_over(*on, next, now, next.is_carried_on ? "carried on" : "planned anew");
      if (!next.is_carried_on) {
        ++anew;
        near_the_end += is_early ? 0 : 1;
        continue;
      }
      ++carried;
      EXPECT_LE(next.moved, 0.12);
      const Path rest = remainder(plan.path, now.driven);
      EXPECT_LE(greatest_distance(next.samples, sample(rest, 0.0, 1e-4, 0.005)), next.moved + 0.005);
      // The way to the point of changing direction is the very same.
      if (next.path.pieces.size() == 2) {
        EXPECT_EQ(length(next.path.pieces[0]), length(rest.pieces[0]));
      }
    }
  }
  EXPECT_GT(carried, 120) << anew << " planned anew, " << none << " without a plan";
  EXPECT_EQ(anew, near_the_end) << "with metres to go it can be carried along";
}

TEST(Continuation, TheStartMovesTooWhereTheVehicleIsElsewhere) {
  Scenario scenario = fixture::station(Id::d1);
  const Docking docking = ready(scenario);
  const DockingPlan plan = docking.plan();
  ASSERT_EQ(plan.status, Status::solved);
  Random random{5};
  int carried = 0;
  for (int i = 0; i < 40; ++i) {
    Handover now = handover_at(plan.path, plan.samples, random.uniform(0.1, 0.45) * plan.travel_time);
    now.pose = Frame{now.pose}.to_world(make_pose({0.0, random.uniform(-0.02, 0.02)}, random.uniform(-0.01, 0.01)));
    now.motion.curvature += random.uniform(-0.02, 0.02);
    const auto on = docking.from(now.pose, now.motion);
    ASSERT_TRUE(on) << on.error().message();
    const DockingPlan next = on->replan(plan, now.driven);
    ASSERT_EQ(next.status, Status::solved) << next.reason;
    takes_over(*on, next, now, "beside the path");
    carried += next.is_carried_on ? 1 : 0;
  }
  EXPECT_GT(carried, 25);
}

TEST(Continuation, WhatCannotBeCarriedAlongIsEmpty) {
  const Docking docking = ready(fixture::station(Id::d0));
  const DockingPlan plan = docking.plan();
  ASSERT_EQ(plan.status, Status::solved);
  EXPECT_FALSE(continuation(docking.problem(), {}, 0.0));
  // On the straight run into the shelf no curve is left to bend.
  const Handover late = handover_at(plan.path, plan.samples, plan.travel_time - 0.3);
  const auto aside = docking.from(late.pose, late.motion, moved(docking.problem().scenario(), 0.0, 0.02, 0.0));
  const auto farther = docking.from(late.pose, late.motion, moved(docking.problem().scenario(), -0.02, 0.0, 0.0));
  ASSERT_TRUE(farther);
  EXPECT_TRUE(continuation(farther->problem(), plan.path, late.driven)) << "straight on";
  ASSERT_TRUE(aside);
  EXPECT_FALSE(continuation(aside->problem(), plan.path, late.driven));
  // A path of arcs.
  Path arcs;
  arcs.pieces.push_back({Arc{make_pose({0, 0}, 0.0), 0.2, 2.0}, 1});
  EXPECT_FALSE(continuation(docking.problem(), arcs, 0.5));
}

TEST(MovingStart, BackwardsThePatternBeginsInMotion) {
  Scenario scenario = fixture::station(Id::d1, {5.0, 5.0, 1.0});
  scenario.vehicle.limits.curvature_rate = 1.5;
  for (const StartMotion motion : {StartMotion{-0.8, 0.0}, StartMotion{-0.8, 0.2}, StartMotion{-0.3, -0.35}, StartMotion{-0.003, 0.1}}) {
    scenario.start_motion = motion;
    const Docking docking = ready(scenario);
    const DockingPlan plan = docking.plan();
    takes_over(docking, plan, {0.0, scenario.start, motion}, "backwards");
    EXPECT_TRUE(plan.in_motion);
    EXPECT_EQ(plan.path.pieces.size(), 2U);
  }
}

TEST(MovingStart, ForwardsItStopsFirst) {
  Scenario scenario = fixture::station(Id::d1, {5.0, 5.0, 1.0});
  for (const double curvature : {0.0, 0.3, -0.3}) {
    scenario.start_motion = {0.6, curvature};
    const Docking docking = ready(scenario);
    const DockingPlan plan = docking.plan();
    takes_over(docking, plan, {0.0, scenario.start, scenario.start_motion}, "forwards");
    EXPECT_FALSE(plan.in_motion);
    ASSERT_EQ(plan.path.pieces.size(), 3U);
    EXPECT_EQ(plan.path.pieces[0].direction, 1);
    EXPECT_NEAR(length(plan.path.pieces[0]), 0.6 * 0.6 / (2.0 * scenario.vehicle.limits.deceleration), 1e-6);
    EXPECT_EQ(start_curvature(plan.path.pieces[0]), curvature);
  }
}

TEST(MovingStart, WhatIsOverTheVehiclesLimitsIsSaidSo) {
  Scenario scenario = fixture::station(Id::d0);
  scenario.vehicle.limits.lateral_acceleration = 0.2;
  const auto refused = [&](StartMotion motion) {
    scenario.start_motion = motion;
    const auto docking = Docking::prepare(scenario);
    return docking ? docking->plan().reason : docking.error().field;
  };
  EXPECT_EQ(refused({5.0, 0.0}), "start.speed");
  EXPECT_EQ(refused({-5.0, 0.0}), "start.speed");
  EXPECT_EQ(refused({0.5, 2.0}), "start.curvature");
  EXPECT_NE(refused({-0.9, 0.6}).find("lateral acceleration"), std::string::npos);
  std::get<Station>(scenario.mission).manoeuvre = Manoeuvre::undock;
  EXPECT_EQ(refused({0.5, 0.0}), "start.speed");
}

// Close to the station's wall there is no room to stop, and the pattern begins in motion all the same; forwards there is none at all.
TEST(MovingStart, WithoutRoomToStopThereIsNoPlan) {
  Scenario scenario = fixture::station(Id::d0);
  scenario.start = {9.9, 0.0, 0.0};  // 0.2 m from the wall behind the forks
  scenario.start_motion = {0.9, 0.0};
  const DockingPlan plan = ready(scenario).plan();
  EXPECT_NE(plan.status, Status::solved);
}

}  // namespace
}  // namespace waywright
