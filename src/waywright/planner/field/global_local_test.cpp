// The planner `global_local`: without what moves as near to the global way as that can be driven; among what moves proven in time, or honest about it.
#include "waywright/planner/field/global_local.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
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

TEST(GlobalLocalPlanner, ACrowdIsPassedOrToldOf) {
  int solved = 0, by_field = 0, wanted = 0;
  const int most = std::getenv("GL_CROWDS") != nullptr ? std::atoi(std::getenv("GL_CROWDS")) : 20;
  double seconds = 0.0;
  for (int seed = 0; seed < most; ++seed) {
    Random random{static_cast<std::uint64_t>(1000 + seed)};
    Scenario s = hall(10.0, 14.0, seed % 3 == 0 ? differential(true) : seed % 3 == 1 ? mecanum() : differential(false), {1.0, random.uniform(1.5, 8.5), 0.0}, {13.0, random.uniform(1.5, 8.5), random.uniform(-3.0, 3.0)});
    for (int k = 0; k < 3; ++k) {
      const Vec2 at{random.uniform(3.5, 9.5), random.uniform(1.5, 7.5)};
      s.map.obstacles.push_back(rectangle(at, at + Vec2{random.uniform(0.3, 1.5), random.uniform(0.3, 1.5)}));
    }
    for (int k = 0; k < 8; ++k) {
      Vec2 from{};
      do {
        from = {random.uniform(1.0, 13.0), random.uniform(0.5, 9.5)};
      } while (distance(from, s.start.position()) < 2.5);
      s.moving.push_back(walker({{0.0, make_pose(from, 0.0)}}, random.uniform(0.2, 1.2) * unit(random.uniform(-3.14, 3.14)), random.uniform(0.2, 0.4)));
      if (k % 4 == 3) s.moving.back().footprint = {rectangle({-0.4, -0.3}, {0.4, 0.3}), 0.0};
    }
    const auto begin = std::chrono::steady_clock::now();
    if (std::getenv("GL_PRINT") != nullptr) std::cout << "seed " << seed << "\n";
    const Result result = planned(s);
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    seconds += took;
    if (std::getenv("GL_PRINT") != nullptr) std::cout << "  took " << took << "\n";
    ++wanted;
    if (result.plan.status == Status::solved) {
      ++solved;
      by_field += result.is_by_field ? 1 : 0;
      expect_sound(result.plan);
    } else {
      EXPECT_FALSE(result.plan.reason.empty());
    }
  }
  std::cout << "solved " << solved << " of " << wanted << ", by the field " << by_field << ", mean " << seconds / wanted << " s\n";
  EXPECT_GE(solved, wanted * 3 / 4);
}

}  // namespace
}  // namespace waywright
