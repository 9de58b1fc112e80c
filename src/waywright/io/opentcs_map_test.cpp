#include "waywright/io/opentcs_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "waywright/io/lane_map_io.hpp"
#include "waywright/io/scenario_io.hpp"
#include "waywright/io/test_files.hpp"
#include "waywright/map/lane_graph.hpp"
#include "waywright/map/world.hpp"

namespace waywright {
namespace {

const std::string plant = R"(<?xml version="1.0" encoding="UTF-8"?>
<model version="7.0.0" name="hall">
  <point name="A" positionX="0" positionY="0" positionZ="0" vehicleOrientationAngle="NaN" type="HALT_POSITION"><outgoingPath name="A-B"/></point>
  <point name="B" positionX="10000" positionY="0" positionZ="0" vehicleOrientationAngle="90.0" type="PARK_POSITION"/>
  <path name="A-B" sourcePoint="A" destinationPoint="B" length="10000" maxVelocity="1500" maxReverseVelocity="0" locked="false">
    <pathLayout connectionType="DIRECT" layerId="0"/>
  </path>
  <path name="bent" sourcePoint="B" destinationPoint="C" length="1" maxVelocity="1000" maxReverseVelocity="500" locked="false">
    <pathLayout connectionType="BEZIER" layerId="0"><controlPoint x="300" y="0"/><controlPoint x="300" y="-100"/></pathLayout>
  </path>
  <path name="back" sourcePoint="A" destinationPoint="C" length="11180" maxVelocity="0" maxReverseVelocity="700" locked="false"/>
  <path name="shut" sourcePoint="C" destinationPoint="A" length="11180" maxVelocity="1000" maxReverseVelocity="0" locked="true"/>
  <point name="C" xPosition="10000" yPosition="5000" zPosition="0" vehicleOrientationAngle="NaN" type="HALT_POSITION"/>
  <vehicle name="V" maxVelocity="1200" maxReverseVelocity="1000"><boundingBox length="1600" width="800" height="1" referenceOffsetX="300" referenceOffsetY="0"/></vehicle>
  <location name="rack" positionX="0" positionY="3000" positionZ="0" type="T"><link point="A"/></location>
  <visualLayout name="L" scaleX="50.0" scaleY="50.0"/>
</model>
)";

std::string refusal(const std::string& text) {
  const auto map = decode_opentcs_map(text, "p.xml");
  return map ? "accepted" : map.error().message();
}

std::string with(std::string text, const std::string& from, const std::string& to) { return text.replace(text.find(from), from.size(), to); }

TEST(OpenTcsMap, PointsPathsLocationsAndVehiclesInMetres) {
  const PlantModel map = decode_opentcs_map(plant, "p.xml").value();
  const LaneGraph& graph = map.lanes;
  ASSERT_EQ(graph.places.size(), 3U);
  EXPECT_EQ(graph.places[1].at, (Vec2{10, 0}));
  EXPECT_FALSE(graph.places[0].heading);
  EXPECT_NEAR(graph.places[1].heading.value(), 0.5 * std::numbers::pi, 1e-12);
  EXPECT_EQ(graph.places[2].at, (Vec2{10, 5}));  // as models before version 6 name it
  ASSERT_EQ(graph.lanes.size(), 3U);
  EXPECT_EQ(graph.lanes[0].course, (Polyline{{0, 0}, {10, 0}}));
  EXPECT_FALSE(graph.lanes[0].is_both_ways);
  EXPECT_EQ(graph.lanes[0].speed, 1.5);
  // Of control points (15, 0) and (15, 5): the curve's middle is at x = (10 + 3 · 15 + 3 · 15 + 10) / 8.
  const Lane& bent = graph.lanes[1];
  EXPECT_TRUE(bent.is_both_ways);
  EXPECT_EQ(bent.speed, 0.5);
  EXPECT_GT(bent.course.size(), 6U);
  double reach = 0.0;
  for (const Vec2 p : bent.course) reach = std::max(reach, p.x);
  EXPECT_NEAR(reach, 13.75, 0.02);
  // Driven from C to A alone, as the reverse velocity says.
  EXPECT_EQ(graph.lanes[2].from, 2U);
  EXPECT_EQ(graph.lanes[2].to, 0U);
  EXPECT_EQ(graph.lanes[2].course, (Polyline{{10, 5}, {0, 0}}));
  ASSERT_EQ(graph.stations.size(), 1U);
  EXPECT_EQ(graph.stations[0].places, (std::vector<std::size_t>{0}));
  ASSERT_EQ(graph.vehicles.size(), 1U);
  EXPECT_EQ(graph.vehicles[0].length, 1.6);
  EXPECT_EQ(graph.vehicles[0].reference, (Vec2{0.3, 0.0}));
  EXPECT_EQ(graph.vehicles[0].speed, 1.2);
  EXPECT_EQ(std::count(map.notes.begin(), map.notes.end(), "left out: 1 locked path"), 1);
  EXPECT_EQ(std::count(map.notes.begin(), map.notes.end(), "1 path is stated to be of another length than drawn; the drawn one counts"), 1);
  EXPECT_EQ(place_named(graph, "rack"), 0U);
  EXPECT_FALSE(place_named(graph, "nowhere"));
  const auto route = shortest_route(graph, 0, 0);
  ASSERT_TRUE(route);
  EXPECT_TRUE(route->steps.empty());
}

TEST(OpenTcsMap, BadOnesAreRefusedInASentence) {
  EXPECT_NE(refusal("").find("not valid XML"), std::string::npos);
  EXPECT_NE(refusal("<svg/>").find("a document of <svg> (allowed: <model>"), std::string::npos) << refusal("<svg/>");
  EXPECT_NE(refusal("<model/>").find("there is no point in it"), std::string::npos);
  EXPECT_NE(refusal(with(plant, "positionX=\"10000\"", "positionX=\"ten\"")).find("line 4 (B): positionX is \"ten\""), std::string::npos) << refusal(with(plant, "positionX=\"10000\"", "positionX=\"ten\""));
  EXPECT_NE(refusal(with(plant, "positionX=\"10000\"", "")).find("it has no positionX"), std::string::npos);
  EXPECT_NE(refusal(with(plant, "\"90.0\"", "\"north\"")).find("degrees, or NaN"), std::string::npos);
  EXPECT_NE(refusal(with(plant, "name=\"B\"", "name=\"A\"")).find("another point has this name"), std::string::npos);
  EXPECT_NE(refusal(with(plant, "destinationPoint=\"C\"", "destinationPoint=\"D\"")).find("line 8 (bent): its destinationPoint \"D\" is no point of the model"), std::string::npos);
  EXPECT_NE(refusal(with(plant, "<link point=\"A\"", "<link point=\"Z\"")).find("its link \"Z\""), std::string::npos);
  EXPECT_NE(refusal(with(plant, "destinationPoint=\"B\"", "destinationPoint=\"A\"")).find("from a point to itself"), std::string::npos);
  EXPECT_NE(refusal(with(plant, "maxVelocity=\"1500\"", "maxVelocity=\"-1\"")).find("maxVelocity is \"-1\""), std::string::npos);
  EXPECT_NE(refusal(with(plant, "x=\"300\"", "x=\"1e12\"")).find("coordinates within 1e9 m"), std::string::npos);
  EXPECT_NE(refusal(with(plant, "</model>", "")).find("not valid XML"), std::string::npos);
  EXPECT_NE(refusal("<!DOCTYPE m [<!ENTITY a \"b\">]><model/>").find("it declares entities"), std::string::npos);
  std::string deep = "<model>";
  for (int i = 0; i < 100; ++i) deep += "<a>";
  EXPECT_NE(refusal(deep).find("nested too deeply"), std::string::npos);
}

TEST(OpenTcsMap, AScenarioSaysWhatIsFreeAroundIt) {
  const test::Folder folder;
  std::ofstream{folder.path() / "p.xml"} << plant;
  const auto scenario = [&](const std::string& more) {
    return parse_scenario(R"({"format": "waywright-scenario/1", "map": {"opentcs": "p.xml")" + more +
                              R"(}, "vehicle": {"footprint": {"disc": 0.3}, "drive": {"type": "differential", "track": 0.4}}, "start": [0, 0, 0], "goal": [10, 5, 0]})",
                          "s.json", folder.path());
  };
  const auto refused = [&](const std::string& more) { return scenario(more) ? std::string{"accepted"} : scenario(more).error().message(); };
  const Scenario open = scenario("").value();
  ASSERT_EQ(open.map.boundaries.size(), 1U);
  EXPECT_EQ(bounding_box(open.map.boundaries.front()).low, (Vec2{-5, -5}));
  EXPECT_EQ(bounding_box(scenario(R"(, "margin": 1)")->map.boundaries.front()).low, (Vec2{-1, -1}));
  const Scenario strips = scenario(R"(, "corridor": 2, "cell": 0.05)").value();
  World world{strips.map};
  world.build();
  EXPECT_FALSE(world.is_blocked({5.0, 0.9}));
  EXPECT_TRUE(world.is_blocked({5.0, 1.05}));
  const LaneMap placed = read_lane_map(folder.path() / "p.xml", {{{0, 0}, {100, 0}}, {{10, 0}, {100, 10}}}).value();
  EXPECT_NEAR(placed.lanes.places[1].at.y, 10.0, 1e-9);
  EXPECT_NEAR(placed.lanes.lanes[0].course[1].x, 100.0, 1e-9);
  EXPECT_NEAR(placed.lanes.places[1].heading.value(), std::numbers::pi, 1e-9);
  EXPECT_NE(refused(R"(, "corridor": 2, "margin": 1)").find("map.margin"), std::string::npos);
  EXPECT_NE(refused(R"(, "cell": 1)").find("map.cell: it goes with corridor alone"), std::string::npos);
  EXPECT_NE(refused(R"(, "corridor": 2, "cell": 1)").find("map.corridor: it is 2 m, less than four cells of 1 m"), std::string::npos) << refused(R"(, "corridor": 2, "cell": 1)");
  EXPECT_NE(refused(R"(, "corridor": 2, "cell": 0.0001)").find("larger cells"), std::string::npos);
  EXPECT_NE(refused(R"(, "level": "L1")").find("map.level"), std::string::npos);
}

TEST(OpenTcsMap, TheDemoPlantIsRead) {
  const char* data = std::getenv("WAYWRIGHT_TEST_DATA");
  if (data == nullptr || !std::filesystem::exists(std::filesystem::path{data} / "roadmaps")) GTEST_SKIP() << "no outside data (WAYWRIGHT_TEST_DATA)";
  const auto map = read_lane_map(std::filesystem::path{data} / "roadmaps" / "opentcs_Demo-01.xml");
  ASSERT_TRUE(map) << map.error().message();
  EXPECT_EQ(map->lanes.places.size(), 59U);
  EXPECT_EQ(map->lanes.lanes.size(), 75U);
  EXPECT_EQ(map->lanes.stations.size(), 16U);
  EXPECT_EQ(map->lanes.vehicles.size(), 4U);
  // Every place is led to from every other, as in a plant where vehicles go round.
  std::size_t reached = 0;
  for (std::size_t i = 0; i < 59; ++i) reached += shortest_route(map->lanes, 0, i) ? 1 : 0;
  EXPECT_EQ(reached, 59U);
}

}  // namespace
}  // namespace waywright
