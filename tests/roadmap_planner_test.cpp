// Roadmap planners on whole scenarios: proven, no shorter than the bound, the same however they were prepared, refused with a sentence where they must be.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <map>
#include <thread>

#include "tests/grid_scenarios.hpp"
#include "waywright/geometry/polygon.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/plane/plane_space.hpp"
#include "waywright/planner/registry.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/roadmap/prm_planner.hpp"
#include "waywright/planner/roadmap/voronoi_planner.hpp"

namespace waywright {
namespace {

using test::hall;
using test::planned;

const std::vector<std::pair<std::string, Parameters>>& roadmaps() {
  static const std::vector<std::pair<std::string, Parameters>> all{
      {"prm", {}},
      {"prm", {{"neighbours", 15.0}, {"samples", 1500.0}, {"shorten", false}}},
      {"voronoi", {}},
      {"voronoi", {{"clearance_weight", 1.0}}},
      {"voronoi", {{"shorten", true}}},
  };
  return all;
}

TEST(RoadmapPlanners, EveryPathIsProvenAndNoneIsShorterThanTheBound) {
  Random random{43};
  std::map<std::string, int> solved;
  int halls = 0, curves = 0, reached = 0;
  for (int i = 0; i < 24; ++i) {
    const Footprint footprint = i % 3 == 2 ? Footprint{{{-0.3, -0.25}, {0.5, -0.25}, {0.5, 0.25}, {-0.3, 0.25}}, 0.0} : i % 3 == 1 ? Footprint{{}, 0.02} : test::disc;
    Scenario s = hall(random, footprint, i % 2 == 0 ? 0.05 : 0.0, 4 + i % 9);
    if (i % 4 == 3) s.map.boundaries.clear();
    if (i % 6 == 5) s.vehicle.limits.curvature_rate = 2.0;  // no curvature jumps: parabolas are driven along chords
    const Problem problem = Problem::prepare(s).value();
    if (problem.check_ends()) continue;
    ++halls;
    const PlaneSpace space{problem};
    Budget budget;
    const LeastLength least = least_length(space, budget);
    const bool is_reached = planned(s, "visibility_graph").status == Status::solved;
    reached += is_reached ? 1 : 0;
    for (const auto& [name, parameters] : roadmaps()) {
      const Plan plan = planned(s, name, parameters);
      ASSERT_TRUE(plan.status == Status::solved || plan.status == Status::no_path) << name << " " << i << ": " << plan.reason;
      EXPECT_FALSE(plan.explanation.empty() && plan.reason.empty());
      if (plan.status != Status::solved) {
        EXPECT_TRUE(plan.path.pieces.empty()) << name << " " << i << ": " << plan.reason;
        continue;
      }
      ++solved[name];
      EXPECT_TRUE(is_reached) << name << " " << i;
      EXPECT_GE(plan.metrics.length, least.metres - 1e-6) << name << " " << i;
      EXPECT_TRUE(verify(plan).value().holds) << name << " " << i;
      for (const Piece& piece : plan.path.pieces) curves += std::holds_alternative<Spline>(piece.curve) ? 1 : 0;
    }
  }
  EXPECT_GT(halls, 18);
  EXPECT_GT(curves, 50);
  EXPECT_GT(solved["prm"], reached);  // of twice as many
  EXPECT_GE(solved["voronoi"], 3 * reached - 3);
}

TEST(RoadmapPlanners, AShutDoorIsNamedAsNoWayAtAll) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {10, 6})};
  s.map.obstacles = {rectangle({4, 0}, {5, 2.5}), rectangle({4, 3.0}, {5, 6})};  // a gap of 0.5 m
  s.vehicle.footprint = test::disc;
  s.vehicle.drive = Differential{0.4};
  s.start = {1, 1, 0};
  s.mission = Pose{9, 5, 0};
  for (const auto& [name, parameters] : roadmaps()) {
    const Plan plan = planned(s, name, parameters);
    EXPECT_EQ(plan.status, Status::no_path) << name;
    EXPECT_NE(plan.reason.find("none at all"), std::string::npos) << name << ": " << plan.reason;
  }
  s.vehicle.footprint.disc = 0.2;
  for (const auto& [name, parameters] : roadmaps()) EXPECT_EQ(planned(s, name, parameters).status, Status::solved) << name;
}

TEST(RoadmapPlanners, GoalsThatLeaveTheHeadingFree) {
  Random random{8};
  Scenario s = hall(random, test::disc, 0.02, 6);
  s.start = {0.5, 0.5, 0.0};
  s.map.obstacles.erase(s.map.obstacles.begin(), s.map.obstacles.begin() + 3);
  for (const Ring& area : {Ring{{11.0, 8.0}}, rectangle({10.5, 7.5}, {11.5, 8.5})}) {
    s.mission = FreeGoal{area};
    for (const auto& [name, parameters] : roadmaps()) {
      const Plan plan = planned(s, name, parameters);
      ASSERT_EQ(plan.status, Status::solved) << name << ": " << plan.reason;
      const Vec2 end{plan.samples.back().x, plan.samples.back().y};
      EXPECT_LT(distance(end, area.size() == 1 ? area.front() : nearest_in(area, end)), 1e-6) << name;
      EXPECT_TRUE(verify(plan).value().holds);
    }
  }
}

TEST(RoadmapPlanners, TheSameWhetherPreparedOrNot) {
  Random random{12};
  const Problem problem = Problem::prepare(hall(random, test::disc, 0.02, 6)).value();
  const auto compare = [&](const AnyPlanner& planner) {
    Budget a, b;
    const PlanningResult once = planner.plan(problem, a), again = planner.prepared(problem).plan(problem, b);
    ASSERT_TRUE(once && again);
    EXPECT_EQ(once->explanation, again->explanation);
    EXPECT_EQ(once->path.pieces.size(), again->path.pieces.size());
    EXPECT_EQ(length(once->path), length(again->path));
    EXPECT_EQ(a.evaluations(), b.evaluations());
    EXPECT_EQ(a.expansions(), b.expansions());
  };
  compare(PrmPlanner{{}, 5});
  compare(VoronoiPlanner{{}});
}

TEST(RoadmapPlanners, LessWorkIsDoneWhereLessIsAllowed) {
  Random random{12};
  Scenario s = hall(random, test::disc, 0.02, 8);
  s.budget.samples = 60;
  const Plan few = planned(s, "prm");
  EXPECT_NE((few.reason + few.explanation.front()).find("60 places"), std::string::npos) << few.reason << few.explanation.front();
  s.budget.samples.reset();
  s.budget.evaluations = 3;
  EXPECT_LE(planned(s, "prm").effort.evaluations, 3);
}

TEST(RoadmapPlanners, AFlagEndsARoadmapThatGrows) {
  Random random{12};
  Scenario s = hall(random, test::disc, 0.02, 8);
  s.planner = {"prm", {{"samples", 100'000.0}, {"neighbours", 100.0}}};  // many seconds
  const Problem problem = Problem::prepare(s).value();
  std::atomic<bool> cancel{false};
  std::chrono::steady_clock::time_point raised;
  std::thread other{[&] {
    std::this_thread::sleep_for(std::chrono::milliseconds{100});
    raised = std::chrono::steady_clock::now();
    cancel = true;
  }};
  const Plan plan = *solve(problem, &cancel);
  other.join();
  EXPECT_EQ(plan.status, Status::canceled);
  EXPECT_LT(std::chrono::steady_clock::now() - raised, std::chrono::seconds{1});
  s.budget.seconds = 0.05;
  const Plan late = planned(s, "prm", s.planner.parameters);
  EXPECT_EQ(late.status, Status::timed_out);
  EXPECT_FALSE(late.reproducible);
}

TEST(RoadmapPlanners, MoreClearanceForItsWeightAndNoneLeftWhenPulledTaut) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {10, 6})};
  s.map.obstacles = {rectangle({2, 1.0}, {8, 4})};
  s.vehicle.footprint = {{}, 0.2};
  s.vehicle.drive = Differential{0.5};
  s.start = {0.5, 0.5, 0.0};
  s.mission = Pose{9.5, 0.5, 0.0};
  const Plan plain = planned(s, "voronoi"), taut = planned(s, "voronoi", {{"shorten", true}}), wide = planned(s, "voronoi", {{"clearance_weight", 50.0}});
  ASSERT_EQ(plain.status, Status::solved);
  ASSERT_EQ(taut.status, Status::solved);
  ASSERT_EQ(wide.status, Status::solved);
  EXPECT_LE(taut.metrics.length, plain.metrics.length);
  EXPECT_GT(wide.metrics.length, plain.metrics.length + 5.0);  // around the block
}

TEST(RoadmapPlanners, LargeMapsAreRefusedByNumber) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {400, 400})};
  for (int i = 0; i < 160; ++i) {
    for (int k = 0; k < 160; ++k) s.map.obstacles.push_back(rectangle({2.0 * i + 20, 2.0 * k + 20}, {2.0 * i + 20.5, 2.0 * k + 20.5}));
  }
  s.vehicle.footprint = test::disc;
  s.vehicle.drive = Differential{0.4};
  s.start = {1, 1, 0};
  s.mission = Pose{399, 399, 0};
  const Plan plan = planned(s, "voronoi");
  EXPECT_EQ(plan.status, Status::no_path);
  EXPECT_NE(plan.reason.find("102404 edges"), std::string::npos) << plan.reason;
}

}  // namespace
}  // namespace waywright
