#include "waywright/io/rmf_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "waywright/io/scenario_io.hpp"
#include "waywright/map/world.hpp"

namespace waywright {
namespace {

const std::string two_rooms = R"(name: hall
levels:
  L1:
    vertices:
      - [100, 200, 0, ""]
      - [300, 200, 0, ""]
      - [300, 400, 0, "lift"]
    measurements:
      - [0, 1, {distance: [3, 10]}]
    walls:
      - [0, 1, {alpha: [3, 1]}]
      - [1, 2, {}]
    doors:
      - [0, 2, {name: [1, d]}]
)";

std::string refusal(const std::string& text, const std::string& level = "") {
  const auto map = decode_rmf_map(text, "b.building.yaml", level);
  return map ? "accepted" : map.error().message();
}

std::string with(std::string text, const std::string& from, const std::string& to) { return text.replace(text.find(from), from.size(), to); }

TEST(RmfMap, WallsAreLinesInMetres) {
  const Map map = decode_rmf_map(two_rooms, "b", "").value();
  ASSERT_EQ(map.lines.size(), 2U);
  EXPECT_EQ(map.lines[0], (Polyline{{5, -10}, {15, -10}}));
  EXPECT_EQ(map.lines[1], (Polyline{{15, -10}, {15, -20}}));
  EXPECT_EQ(map.notes, (std::vector<std::string>{"a pixel is 0.05 m by 1 measurement", "places: lift (15.000, -20.000)", "left out: doors (1)"}));
  const Map metres = decode_rmf_map("coordinate_system: cartesian_meters\n" + two_rooms, "b", "L1").value();
  EXPECT_EQ(metres.lines[0], (Polyline{{100, 200}, {300, 200}}));
}

TEST(RmfMap, LanesAreRoutesBesideTheWalls) {
  const std::string lanes = two_rooms + R"(    lanes:
      - [0, 1, {bidirectional: [4, true], graph_idx: [2, 0], orientation: [1, ""], speed_limit: [3, 0]}]
      - [1, 2, {bidirectional: [4, false], speed_limit: [3, 0.5]}]
)";
  LaneGraph graph;
  const Map map = decode_rmf_map(lanes, "b", "", &graph).value();
  EXPECT_EQ(map.lines.size(), 2U);
  ASSERT_EQ(graph.lanes.size(), 2U);
  EXPECT_EQ(graph.lanes[0].course, (Polyline{{5, -10}, {15, -10}}));
  EXPECT_TRUE(graph.lanes[0].is_both_ways);
  EXPECT_FALSE(graph.lanes[0].speed);
  EXPECT_FALSE(graph.lanes[1].is_both_ways);
  EXPECT_EQ(graph.lanes[1].speed, 0.5);
  EXPECT_EQ(graph.places.at(graph.lanes[1].to).name, "lift");
  EXPECT_EQ(graph.places.at(graph.lanes[1].from).name, "vertex 1");
  EXPECT_NE(std::find(map.notes.begin(), map.notes.end(), "3 places, 2 lanes of 20.0 m in all, 1 of them one way"), map.notes.end());
  EXPECT_NE(refusal(with(lanes, "- [1, 2, {bidirectional", "- [1, 9, {bidirectional")).find("levels.L1.lanes[1]: it is no lane"), std::string::npos);
  EXPECT_NE(refusal(with(lanes, "- [1, 2, {bidirectional", "- [1, 1, {bidirectional")).find("levels.L1.lanes[1]: it is no lane"), std::string::npos);
}

TEST(RmfMap, BadOnesAreRefusedInASentence) {
  EXPECT_NE(refusal("a: 1").find("levels: it has no levels"), std::string::npos);
  EXPECT_NE(refusal("[1, 2]").find("levels"), std::string::npos);
  EXPECT_NE(refusal(two_rooms, "L2").find("there is no level \"L2\", did you mean \"L1\"? (allowed: L1)"), std::string::npos);
  EXPECT_NE(refusal(two_rooms + "  L2: {}\n").find("it has several levels (allowed: L1, L2)"), std::string::npos);
  EXPECT_NE(refusal("coordinate_system: wgs84\n" + two_rooms).find("wgs84"), std::string::npos);
  EXPECT_NE(refusal(with(two_rooms, "[1, 2, {}]", "[1, 7, {}]")).find("levels.L1.walls[1]: it is no wall"), std::string::npos);
  EXPECT_NE(refusal(with(two_rooms, "[3, 10]", "[3, 0]")).find("measurements[0]: a length of it is 0"), std::string::npos);
  EXPECT_NE(refusal(with(two_rooms, "- [0, 1, {distance: [3, 10]}]", "[]")).find("no scale"), std::string::npos);
  EXPECT_NE(refusal(with(two_rooms, "[100, 200, 0", "[1e400, 200, 0")).find("vertices[0]: it is no vertex"), std::string::npos);
  EXPECT_NE(refusal(with(two_rooms, "[100, 200, 0", "[*a, 200, 0")).find("aliases"), std::string::npos);
  EXPECT_NE(refusal("a: [1").find("not valid yaml"), std::string::npos);
}

TEST(RmfMap, OpenRmfBuildingsAreRead) {
  const char* data = std::getenv("WAYWRIGHT_TEST_DATA");
  if (data == nullptr || !std::filesystem::exists(std::filesystem::path{data} / "roadmaps")) GTEST_SKIP() << "no outside data (WAYWRIGHT_TEST_DATA)";
  for (const auto& [file, walls] : {std::pair{"rmf_office.building.yaml", 33U}, std::pair{"rmf_airport_terminal.building.yaml", 464U}}) {
    const auto map = read_map(std::filesystem::path{data} / "roadmaps" / file);
    ASSERT_TRUE(map) << map.error().message();
    EXPECT_EQ(map->lines.size(), walls);
    World world{*map};
    world.build();
    const Vec2 size = world.bounds().high - world.bounds().low;
    EXPECT_GT(std::min(size.x, size.y), 5.0) << file;
    EXPECT_LT(std::max(size.x, size.y), 500.0) << file;
  }
}

}  // namespace
}  // namespace waywright
