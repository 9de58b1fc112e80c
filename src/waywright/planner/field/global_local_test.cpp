// The planner `global_local`: without what moves as near to the global way as that can be driven; among what moves proven in time, or honest about it.
#include "waywright/planner/field/global_local.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iostream>

#include "tests/moving_oracle.hpp"
#include "waywright/core/random.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/map/field_worlds.hpp"
#include "waywright/proof/moving_clearance.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

Vehicle mecanum() {
  Vehicle v;
  v.footprint = {rectangle({-0.29, -0.19}, {0.29, 0.19}), 0.0};
  v.drive = Mecanum{0.0475, 0.235, 0.15};
  v.limits.speed = v.limits.reverse_speed = 0.8;
  v.limits.acceleration = v.limits.deceleration = 1.0;
  v.limits.lateral_acceleration = 1.0;
  v.limits.angular_speed = 1.5;
  v.limits.angular_acceleration = 3.0;
  return v;
}
Vehicle differential(bool is_smooth) {
  Vehicle v;
  v.footprint = {{}, 0.35};
  v.drive = Differential{0.45};
  v.limits.speed = 1.2;
  v.limits.acceleration = v.limits.deceleration = 1.0;
  v.limits.angular_speed = 1.5;
  if (is_smooth) v.limits.angular_acceleration = 2.0;
  return v;
}

MovingObstacle walker(std::vector<MovingObstacle::Place> track, Vec2 velocity = {}, double radius = 0.3) {
  MovingObstacle obstacle;
  obstacle.name = "person";
  obstacle.footprint = {{}, radius};
  obstacle.track = std::move(track);
  obstacle.velocity = velocity;
  return obstacle;
}

Scenario hall(double width, double length, Vehicle vehicle, Pose start, Pose goal) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {length, width})};
  s.vehicle = std::move(vehicle);
  s.start = start;
  s.mission = goal;
  return s;
}

struct Result {
  Plan plan;
  bool is_by_field = false;
};

Result planned(Scenario s, const GlobalLocalOptions& options = {}) {
  s.planner.name = "global_local";
  const Problem problem = Problem::prepare(std::move(s)).value();
  Budget budget;
  PlanningResult result = GlobalLocalPlanner{options}.prepared(problem).plan(problem, budget);
  if (!result) return {failed_plan(problem, result.error().failure), false};
  const bool is_by_field = result->pace.has_value();
  Plan plan = judge(problem, problem.whole_path(std::move(result->path)), nullptr, {}, result->pace ? &*result->pace : nullptr);
  plan.explanation = std::move(result->explanation);
  plan.alternatives = std::move(result->alternatives);
  if (std::getenv("GL_PRINT") != nullptr) {
    for (const std::string& line : plan.explanation) std::cout << "  " << line << "\n";
    std::cout << "  -> " << to_string(plan.status) << " " << plan.reason << " t " << plan.metrics.travel_time << " L " << plan.metrics.length << " pieces " << plan.path.pieces.size() << "\n";
  }
  return {std::move(plan), is_by_field};
}

bool says(const Plan& plan, const std::string& words) {
  return std::any_of(plan.explanation.begin(), plan.explanation.end(), [&](const std::string& s) { return s.find(words) != std::string::npos; });
}

/// Proven, verified from its own samples, and found free at single times by an oracle that shares nothing with it.
void expect_sound(const Plan& plan) {
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  const Problem problem = Problem::prepare(plan.scenario).value();
  const Verification verification = verify(problem, plan);
  EXPECT_TRUE(verification.holds) << verification.findings.front();
  if (!plan.scenario.moving.empty()) {
    EXPECT_GT(oracle::least_in_time(plan, plan.scenario.vehicle.footprint, 0.01), plan.scenario.clearance);
  }
}

const std::vector<std::pair<const char*, std::size_t>> worlds{{"APF-1", 0}, {"APF-2", 0}, {"APF-2", 1}, {"APF-2", 2}, {"NF-TWO", 0}, {"NF-TWO", 1}, {"NF-S3", 0}, {"NF-S3", 1}, {"NF-ST", 0}, {"NF-ST", 1}};

Scenario world(const char* name, std::size_t task) {
  FieldWorld w = field_world(name).value();
  Scenario s;
  s.map = std::move(w.map);
  s.vehicle = mecanum();
  s.vehicle.footprint = {{}, 0.0};
  s.start = make_pose(w.tasks[task].start, 0.0);
  s.mission = make_pose(w.tasks[task].goal, 0.0);
  return s;
}

// The trap of APF-2 and that of NF-TWO among them.
TEST(GlobalLocalPlanner, ReachesTheGoalInEveryWorldOfThePublication) {
  for (const auto& [name, task] : worlds) {
    for (const bool faces_along : {false, true}) {
      Scenario s = world(name, task);
      if (faces_along) {
        s.vehicle = differential(true);
        s.vehicle.footprint = {{}, 0.0};
      }
      if (std::getenv("GL_PRINT") != nullptr) std::cout << name << " " << task << (faces_along ? " differential" : " mecanum") << "\n";
      const Result result = planned(s);
      expect_sound(result.plan);
      EXPECT_FALSE(says(result.plan, "came to no end")) << name << task;
    }
  }
}

/// A hall of 14 × 10 m with three boxes in it, and discs and rectangles that go straight through it all.
Scenario crowd(std::uint64_t seed, int people) {
  Random random{1000 + seed};
  Scenario s = hall(10.0, 14.0, seed % 3 == 0 ? differential(true) : seed % 3 == 1 ? mecanum() : differential(false), {1.0, random.uniform(1.5, 8.5), 0.0}, {13.0, random.uniform(1.5, 8.5), random.uniform(-3.0, 3.0)});
  for (int k = 0; k < 3; ++k) {
    const Vec2 at{random.uniform(3.5, 9.5), random.uniform(1.5, 7.5)};
    s.map.obstacles.push_back(rectangle(at, at + Vec2{random.uniform(0.3, 1.5), random.uniform(0.3, 1.5)}));
  }
  for (int k = 0; k < people; ++k) {
    Vec2 from{};
    do {
      from = {random.uniform(1.0, 13.0), random.uniform(0.5, 9.5)};
    } while (distance(from, s.start.position()) < 2.0);
    s.moving.push_back(walker({{0.0, make_pose(from, random.uniform(-3.0, 3.0))}}, random.uniform(0.2, 1.2) * unit(random.uniform(-3.14, 3.14)), random.uniform(0.2, 0.4)));
    if (k % 4 == 3) s.moving.back().footprint = {rectangle({-0.4, -0.3}, {0.4, 0.3}), 0.0};
    if (k % 5 == 4) {  // to and fro
      const Vec2 to{random.uniform(1.0, 13.0), random.uniform(0.5, 9.5)};
      s.moving.back().track = {{0.0, make_pose(from, 0.0)}, {8.0, make_pose(to, 2.0)}, {12.0, make_pose(to, -2.0)}, {20.0, make_pose(from, 1.0)}};
      s.moving.back().velocity = {};
    }
  }
  if (seed % 4 == 3) s.clearance = 0.05;
  if (seed % 5 == 4) s.pose_error = {0.01, 0.01, 0.005};
  if (seed % 7 == 6) s.moving.front().spread = 0.02;
  return s;
}

struct Tally {
  int solved = 0, by_field = 0;
  double seconds = 0.0, metres = 0.0;  // driven, where solved
};
Tally crowds(int seeds, int people) {
  Tally tally;
  double seconds = 0.0, worst = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    if (std::getenv("GL_PRINT") != nullptr) std::cout << "seed " << seed << "\n";
    const auto begin = std::clock();
    const Result result = planned(crowd(static_cast<std::uint64_t>(seed), people));
    const double took = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    seconds += took;
    worst = std::max(worst, took);
    if (result.plan.status == Status::solved) {
      ++tally.solved;
      tally.by_field += result.is_by_field ? 1 : 0;
      tally.seconds += result.plan.metrics.travel_time;
      tally.metres += result.plan.metrics.length;
      if (std::getenv("GL_QUICK") == nullptr) expect_sound(result.plan);
    } else {
      EXPECT_FALSE(result.plan.reason.empty());
    }
  }
  std::cout << people << " that move: solved " << tally.solved << " of " << seeds << ", by the field " << tally.by_field << "; driven " << tally.metres / tally.solved << " m in " << tally.seconds / tally.solved << " s; " << seconds / seeds << " s a plan and proof, at most " << worst << " s\n";
  return tally;
}

TEST(GlobalLocalPlanner, ACrowdIsPassedOrToldOf) {
  const Tally few = crowds(12, 8), many = crowds(6, 25);
  EXPECT_GE(few.solved, 11);
  EXPECT_GE(many.solved, 3);
}

TEST(GlobalLocalPlanner, FullCrowdsOfAHundredSeeds) {
  for (const int people : {8, 16, 25, 40}) {
    const Tally tally = crowds(100, people);
    EXPECT_GE(tally.solved, people == 8 ? 99 : 50) << people;
  }
}

/// A corridor along x, `wide` m between its walls; closed behind the start, or open to a room there.
Scenario corridor(double wide, bool is_closed, std::vector<MovingObstacle> moving) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {20, 8})};
  const double low = 4.0 - 0.5 * wide, high = 4.0 + 0.5 * wide, begins = is_closed ? 0.0 : 5.0;
  s.map.obstacles = {rectangle({begins, 0}, {20, low}), rectangle({begins, high}, {20, 8})};
  s.vehicle = mecanum();
  s.start = {is_closed ? 1.0 : 6.0, 4.0, 0.0};
  s.mission = Pose{19.0, 4.0, 0.0};
  s.moving = std::move(moving);
  return s;
}

TEST(GlobalLocalPlanner, GivesWayToWhatCrosses) {
  for (const double begin : {1.0, 2.0, 3.0, 4.0, 5.0}) {
    const Result result = planned(hall(10.0, 14.0, mecanum(), {1, 5, 0}, {13, 5, 0}));
    Scenario s = hall(10.0, 14.0, mecanum(), {1, 5, 0}, {13, 5, 0});
    s.moving = {walker({{begin, {7, 0.5, 0}}, {begin + 9.0, {7, 9.5, 0}}})};
    const Result crossed = planned(s);
    expect_sound(crossed.plan);
    EXPECT_TRUE(crossed.is_by_field);
    EXPECT_LT(crossed.plan.metrics.travel_time, result.plan.metrics.travel_time + 6.0);
  }
}

TEST(GlobalLocalPlanner, PassesWhatComesToMeetItWhereThereIsRoom) {
  const Result result = planned(corridor(2.6, true, {walker({{0.0, {19.0, 4.0, 0.0}}}, {-0.8, 0.0})}));
  expect_sound(result.plan);
  EXPECT_TRUE(result.is_by_field);
  EXPECT_TRUE(result.plan.waits.empty());
  EXPECT_LT(result.plan.metrics.travel_time, 18.0 / 0.8 + 5.0);
}

TEST(GlobalLocalPlanner, IsOvertakenAndOvertakes) {
  const Result overtaken = planned(corridor(2.6, false, {walker({{0.0, {1.0, 4.0, 0.0}}}, {1.4, 0.0})}));
  expect_sound(overtaken.plan);
  EXPECT_TRUE(overtaken.is_by_field);
  const Result overtakes = planned(corridor(2.6, true, {walker({{0.0, {4.0, 4.0, 0.0}}}, {0.25, 0.0})}));
  expect_sound(overtakes.plan);
  EXPECT_TRUE(overtakes.is_by_field);
  EXPECT_LT(overtakes.plan.metrics.travel_time, 18.0 / 0.8 + 6.0);  // the other one needs a minute
}

TEST(GlobalLocalPlanner, GoesBackOutOfACorridorWithoutRoom) {
  const Result result = planned(corridor(1.2, false, {walker({{0.0, {19.0, 4.0, 0.0}}, {30.0, {2.0, 4.0, 0.0}}, {40.0, {2.0, 1.0, 0.0}}})}));
  expect_sound(result.plan);
  EXPECT_TRUE(result.is_by_field);
}

TEST(GlobalLocalPlanner, SaysWhereItIsMetInACorridorWithoutRoomOrWayBack) {
  const Result result = planned(corridor(1.2, true, {walker({{0.0, {19.0, 4.0, 0.0}}}, {-0.5, 0.0})}));
  EXPECT_EQ(result.plan.status, Status::unproven);
  EXPECT_TRUE(says(result.plan, "person comes too near to the vehicle")) << result.plan.explanation.back();
  EXPECT_FALSE(result.plan.path.pieces.empty());
}

TEST(GlobalLocalPlanner, FollowsEveryKindOfGlobalWay) {
  struct Case {
    GlobalWay global;
    const char* name;
    const char* world;
  };
  for (const Case& c : {Case{GlobalWay::harmonic, "harmonic", "APF-2"}, Case{GlobalWay::wavefront, "wavefront", "APF-2"}, Case{GlobalWay::visibility, "visibility_graph", "APF-2"},
                        Case{GlobalWay::navigation, "navigation_function", "NF-S3"}, Case{GlobalWay::star_navigation, "star_navigation", "NF-ST"}}) {
    Scenario s = world(c.world, 0);
    s.moving = {walker({{0.0, make_pose(std::get<Pose>(s.mission).position() - Vec2{0.5, 0.0}, 0.0)}}, {-0.4, -0.2})};
    GlobalLocalOptions options;
    options.global = c.global;
    const Result result = planned(s, options);
    expect_sound(result.plan);
    EXPECT_TRUE(result.is_by_field) << c.name;
    EXPECT_TRUE(says(result.plan, c.name)) << c.name;
  }
  GlobalLocalOptions discs;  // what the global way cannot do is told as it tells it
  discs.global = GlobalWay::navigation;
  const Plan refused = planned(world("APF-2", 0), discs).plan;
  EXPECT_EQ(refused.status, Status::no_path);
  EXPECT_NE(refused.reason.find("each obstacle in a disc"), std::string::npos) << refused.reason;
}

// Where it begins in motion, and where the disc around the footprint cannot stand at the ends: what is driven there takes its time, too.
TEST(GlobalLocalPlanner, KnowsWhenItsDriveBegins) {
  Scenario s = hall(8.0, 14.0, differential(true), {1, 4, 0}, {13, 4, 0});
  s.start_motion = {0.8, 0.0};
  s.moving = {walker({{0.0, {6.0, 0.5, 0.0}}}, {0.0, 0.6}), walker({{0.0, {12.0, 4.2, 0.0}}}, {-0.7, 0.0})};
  expect_sound(planned(s).plan);
  s.start_motion = {};
  s.vehicle = mecanum();
  s.start = {0.3, 4, 0};  // 1 cm from the wall behind it, where it cannot turn
  s.mission = Pose{13.7, 4, 0};
  const Result result = planned(s);
  expect_sound(result.plan);
  EXPECT_TRUE(result.is_by_field);
}

// A pace is never over the fastest profile, and stands where it is told to.
TEST(GlobalLocalPlanner, APaceIsKept) {
  Scenario s = hall(4.0, 14.0, mecanum(), {1, 2, 0}, {13, 2, 0});
  const Problem problem = Problem::prepare(s).value();
  Path path;
  path.pieces.push_back({Line{{1, 2}, {13, 2}}, 1, HeadingAlong{0.0, 0.0}});
  const std::vector<Sample> samples = sample(path, problem.footprint().radius(), 5e-4);
  Pace pace;
  pace.places = {{2.0, 0.5}, {4.0, 0.3}, {5.0, 0.3}};
  pace.waits = {{6.0, 40.0, 0}};
  std::vector<Sample> fastest = samples;
  assign_speed(fastest, problem.vehicle());
  const Timed timed = timed_at_pace(problem, samples, {}, pace);
  ASSERT_EQ(timed.samples.size(), samples.size() + 1);
  for (std::size_t i = 0, k = 0; i < timed.samples.size(); ++i) {
    const Sample& is = timed.samples[i];
    if (i > 0 && is.s == timed.samples[i - 1].s) {
      EXPECT_EQ(is.speed, 0.0);
      EXPECT_EQ(is.t, 40.0);
      EXPECT_NEAR(is.s, 6.0, 0.05);
      continue;
    }
    EXPECT_LE(is.speed, fastest[k++].speed);
    if (is.s >= 2.0 && is.s <= 4.0) {
      EXPECT_LE(is.speed, std::sqrt(0.25 + (0.09 - 0.25) * (is.s - 2.0) / 2.0) + 1e-9) << is.s;
    }
    if (is.s >= 4.0 && is.s <= 5.0) {
      EXPECT_NEAR(is.speed, 0.3, 1e-9);
    }
  }
  EXPECT_EQ(timed.samples.back().speed, 0.0);
}

TEST(GlobalLocalPlanner, GoesAroundWhatComesToStandInTheWay) {
  Scenario s = hall(6.0, 14.0, mecanum(), {1, 3, 0}, {13, 3, 0});
  s.map.obstacles = {rectangle({6.0, 2.2}, {8.0, 2.8})};
  MovingObstacle cart = walker({{0.0, {7.0, 5.5, 0.0}}, {5.0, {7.0, 4.2, 0.0}}});
  cart.footprint = {rectangle({-0.6, -1.7}, {0.6, 1.7}), 0.0};
  cart.patience = 3.0;
  s.moving = {cart};
  const Result result = planned(s);
  expect_sound(result.plan);
  EXPECT_TRUE(result.is_by_field);
}

}  // namespace
}  // namespace waywright
