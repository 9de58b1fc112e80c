#include "waywright/map/lane_graph.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "waywright/core/random.hpp"
#include "waywright/map/world.hpp"

namespace waywright {
namespace {

LaneGraph drawn(Random& random, std::size_t places, std::size_t lanes) {
  LaneGraph graph;
  for (std::size_t i = 0; i < places; ++i) graph.places.push_back({"p" + std::to_string(i), {random.uniform(-10, 10), random.uniform(-6, 6)}, {}});
  for (std::size_t i = 0; i < lanes; ++i) {
    Lane lane;
    lane.from = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(places) - 1));
    lane.to = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(places) - 2));
    if (lane.to >= lane.from) ++lane.to;
    lane.is_both_ways = random.uniform() < 0.3;
    lane.course = {graph.places[lane.from].at};
    if (random.uniform() < 0.5) lane.course.push_back({random.uniform(-10, 10), random.uniform(-6, 6)});
    lane.course.push_back(graph.places[lane.to].at);
    graph.lanes.push_back(lane);
  }
  return graph;
}

TEST(LaneGraph, RoutesAreShortestOnes) {
  Random random{5};
  int found = 0;
  for (int round = 0; round < 40; ++round) {
    const LaneGraph graph = drawn(random, 12, 18);
    constexpr double far = std::numeric_limits<double>::infinity();
    // Floyd and Warshall's.
    std::vector<std::vector<double>> d(12, std::vector<double>(12, far));
    for (std::size_t i = 0; i < 12; ++i) d[i][i] = 0.0;
    for (const Lane& lane : graph.lanes) {
      d[lane.from][lane.to] = std::min(d[lane.from][lane.to], length(lane));
      if (lane.is_both_ways) d[lane.to][lane.from] = std::min(d[lane.to][lane.from], length(lane));
    }
    for (std::size_t k = 0; k < 12; ++k) {
      for (std::size_t i = 0; i < 12; ++i) {
        for (std::size_t j = 0; j < 12; ++j) d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
      }
    }
    for (std::size_t i = 0; i < 12; ++i) {
      for (std::size_t j = 0; j < 12; ++j) {
        const auto route = shortest_route(graph, i, j);
        ASSERT_EQ(route.has_value(), std::isfinite(d[i][j]));
        if (!route) continue;
        ++found;
        EXPECT_NEAR(route->length, d[i][j], 1e-9);
        ASSERT_EQ(route->places.size(), route->steps.size() + 1);
        EXPECT_EQ(route->places.front(), i);
        EXPECT_EQ(route->places.back(), j);
        for (std::size_t k = 0; k < route->steps.size(); ++k) {
          const Lane& lane = graph.lanes[route->steps[k].lane];
          const bool back = route->steps[k].is_backwards;
          EXPECT_TRUE(!back || lane.is_both_ways);
          EXPECT_EQ(back ? lane.to : lane.from, route->places[k]);
          EXPECT_EQ(back ? lane.from : lane.to, route->places[k + 1]);
        }
      }
    }
  }
  EXPECT_GT(found, 1000);
}

double distance_to(const LaneGraph& graph, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Lane& lane : graph.lanes) {
    for (std::size_t i = 0; i + 1 < lane.course.size(); ++i) {
      for (int k = 0; k <= 400; ++k) least = std::min(least, distance(p, lane.course[i] + (k / 400.0) * (lane.course[i + 1] - lane.course[i])));
    }
  }
  return least;
}

TEST(LaneGraph, CorridorsHoldNothingBeyondTheStripsAndLoseAtMostACellAndAHalf) {
  Random random{6};
  for (int round = 0; round < 6; ++round) {
    const LaneGraph graph = drawn(random, 6, 5);
    const double width = 1.0, cell = 0.1;
    const CellGrid grid = lane_corridors(graph, width, cell).value();
    Map map;
    map.grids = {grid};
    World world{map};
    world.build();
    int inside = 0, outside = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec2 p{random.uniform(-12, 12), random.uniform(-8, 8)};
      const double away = distance_to(graph, p);  // within 0.025 m of the truth: lanes are up to 20 m long, and looked at in 400 parts
      if (away > 0.5 * width + 0.03) {
        EXPECT_TRUE(world.is_blocked(p)) << p.x << " " << p.y;
        ++outside;
      } else if (away < 0.5 * width - 1.5 * cell - 0.001) {
        EXPECT_FALSE(world.is_blocked(p)) << p.x << " " << p.y;
        ++inside;
      }
    }
    EXPECT_GT(inside, 200);
    EXPECT_GT(outside, 500);
  }
}

TEST(LaneGraph, CorridorsThatCannotBeAreRefused) {
  Random random{7};
  const LaneGraph graph = drawn(random, 6, 5);
  EXPECT_NE(lane_corridors(graph, 0.3, 0.1).error().problem.find("less than four cells"), std::string::npos);
  EXPECT_NE(lane_corridors(graph, 1.0, 1e-4).error().problem.find("cells of 0.0001 m"), std::string::npos);
  EXPECT_FALSE(lane_corridors({}, 1.0, 0.1));
  EXPECT_GE(corridor_cell(graph, 0.2), 0.01);
  EXPECT_TRUE(lane_corridors(graph, 0.2, corridor_cell(graph, 0.2)));
}

TEST(LaneGraph, DeadEndsAreTold) {
  LaneGraph graph;
  for (const char* name : {"a", "b", "c"}) graph.places.push_back({name, {static_cast<double>(graph.places.size()), 0.0}, {}});
  for (const auto& [from, to] : {std::pair{0U, 1U}, {1U, 2U}}) {
    Lane lane;
    lane.from = from;
    lane.to = to;
    lane.course = {graph.places[from].at, graph.places[to].at};
    graph.lanes.push_back(lane);
  }
  EXPECT_EQ(describe(graph), (std::vector<std::string>{"3 places, 2 lanes of 2.0 m in all, 2 of them one way", "no lane leads on from c", "no lane leads to a"}));
  graph.lanes[1].is_both_ways = true;
  EXPECT_EQ(describe(graph), (std::vector<std::string>{"3 places, 2 lanes of 2.0 m in all, 1 of them one way", "no lane leads to a"}));
}

}  // namespace
}  // namespace waywright
