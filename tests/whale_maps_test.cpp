// The reconstructed maps of the publication on RRT* with the whale optimisation algorithm: the shortest ways of a point on them, and their scenario files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/command_line.hpp"
#include "waywright/io/plan_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/judge/judge.hpp"
#include "waywright/map/whale_maps.hpp"
#include "waywright/planner/registry.hpp"

namespace waywright {
namespace {

/// Does the open segment from a to b enter the inside of the box? By clipping (Liang and Barsky); along a side is allowed.
bool enters(Vec2 a, Vec2 b, const Box& box) {
  double low = 0.0, high = 1.0;
  const Vec2 way = b - a;
  const auto clip = [&](double p, double q) {  // p·t < q holds inside
    if (p == 0.0) return q > 0.0;
    if (p < 0.0) low = std::max(low, q / p);
    else high = std::min(high, q / p);
    return low < high;
  };
  return clip(-way.x, a.x - box.low.x) && clip(way.x, box.high.x - a.x) && clip(-way.y, a.y - box.low.y) && clip(way.y, box.high.y - a.y) && high - low > 1e-12;
}

/// Dijkstra over the places that see each other: start, goal and corners, these a hair outside of their rectangles, so that none lies on a wall or in the seam of
/// two that touch.
double shortest_way(const WhaleMap& hall) {
  constexpr double hair = 1e-6;  // m
  std::vector<Box> boxes;
  std::vector<Vec2> places{hall.task.start, hall.task.goal};
  const Box inside = bounding_box(hall.map.boundaries.front());
  for (const Ring& ring : hall.map.obstacles) {
    const Box box = bounding_box(ring);
    boxes.push_back(box);
    for (const double x : {box.low.x - hair, box.high.x + hair}) {
      for (const double y : {box.low.y - hair, box.high.y + hair}) {
        if (inside.contains({x, y})) places.push_back({x, y});
      }
    }
  }
  constexpr double far = std::numeric_limits<double>::infinity();
  std::vector<double> cost(places.size(), far);
  std::vector<bool> done(places.size(), false);
  cost[0] = 0.0;
  for (;;) {
    std::size_t at = places.size();
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!done[i] && cost[i] < far && (at == places.size() || cost[i] < cost[at])) at = i;
    }
    if (at == places.size()) return cost[1];
    done[at] = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (done[i] || std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return enters(places[at], places[i], box); })) continue;
      cost[i] = std::min(cost[i], cost[at] + distance(places[at], places[i]));
    }
  }
}

TEST(WhaleMaps, HaveTheShortestWaysOfTheirReconstruction) {
  const std::vector<std::size_t> rectangles{0, 6, 6, 5, 26};
  ASSERT_EQ(whale_map_names().size(), rectangles.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < rectangles.size(); ++i) {
    const WhaleMap hall = whale_map(whale_map_names()[i]).value();
    EXPECT_EQ(hall.map.obstacles.size(), rectangles[i]) << hall.name;
    EXPECT_NEAR(shortest_way(hall), hall.optimum, 0.0006) << hall.name;
    sum += hall.optimum;
    for (const Ring& ring : hall.map.obstacles) EXPECT_GT(signed_area(ring), 0.0);
  }
  EXPECT_NEAR(sum / 5.0, 27.273, 0.001);
  EXPECT_FALSE(whale_map("WOA-6"));
  EXPECT_FALSE(whale_map(""));
}

class WhaleExamples : public testing::TestWithParam<int> {};

Plan planned(const Scenario& scenario) {
  Scenario whole = scenario;
  whole.planner.parameters = complete_parameters(whole.planner).value();
  return solve(Problem::prepare(whole).value()).value();
}

TEST_P(WhaleExamples, AreSolvedForAPointAndForTheWheelchair) {
  const int number = GetParam();
  const WhaleMap hall = whale_map("WOA-" + std::to_string(number)).value();
  const std::string folder = std::string{WAYWRIGHT_SOURCE_DIR} + "/examples/rrt_woa/";
  for (const std::string& who : {std::string{"point"}, std::string{"wheelchair"}}) {
    const Scenario scenario = read_scenario(folder + who + "_" + std::to_string(number) + ".json").value();
    EXPECT_EQ(scenario.map.obstacles, hall.map.obstacles);
    const Plan plan = planned(scenario);
    ASSERT_EQ(plan.status, Status::solved) << who << plan.reason;
    const auto again = parse_plan(plan_json(plan), "plan.json");
    ASSERT_TRUE(again) << again.error().message();
    const auto verification = verify(*again);
    ASSERT_TRUE(verification);
    EXPECT_TRUE(verification->findings.empty()) << who << verification->findings.front();
    // The optimum is told to half a millimetre.
    EXPECT_GE(plan.metrics.length, hall.optimum - 0.0006) << who;
    EXPECT_LE(plan.metrics.length, (who == "point" ? 1.01 : 1.15) * hall.optimum) << who;
  }
}

INSTANTIATE_TEST_SUITE_P(Maps, WhaleExamples, testing::Range(1, 6));

using waywright::test::CommandLine;

TEST_F(CommandLine, PublishedMapsAreListedAndGenerated) {
  const std::string listed = run("list maps").out;
  for (const char* name : {"SA-CONVEX", "WOA-1", "WOA-5"}) EXPECT_NE(listed.find(name), std::string::npos) << name;
  for (const std::string& name : {std::string{"WOA-2"}, std::string{"SA-WH"}}) {
    ASSERT_EQ(run("generate " + name + " -o g.json").status, 0);
    const auto planned = run("plan g.json -o o");
    EXPECT_EQ(planned.status, 0) << planned.out << planned.err;
    EXPECT_EQ(run("verify o/plan.json").status, 0);
    std::filesystem::remove_all(folder_ / "o");
  }
  refused(run("generate WOA-6 -o g6.json"), {"WOA-6", "list maps"});
  refused(run("generate WOA-1 --boxes 3 -o g1.json"), {"--boxes"});
}

TEST_F(CommandLine, ThePublicationsConfigurationIsPlanned) {
  std::ofstream{folder_ / "c.json"} << R"({"TestMode": true, "MapProcessor_Map_Name": "2", "PathPlanner_Iterations": 10000, "PathPlanner_Step_Size": 1.0, "PathOptimizer_Population": 10,
})";
  const auto other = run("plan c.json --planner theta_star -o o");
  ASSERT_EQ(other.status, 0) << other.err;
  for (const char* told : {"MapProcessor_Map_Name \"2\" -> map.generate = \"WOA-2\"", "TestMode true is ignored", "PathPlanner_Step_Size 1.0 is ignored: theta_star has no such parameter"}) {
    EXPECT_NE(other.err.find(told), std::string::npos) << told << other.err;
  }
  EXPECT_EQ(run("verify o/plan.json").status, 0);
  std::filesystem::remove_all(folder_ / "o");
  std::ofstream{folder_ / "u.json"} << R"({"MapProcessor_Map_Name": "2", "PathPlanner_Steps": 1})";
  refused(run("plan u.json"), {"PathPlanner_Steps", "unknown key", "PathPlanner_Step_Size"});
  const auto global = run("plan c.json -o g");
  EXPECT_EQ(global.status, 0) << global.out << global.err;
  EXPECT_NE(global.err.find("PathPlanner_Step_Size 1.0 -> planner.parameters.step = 1"), std::string::npos) << global.err;
}

}  // namespace
}  // namespace waywright
