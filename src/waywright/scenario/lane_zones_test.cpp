#include "waywright/scenario/lane_zones.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace waywright {
namespace {

LaneGraph graph_of(const std::vector<Vec2>& places, const std::vector<std::pair<std::size_t, std::size_t>>& lanes) {
  LaneGraph graph;
  for (const Vec2 p : places) graph.places.push_back({"p" + std::to_string(graph.places.size()), p, {}});
  for (const auto& [from, to] : lanes) {
    Lane lane;
    lane.name = graph.places[from].name + "-" + graph.places[to].name;
    lane.from = from;
    lane.to = to;
    lane.course = {places[from], places[to]};
    graph.lanes.push_back(lane);
  }
  return graph;
}

std::vector<const Zone*> of_type(const LaneZones& zones, ZoneType type) {
  std::vector<const Zone*> all;
  for (const Zone& zone : zones.zones) {
    if (zone.type == type) all.push_back(&zone);
  }
  return all;
}

TEST(LaneZones, AOneWayLaneIsDirectedUpToItsJunctions) {
  LaneGraph graph = graph_of({{0, 0}, {10, 0}}, {{0, 1}});
  graph.lanes[0].speed = 0.5;
  LaneRules rules{.width = 2.0, .preference = 0.4, .vehicle_speed = 1.0};
  const LaneZones zones = lane_zones(graph, rules).value();
  ASSERT_EQ(zones.zones.size(), 3U);
  const Zone& directed = *of_type(zones, ZoneType::directed).at(0);
  EXPECT_EQ(directed.direction, 0.0);
  EXPECT_EQ(bounding_box(directed.area).low, (Vec2{1, -1}));
  EXPECT_EQ(bounding_box(directed.area).high, (Vec2{9, 1}));
  EXPECT_EQ(bounding_box(of_type(zones, ZoneType::preferred).at(0)->area).high, (Vec2{10, 1}));
  EXPECT_EQ(of_type(zones, ZoneType::speed_limit).at(0)->speed, 0.5);
  for (const Zone& zone : zones.zones) EXPECT_GT(signed_area(zone.area), 0.0);
  // A vehicle that is slower anyway needs no limit; of a lane that is driven both ways there is no direction.
  rules.vehicle_speed = 0.5;
  graph.lanes[0].is_both_ways = true;
  EXPECT_EQ(lane_zones(graph, rules)->zones.size(), 1U);
}

TEST(LaneZones, DirectionsAtJunctionsDoNotContradict) {
  // A sharp turn back: the two lanes lie beside each other near p1, and far from it their strips part.
  const LaneGraph graph = graph_of({{0, 0}, {20, 0}, {0, 8}}, {{0, 1}, {1, 2}});
  const LaneZones zones = lane_zones(graph, {.width = 2.0}).value();
  const auto directed = of_type(zones, ZoneType::directed);
  ASSERT_EQ(directed.size(), 2U);
  EXPECT_TRUE(zones.notes.empty());
  // No point is within both.
  int in_one = 0;
  for (double x = -2; x < 22; x += 0.05) {
    for (double y = -2; y < 10; y += 0.05) {
      const bool a = contains(directed[0]->area, {x, y}), b = contains(directed[1]->area, {x, y});
      EXPECT_FALSE(a && b) << x << " " << y;
      in_one += a || b ? 1 : 0;
    }
  }
  EXPECT_GT(in_one, 1000);
}

TEST(LaneZones, LanesBesideEachOtherTheOtherWayHaveNoDirection) {
  const LaneGraph graph = graph_of({{0, 0}, {20, 0}, {20, 0.5}, {0, 0.5}, {0, 9}, {20, 9}}, {{0, 1}, {2, 3}, {4, 5}});
  const LaneZones zones = lane_zones(graph, {.width = 1.0}).value();
  const auto directed = of_type(zones, ZoneType::directed);
  ASSERT_EQ(directed.size(), 1U);
  EXPECT_EQ(directed[0]->name, "p4-p5");
  ASSERT_EQ(zones.notes.size(), 1U);
  EXPECT_NE(zones.notes[0].find("2 one-way lanes have no direction"), std::string::npos);
  EXPECT_NE(zones.notes[0].find("p0-p1, p2-p3"), std::string::npos);
  EXPECT_EQ(of_type(lane_zones(graph, {.width = 0.4}).value(), ZoneType::directed).size(), 3U);
}

TEST(LaneZones, PreferredOnesDoNotOverlap) {
  const LaneGraph graph = graph_of({{0, 0}, {20, 0}, {8, -9}, {12, 9}, {0, 0.6}, {20, 1.2}, {15, 5}}, {{0, 1}, {2, 3}, {4, 5}, {3, 6}, {6, 1}});
  const LaneZones zones = lane_zones(graph, {.width = 1.0, .preference = 0.5}).value();
  const auto preferred = of_type(zones, ZoneType::preferred);
  int in_one = 0;
  for (double x = -1; x < 21; x += 0.0713) {
    for (double y = -10; y < 10; y += 0.0717) {
      const auto in = std::count_if(preferred.begin(), preferred.end(), [&](const Zone* zone) { return contains(zone->area, {x, y}); });
      EXPECT_LE(in, 1) << x << " " << y;
      bool on_lane = false;
      for (const Lane& lane : graph.lanes) {
        const Vec2 a = lane.course[0], way = lane.course[1] - a;
        const double t = dot(Vec2{x, y} - a, way) / squared_norm(way), off = std::abs(cross(way, Vec2{x, y} - a)) / norm(way);
        on_lane = on_lane || (t > 0.0 && t < 1.0 && off < 0.499);
      }
      in_one += in == 1 ? 1 : 0;
      EXPECT_TRUE(!on_lane || in == 1) << x << " " << y;  // what one leaves out is in another
    }
  }
  EXPECT_GT(in_one, 5000);
}

TEST(LaneZones, BendsAreFollowed) {
  LaneGraph graph = graph_of({{0, 0}, {10, 0}}, {{0, 1}});
  Polyline& course = graph.lanes[0].course;
  course.clear();
  for (int i = 0; i <= 24; ++i) {  // half a circle, to the left
    const double a = std::numbers::pi * (1.0 - i / 24.0);
    course.push_back({5.0 - 5.0 * std::cos(std::numbers::pi - a), -5.0 * std::sin(a)});
  }
  course.front() = {0, 0};
  course.back() = {10, 0};
  const LaneZones zones = lane_zones(graph, {.width = 1.0, .preference = 0.5}).value();
  ASSERT_EQ(of_type(zones, ZoneType::preferred).size(), 1U);
  const auto directed = of_type(zones, ZoneType::directed);
  EXPECT_GT(directed.size(), 15U);  // it leaves its chord by 90°
  // In each of them the course is within 90° of the direction wherever it goes.
  for (std::size_t i = 0; i + 1 < course.size(); ++i) {
    const Vec2 middle = 0.5 * (course[i] + course[i + 1]), way = course[i + 1] - course[i];
    EXPECT_TRUE(contains(of_type(zones, ZoneType::preferred)[0]->area, middle));
    for (const Zone* zone : directed) {
      if (!contains(zone->area, middle)) continue;
      EXPECT_GT(dot(way, unit(zone->direction)), 0.0);
    }
  }
  graph.lanes[0].course = {{0, 0}, {3, 1}, {7, 1}, {10, 0}};
  EXPECT_EQ(of_type(lane_zones(graph, {.width = 1.0}).value(), ZoneType::directed).size(), 1U);
}

TEST(LaneZones, MoreThanAScenarioMayHaveAreRefused) {
  std::vector<Vec2> places;
  std::vector<std::pair<std::size_t, std::size_t>> lanes;
  for (std::size_t i = 0; i < 1002; ++i) {
    places.push_back({5.0 * static_cast<double>(i), 0});
    if (i > 0) lanes.emplace_back(i - 1, i);
  }
  const auto zones = lane_zones(graph_of(places, lanes), {.width = 1.0});
  ASSERT_FALSE(zones);
  EXPECT_NE(zones.error().problem.find("1001 zones"), std::string::npos);
}

}  // namespace
}  // namespace waywright
