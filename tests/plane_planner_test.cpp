// Planners in the plane on whole scenarios: proven, no shorter than the bound, honest where there is no way.
#include <gtest/gtest.h>

#include <map>

#include "tests/grid_scenarios.hpp"
#include "waywright/geometry/polygon.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/least_length.hpp"

namespace waywright {
namespace {

using test::hall;
using test::planned;

const std::vector<std::pair<std::string, Parameters>>& planners_in_the_plane() {
  static const std::vector<std::pair<std::string, Parameters>> all{
      {"visibility_graph", {}},
      {"rrt", {}},
      {"rrt_star", {{"iterations", 3000.0}}},
      {"rrt_star_woa_local", {{"iterations", 1000.0}}},
      {"rrt_star_woa_global", {{"iterations", 1000.0}}},
      {"rrt_star_woa_global", {{"iterations", 2000.0}, {"first_path", true}, {"radius", 1.5}, {"rounds", 0.0}, {"shorten", false}}},
  };
  return all;
}

TEST(PlanePlanners, EveryPathIsProvenAndNoneIsShorterThanTheBound) {
  Random random{41};
  std::map<std::string, int> solved;
  int halls = 0;
  for (int i = 0; i < 24; ++i) {
    const Footprint footprint = i % 3 == 2 ? Footprint{{{-0.3, -0.25}, {0.5, -0.25}, {0.5, 0.25}, {-0.3, 0.25}}, 0.0} : i % 3 == 1 ? Footprint{{}, 0.0} : test::disc;
    const Scenario s = hall(random, footprint, i % 2 == 0 ? 0.05 : 0.0, 4 + i % 9);
    const Problem problem = Problem::prepare(s).value();
    if (problem.check_ends()) continue;
    ++halls;
    const PlaneSpace space{problem};
    Budget budget;
    const LeastLength least = least_length(space, budget);
    double shortest = 0.0;
    for (const auto& [name, parameters] : planners_in_the_plane()) {
      const Plan plan = planned(s, name, parameters);
      ASSERT_TRUE(plan.status == Status::solved || plan.status == Status::no_path) << name << " " << i << ": " << plan.reason;
      EXPECT_FALSE(plan.explanation.empty() && plan.reason.empty());
      if (plan.status != Status::solved) continue;
      ++solved[name];
      EXPECT_FALSE(least.is_unreachable) << name << " " << i;
      EXPECT_GE(plan.metrics.length, least.metres - 1e-6) << name << " " << i;
      const Verification verification = verify(plan).value();
      EXPECT_TRUE(verification.holds) << name << " " << i;
      if (name == "visibility_graph") shortest = plan.metrics.length;
      // The disc's shortest way, up to the straight runs at ends where it cannot stand.
      if (shortest > 0.0 && space.is_free(problem.start().position()) && space.is_free(problem.goal().position())) {
        EXPECT_GE(plan.metrics.length, shortest * (1.0 - 2e-4)) << name << " " << i;
      }
    }
    for (const char* name : {"astar", "theta_star"}) {
      const Plan plan = planned(s, name);
      if (plan.status == Status::solved) {
        EXPECT_GE(plan.metrics.length, least.metres - 1e-6) << name << " " << i;
      }
    }
  }
  EXPECT_GT(halls, 18);
  for (const auto& [name, count] : solved) EXPECT_GT(count, halls / 2) << name;
  EXPECT_GE(solved["visibility_graph"], solved["rrt"]);
}

TEST(PlanePlanners, AShutDoorIsNamedAsNoWayAtAll) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {10, 6})};
  s.map.obstacles = {rectangle({4, 0}, {5, 2.5}), rectangle({4, 3.0}, {5, 6})};  // a gap of 0.5 m
  s.vehicle.footprint = test::disc;
  s.vehicle.drive = Differential{0.4};
  s.start = {1, 1, 0};
  s.mission = Pose{9, 5, 0};
  for (const auto& [name, parameters] : planners_in_the_plane()) {
    const Plan plan = planned(s, name, parameters);
    EXPECT_EQ(plan.status, Status::no_path) << name;
    EXPECT_NE(plan.reason.find("none at all"), std::string::npos) << name << ": " << plan.reason;
  }
  s.vehicle.footprint.disc = 0.1;
  for (const auto& [name, parameters] : planners_in_the_plane()) EXPECT_EQ(planned(s, name, parameters).status, Status::solved) << name;
}

TEST(PlanePlanners, GoalsThatLeaveTheHeadingFree) {
  Random random{8};
  Scenario s = hall(random, test::disc, 0.02, 6);
  s.start = {0.5, 0.5, 0.0};
  s.map.obstacles.erase(s.map.obstacles.begin(), s.map.obstacles.begin() + 3);
  for (const Ring& area : {Ring{{11.0, 8.0}}, rectangle({10.5, 7.5}, {11.5, 8.5})}) {
    s.mission = FreeGoal{area};
    for (const auto& [name, parameters] : planners_in_the_plane()) {
      const Plan plan = planned(s, name, parameters);
      ASSERT_EQ(plan.status, Status::solved) << name << ": " << plan.reason;
      const Vec2 end{plan.samples.back().x, plan.samples.back().y};
      EXPECT_LT(distance(end, area.size() == 1 ? area.front() : nearest_in(area, end)), 1e-6) << name;
      EXPECT_TRUE(verify(plan).value().holds);
    }
  }
}

TEST(PlanePlanners, TellHowTheSearchWent) {
  Random random{8};
  const Scenario s = hall(random, test::disc, 0.02, 4);
  const Plan plan = planned(s, "rrt_star", {{"iterations", 2000.0}});
  ASSERT_TRUE(plan.search);
  std::size_t there = 0;
  for (const SearchPicture::Line& line : plan.search->lines) {
    EXPECT_LE(line.born, line.gone);
    there += line.gone == SearchPicture::never ? 1 : 0;
  }
  EXPECT_GT(there, 100U);
  EXPECT_LT(there, plan.search->lines.size());  // some were hung elsewhere
  ASSERT_FALSE(plan.search->ways.empty());
  const Plan global = planned(s, "rrt_star_woa_global", {{"iterations", 500.0}, {"rounds", 0.0}});
  ASSERT_TRUE(global.search);
  EXPECT_EQ(global.search->swarms.size(), 11U);  // the first agents, and ten iterations
  const Plan local = planned(s, "rrt_star_woa_local", {{"iterations", 1000.0}});
  ASSERT_TRUE(local.search);
  EXPECT_GT(local.search->swarms.size(), 40U);  // a share of the extensions
  EXPECT_LE(local.search->swarms.size(), 100U);
  std::uint32_t before = 0;
  for (const SearchPicture::Swarm& swarm : local.search->swarms) {
    EXPECT_GT(swarm.born, before);
    before = swarm.born;
    ASSERT_EQ(swarm.agents.size(), 10U);
    for (const std::vector<Vec2>& agent : swarm.agents) EXPECT_EQ(agent.size(), 1U);
  }
  EXPECT_GT(before, 800U);  // spread over all of the search
}

TEST(PlanePlanners, LessWorkIsDoneWhereLessIsAllowed) {
  Random random{12};
  Scenario s = hall(random, test::disc, 0.02, 8);
  s.budget.samples = 200;
  const Plan few = planned(s, "rrt_star");
  s.budget.samples.reset();
  s.budget.evaluations = 300;
  const Plan lines = planned(s, "rrt_star");
  EXPECT_LE(lines.effort.evaluations, 300);
  EXPECT_NE(few.effort.evaluations, lines.effort.evaluations);
}

}  // namespace
}  // namespace waywright
