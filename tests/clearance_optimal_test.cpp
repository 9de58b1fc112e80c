// `clearance_optimal` from problem to proven plan, for every kind of vehicle.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <thread>

#include "tests/outside_data.hpp"
#include "waywright/core/random.hpp"
#include "waywright/io/map_io.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {
namespace {

const std::filesystem::path root = WAYWRIGHT_SOURCE_DIR;

Plan planned(Scenario scenario, Parameters parameters = {}, const std::atomic<bool>* cancel = nullptr) {
  scenario.planner = {"clearance_optimal", std::move(parameters)};
  const auto problem = Problem::prepare(std::move(scenario));
  if (!problem) throw std::runtime_error{problem.error().message()};
  return *solve(*problem, cancel);
}

double cost_of(const Plan& plan) { return plan.alternatives.back().cost.value(); }
double cost_over_lattice(const Plan& plan) { return plan.alternatives.front().cost.value(); }

Vehicle vehicle_of(int kind) {
  Vehicle v;
  if (kind == 0) {
    v.footprint.polygon = {{-0.5, -0.3}, {0.9, -0.3}, {0.9, 0.3}, {-0.5, 0.3}};
    v.drive = Tricycle{0.9, 1.1, 0.8, SteeredAxle::rear};
    v.limits.curvature_rate = 3.0;
  } else if (kind == 1) {
    v.footprint.polygon = {{-0.5, -0.3}, {0.6, -0.3}, {0.6, 0.3}, {0.1, 0.05}, {-0.5, 0.3}};
    v.drive = Differential{0.5};
  } else {
    v.footprint.disc = 0.3;
    v.drive = Differential{0.5};
    v.limits.curvature = 1.5;
  }
  return v;
}

Scenario hall(Random& random, int kind, double clearance, int boxes) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {10, 8})};
  for (int i = 0; i < boxes; ++i) {
    const Ring box = rectangle({0, 0}, {random.uniform(0.2, 1.2), random.uniform(0.2, 1.2)});
    s.map.obstacles.push_back(transformed(box, Frame{make_pose({random.uniform(0, 9), random.uniform(0, 7)}, random.uniform(-1, 1))}));
  }
  s.vehicle = vehicle_of(kind);
  s.clearance = clearance;
  World world{s.map};
  world.build();
  const auto pose = [&] {
    for (int tries = 0; tries < 10'000; ++tries) {
      const Pose p{random.uniform(0.5, 9.5), random.uniform(0.5, 7.5), random.uniform(-3, 3)};
      if (world.clearance(s.vehicle.footprint, p, 1.0).clearance > clearance + 0.05) return p;
    }
    return Pose{};
  };
  s.start = pose();
  s.mission = pose();
  return s;
}

Scenario moved(Scenario s, const Frame& frame) {
  for (Ring& r : s.map.boundaries) r = transformed(r, frame);
  for (Ring& r : s.map.obstacles) r = transformed(r, frame);
  s.start = frame.to_world(s.start);
  s.mission = frame.to_world(std::get<Pose>(s.mission));
  return s;
}

// Forklift, notched robot, disc: the planner leaves the proof nothing to refuse.
TEST(ClearanceOptimal, EveryWayFoundIsProvenForEveryKindOfVehicle) {
  Random random{41};
  int solved = 0;
  for (int i = 0; i < 40; ++i) {
    Scenario s = hall(random, i % 3, i % 3 == 0 ? 0.0 : 0.05, 8);
    if (i % 5 == 0) s.pose_error = {0.01, 0.01, 0.01};
    const Plan plan = planned(s, {{"resolution", 0.2}});
    ASSERT_NE(plan.status, Status::unproven) << i << ": " << plan.reason;
    if (plan.status != Status::solved) {
      ASSERT_FALSE(plan.reason.empty());
      continue;
    }
    ++solved;
    EXPECT_LE(cost_of(plan), cost_over_lattice(plan) + 1e-12) << i;
    EXPECT_GE(cost_of(plan), plan.metrics.length - 1e-9) << i;
    if (i % 4 == 0) {
      const Plan read = parse_plan(plan_json(plan), "plan.json").value();
      EXPECT_TRUE(verify(read)->holds) << i;
    }
  }
  EXPECT_GE(solved, 32);
}

// The lattice lies where the start is, and clearances are exact: nothing depends on where the map is.
TEST(ClearanceOptimal, CostsTheSameWhereverTheMapLies) {
  Random random{43};
  int compared = 0;
  for (int i = 0; i < 12; ++i) {
    const Scenario s = hall(random, i % 3, 0.03, 6);
    const Frame frame{{random.uniform(-200, 200), random.uniform(-200, 200), random.uniform(-3, 3)}};
    const Plan here = planned(s, {{"resolution", 0.25}}), there = planned(moved(s, frame), {{"resolution", 0.25}});
    ASSERT_EQ(here.status, there.status) << i;
    if (here.status != Status::solved) continue;
    ++compared;
    EXPECT_NEAR(cost_over_lattice(here), cost_over_lattice(there), 1e-6 * cost_over_lattice(here)) << i;
  }
  EXPECT_GE(compared, 9);
}

TEST(ClearanceOptimal, PlansIntoTheStationsOfTheExamples) {
  for (const char* name : {"dock_left", "dock_cluttered", "dock_insertion", "undock_loaded", "dock_rotated", "dock_moving"}) {
    auto scenario = read_scenario((root / "examples" / (std::string{name} + ".json")).string());
    ASSERT_TRUE(scenario) << name;
    const Plan plan = planned(*scenario);
    ASSERT_EQ(plan.status, Status::solved) << name << ": " << plan.reason;
    EXPECT_LT(cost_of(plan), cost_over_lattice(plan)) << name;
  }
}

// In an empty hall the way is the vehicle's alone: no dearer than the lattice's, no shorter than the straight line.
TEST(ClearanceOptimal, StraightAheadIsStraight) {
  Scenario s;
  s.map.boundaries = {rectangle({-5, -5}, {15, 5})};
  s.vehicle = vehicle_of(0);
  s.start = {0, 0, 0};
  s.mission = Pose{10.03, 0, 0};
  const Plan plan = planned(s);
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  EXPECT_NEAR(plan.metrics.length, 10.03, 1e-9);
  EXPECT_EQ(plan.path.pieces.size(), 1U);
}

// Two ways past a wall: a short one through a narrow gap and a longer one around. Which is taken depends on what danger costs; both figures follow from the formula.
TEST(ClearanceOptimal, DangerDecidesBetweenAGapAndTheWayAround) {
  Scenario s;
  s.map.boundaries = {rectangle({0, -6}, {12, 6})};
  s.map.obstacles = {rectangle({5.5, 0.45}, {6.5, 2.5}), rectangle({5.5, -5.99}, {6.5, -0.45})};
  s.vehicle = vehicle_of(2);
  s.start = {2, 0, 0};
  s.mission = Pose{10, 0, 0};
  const auto plan = [&](double weight) { return planned(s, {{"danger_weight", weight}, {"danger_range", 0.5}, {"resolution", 0.1}}); };
  const Plan light = plan(0.5), heavy = plan(50.0);
  ASSERT_EQ(light.status, Status::solved) << light.reason;
  ASSERT_EQ(heavy.status, Status::solved) << heavy.reason;
  EXPECT_NEAR(light.metrics.length, 8.0, 1e-6);
  EXPECT_NEAR(light.metrics.min_clearance, 0.15, 1e-3);
  EXPECT_GT(heavy.metrics.length, 9.0);
  EXPECT_GT(heavy.metrics.min_clearance, 0.4);
  // Within the gap c is 0.15 for a metre; before and behind it grows with the distance to the corners: ∫ over both sides by the midpoint rule.
  double danger = 0.5 * std::pow(1.0 - 0.15 / 0.5, 2);
  constexpr int n = 20000;
  for (int k = 0; k < n; ++k) {
    const double x = 1.0 * (k + 0.5) / n, c = std::hypot(x, 0.45) - 0.3;
    if (c < 0.5) danger += 2.0 * 0.5 * std::pow(1.0 - c / 0.5, 2) / n;
  }
  EXPECT_NEAR(cost_of(light), 8.0 + danger, 2e-3);
}

// Real maps, read in place: halls with ragged walls, unknown cells, rotated origins; a forklift and a robot.
TEST(ClearanceOptimal, RealMapsArePlannedOnAndProven) {
  const auto folder = test::outside_data("ros_maps");
  if (!folder) GTEST_SKIP() << test::no_outside_data;
  Random random{13};
  for (const char* name : {"nav2/depot.yaml", "ipa_factory/map.yaml", "aws_hospital/hospital.yaml", "stata_basement/stata_basement.yaml", "nav2/warehouse.yaml"}) {
    SCOPED_TRACE(name);
    Scenario s;
    s.map = read_map(*folder / name).value();
    s.clearance = 0.05;
    const World world{s.map};
    World built = world;
    built.build();
    const CellGrid& grid = s.map.grids.front();
    int solved = 0;
    for (const int kind : {0, 1, 2}) {
      s.vehicle = vehicle_of(kind);
      const auto pose = [&] {
        for (;;) {
          const Pose p = make_pose(grid.corner(random.uniform(0, grid.columns), random.uniform(0, grid.rows)), random.uniform(-3, 3));
          if (built.clearance(s.vehicle.footprint, p, 0.6).clearance > 0.3) return p;
        }
      };
      s.start = pose();
      do {
        s.mission = pose();
      } while (distance(s.start.position(), std::get<Pose>(s.mission).position()) > 12.0);
      s.planner = {"clearance_optimal", {{"gap", 0.2}}};
      const Plan plan = *solve(Problem::prepare(s, &world).value());
      EXPECT_NE(plan.status, Status::unproven) << plan.reason;
      EXPECT_TRUE(plan.status == Status::solved || plan.status == Status::no_path) << to_string(plan.status) << ": " << plan.reason;
      solved += plan.status == Status::solved ? 1 : 0;
    }
    EXPECT_GE(solved, 1);
  }
}

TEST(ClearanceOptimal, MoreWeightKeepsFartherAway) {
  Random random{47};
  double light = 0.0, heavy = 0.0, short_way = 0.0, long_way = 0.0;
  int compared = 0;
  for (int i = 0; i < 16; ++i) {
    const Scenario s = hall(random, i % 3, 0.02, 9);
    const Plan a = planned(s, {{"danger_weight", 0.0}, {"resolution", 0.25}}), b = planned(s, {{"danger_weight", 20.0}, {"resolution", 0.25}});
    if (a.status != Status::solved || b.status != Status::solved) continue;
    ++compared;
    light += a.metrics.mean_clearance;
    heavy += b.metrics.mean_clearance;
    short_way += a.metrics.length;
    long_way += b.metrics.length;
  }
  ASSERT_GE(compared, 10);
  EXPECT_GT(heavy, 1.05 * light);
  EXPECT_GE(long_way, short_way - 1e-9);
}

Scenario open_hall() {
  Scenario s;
  s.map.boundaries = {rectangle({0, -6}, {12, 6})};
  s.vehicle = vehicle_of(2);
  s.start = {2, 0, 0};
  s.mission = Pose{10, 0, 0};
  return s;
}

Zone zone(ZoneType type, Ring area, double value) {
  Zone z;
  z.type = type;
  z.area = std::move(area);
  (type == ZoneType::directed ? z.direction : z.factor) = value;
  return z;
}

// Straight on through a strip that costs thrice, 8 + 2·2 m; or around a strip that is too dear.
TEST(ClearanceOptimal, WeighsPenaltyZonesAgainstTheWayAround) {
  Scenario s = open_hall();
  s.zones = {zone(ZoneType::penalty, rectangle({5, -5.9}, {7, 5.9}), 3.0)};
  const Plan through = planned(s);
  ASSERT_EQ(through.status, Status::solved) << through.reason;
  EXPECT_NEAR(through.metrics.length, 8.0, 1e-6);
  EXPECT_NEAR(cost_of(through), 12.0, 1e-6);
  s.zones = {zone(ZoneType::penalty, rectangle({5, -1.0}, {7, 5.9}), 50.0)};
  const Plan around = planned(s);
  ASSERT_EQ(around.status, Status::solved) << around.reason;
  // No way is shorter than the taut one around the two corners.
  EXPECT_GE(around.metrics.length, 2.0 * std::hypot(3.0, 1.0) + 2.0 - 1e-9);
  EXPECT_LE(around.metrics.length, 2.0 * std::hypot(3.0, 1.0) + 2.0 + 0.6);
  EXPECT_NEAR(cost_of(around), around.metrics.length, 0.3);
}

TEST(ClearanceOptimal, PreferredLanesAttract) {
  Scenario s = open_hall();
  s.zones = {zone(ZoneType::preferred, rectangle({2, 1.5}, {10, 2.5}), 0.3)};
  const Plan plan = planned(s);
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  EXPECT_GT(plan.metrics.length, 8.5);
  EXPECT_LT(cost_of(plan), 8.0 - 1e-3);
}

TEST(ClearanceOptimal, KeepsToTheDirectionOfZones) {
  Scenario s = open_hall();
  s.zones = {zone(ZoneType::directed, rectangle({5, -2.0}, {7, 2.0}), pi)};
  const Plan around = planned(s);
  ASSERT_EQ(around.status, Status::solved) << around.reason;
  EXPECT_GE(around.metrics.length, 2.0 * std::hypot(3.0, 2.0) + 2.0 - 0.01);
  s.zones.front().direction = 0.3;
  EXPECT_NEAR(planned(s).metrics.length, 8.0, 1e-6);
}

// The way out of a station is planned as the way in and driven back: zones hold for how it is driven.
TEST(ClearanceOptimal, ZonesHoldForWaysThatAreDrivenBack) {
  Scenario s = read_scenario((root / "examples" / "undock_loaded.json").string()).value();
  const Plan without = planned(s);
  ASSERT_EQ(without.status, Status::solved) << without.reason;
  for (const double direction : {0.0, pi}) {
    s.zones = {zone(ZoneType::directed, rectangle({4, 5}, {6, 9}), direction)};
    const Plan plan = planned(s);
    EXPECT_EQ(plan.status, Status::solved) << direction << ": " << plan.reason;
  }
}

// A footprint far before its origin: the disc about the origin says nothing of what it needs.
TEST(ClearanceOptimal, FootprintsMayLieBesideTheirOrigin) {
  Scenario s = open_hall();
  s.vehicle.footprint = {{{0.8, -0.2}, {1.6, -0.2}, {1.6, 0.2}, {0.8, 0.2}}, 0.0};
  s.clearance = 0.2;
  s.start = {0.1, 0, 0};
  s.mission = Pose{6, 1, 0};
  const Plan plan = planned(s);
  EXPECT_EQ(plan.status, Status::solved) << plan.reason;
}

// The goal has half a millimetre more than is required: the margin of the ends is that of the proof.
TEST(ClearanceOptimal, EndsMayBeAsTightAsTheProofAllows) {
  Scenario s = open_hall();
  s.clearance = 0.05;
  s.mission = Pose{12.0 - 0.3 - 0.0505, 0, 0.5 * pi};
  const Plan plan = planned(s);
  EXPECT_EQ(plan.status, Status::solved) << plan.reason;
}

TEST(ClearanceOptimal, WhatCannotBeReachedIsKnownWithoutASearchAndLimitsAreKept) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {12, 6})};
  s.map.obstacles = {rectangle({5.5, 0.01}, {6.5, 5.99})};
  s.vehicle = vehicle_of(0);
  s.start = {2, 3, 0};
  s.mission = Pose{10, 3, 0};
  const Plan walled = planned(s);
  EXPECT_EQ(walled.status, Status::no_path);
  EXPECT_EQ(walled.effort.expansions, 0);
  EXPECT_NE(walled.reason.find("known without a search"), std::string::npos) << walled.reason;

  s.map.obstacles.clear();
  s.budget.expansions = 3;
  const Plan few = planned(s);
  EXPECT_EQ(few.status, Status::timed_out);
  EXPECT_TRUE(few.reproducible);
  EXPECT_LE(few.effort.expansions, 3);
  s.budget = {};

  const std::atomic<bool> raised{true};
  EXPECT_EQ(planned(s, {}, &raised).status, Status::canceled);

  s.map.boundaries = {rectangle({0, 0}, {4000, 4000})};
  s.planner = {"clearance_optimal", {{"resolution", 0.05}}};
  const Problem fine = Problem::prepare(s).value();
  const auto refused = solve(fine);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "planner.resolution");
  EXPECT_NE(refused.error().problem.find("coarser resolution"), std::string::npos) << refused.error().problem;
}

TEST(ClearanceOptimal, NeverBackwardsWhereThatIsNotAllowed) {
  Random random{53};
  int solved = 0;
  for (int i = 0; i < 10; ++i) {
    const Plan plan = planned(hall(random, 0, 0.03, 5), {{"reverse_cost", 0.0}, {"resolution", 0.2}});
    if (plan.status != Status::solved) continue;
    ++solved;
    for (const Piece& p : plan.path.pieces) EXPECT_GE(p.direction, 0);
  }
  EXPECT_GE(solved, 5);
}

TEST(ClearanceOptimal, ManyThreadsOnOnePreparedProblemGiveTheSameBits) {
  Random random{59};
  Scenario s = hall(random, 0, 0.03, 6);
  s.planner = {"clearance_optimal", {{"resolution", 0.2}}};
  const Problem problem = Problem::prepare(s).value();
  const auto parameters = complete_parameters(s.planner);
  ASSERT_TRUE(parameters);
  const AnyPlanner planner = find_planner("clearance_optimal")->make(*parameters, 1).prepared(problem);
  std::vector<Path> paths(4);
  std::vector<std::thread> threads;
  for (Path& path : paths) {
    threads.emplace_back([&] {
      Budget budget;
      if (auto result = planner.plan(problem, budget)) path = result->path;
    });
  }
  for (std::thread& t : threads) t.join();
  ASSERT_FALSE(paths[0].pieces.empty());
  for (const Path& path : paths) {
    ASSERT_EQ(path.pieces.size(), paths[0].pieces.size());
    EXPECT_EQ(length(path), length(paths[0]));
    EXPECT_EQ(end_pose(path), end_pose(paths[0]));
  }
}

}  // namespace
}  // namespace waywright
