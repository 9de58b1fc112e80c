#include "waywright/io/obstacles_io.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace waywright {
namespace {

std::string sentence_of(const std::string& text) {
  const auto seen = parse_obstacles(text, "o.json");
  return seen ? "accepted" : seen.error().message();
}

std::string with(const std::string& fields) { return R"({"format":"waywright-obstacles/1",)" + fields + "}"; }

TEST(ObstaclesIo, IsReadAndWrittenWhole) {
  const std::string text = with(R"("obstacles":[[[0,0],[1,0],[1,1]]],"lines":[[[0,0],[2,0]]],"points":[[3,3]],
    "moving":[{"name":"cart","footprint":[[0,0],[1,0],[1,1]],"velocity":[0.5,0]},
              {"footprint":{"disc":0.3},"track":[[0,1,2],[1.5,2,2,7],[4,2,3]],"spread":0.1,"range":2,"free_for":0.5,"patience":30}])");
  const auto seen = parse_obstacles(text, "o.json");
  ASSERT_TRUE(seen) << seen.error().message();
  EXPECT_EQ(seen->still.obstacles.size(), 1U);
  EXPECT_EQ(seen->still.lines.size(), 1U);
  EXPECT_EQ(seen->still.points.size(), 1U);
  ASSERT_EQ(seen->moving.size(), 2U);
  EXPECT_EQ(seen->moving[0].at(2.0).position(), (Vec2{1.0, 0.0}));
  EXPECT_EQ(seen->moving[0].range, 1.0);
  EXPECT_EQ(seen->moving[0].free_for, 1.0);
  EXPECT_EQ(seen->moving[0].patience, 10.0);
  EXPECT_NEAR(seen->moving[1].track[1].pose.heading, 7.0 - two_pi, 1e-15);
  EXPECT_EQ(seen->moving[1].spread, 0.1);
  const auto again = parse_obstacles(obstacles_json(*seen), "again.json");
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_EQ(obstacles_json(*again), obstacles_json(*seen));
}

TEST(ObstaclesIo, BadInputGetsOneSentence) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {R"([])", R"(o.json: it is an array (allowed: an object))"},
      {R"({})", R"(o.json: format: the field is missing (allowed: waywright-obstacles/1))"},
      {R"({"format":"waywright-scenario/1"})", R"(o.json: format: "waywright-scenario/1" is not a format that can be read here (allowed: waywright-obstacles/1))"},
      {R"({"format":"waywright-obstacles/1"})", R"(o.json: it holds no obstacle (allowed: at least one of obstacles, lines, points, moving))"},
      {with(R"("obstacle":[])"), R"(o.json: obstacle: unknown field, did you mean "obstacles"? (allowed: format, obstacles, lines, points, moving))"},
      {with(R"("obstacles":[[[0,0],[1,1],[1,0],[0,1]]])"), R"(o.json: obstacles[0]: edges 0 and 2 cross at (0.5, 0.5) (allowed: a simple polygon of at least 3 corners with an area))"},
      {with(R"("points":[[1e7,0]])"), R"(o.json: points[0][0]: 10000000 is out of range (allowed: -1000000 to 1000000))"},
      {with(R"("moving":{})"), R"(o.json: moving: it is an object (allowed: an array))"},
      {with(R"("moving":[7])"), R"(o.json: moving[0]: it is a number (allowed: an object))"},
      {with(R"("moving":[{}])"), R"(o.json: moving[0].footprint: the field is missing (allowed: a polygon [[x, y], ...] or {"disc": radius}))"},
      {with(R"("moving":[{"footprint":{"disc":-1}}])"), R"(o.json: moving[0].footprint.disc: -1 is out of range (allowed: 0 to 1000000))"},
      {with(R"("moving":[{"footprint":{"disc":1},"track":[]}])"), R"(o.json: moving[0].track: a track without points (allowed: at least one [t, x, y] or [t, x, y, heading]))"},
      {with(R"("moving":[{"footprint":{"disc":1},"track":[[0,1]]}])"), R"(o.json: moving[0].track[0]: it has 2 elements (allowed: [t, x, y] or [t, x, y, heading]))"},
      {with(R"("moving":[{"footprint":{"disc":1},"track":[[-1,1,1]]}])"), R"(o.json: moving[0].track[0][0]: -1 is out of range (allowed: 0 to 1000000))"},
      {with(R"("moving":[{"footprint":{"disc":1},"track":[[1,1,1],[1,2,2]]}])"), R"(o.json: moving[0].track[1][0]: 1 s is not after the 1 s of the point before (allowed: times that rise by at least a microsecond))"},
      {with(R"("moving":[{"footprint":{"disc":1},"track":[[1,0,0],[2,5000,0]]}])"), R"(o.json: moving[0].track[1]: it is reached at 5000 m/s (allowed: at most 1000 m/s))"},
      {with(R"("moving":[{"footprint":{"disc":1},"velocity":[1]}])"), R"(o.json: moving[0].velocity: it has 1 element (allowed: [x, y]))"},
      {with(R"("moving":[{"footprint":{"disc":1},"patience":-1}])"), R"(o.json: moving[0].patience: -1 is out of range (allowed: 0 to 1000000))"},
      {with(R"("moving":[{"footprint":{"disc":1},"speed":1}])"), R"(o.json: moving[0].speed: unknown field, did you mean "spread"? (allowed: name, footprint, track, velocity, spread, seen, range, free_for, patience))"},
  };
  for (const auto& [text, sentence] : cases) EXPECT_EQ(sentence_of(text), sentence) << text;
}

TEST(ObstaclesIo, TracksAreBounded) {
  std::string track = "[[0,0,0]";
  for (int i = 1; i < 9000; ++i) track += "," + std::string{"["} + std::to_string(i) + ",0,0]";
  const std::string one = R"({"footprint":{"disc":0.1},"track":)" + track + "]}";
  EXPECT_EQ(sentence_of(with(R"("moving":[)" + one + "," + one + "]")), "accepted");
  EXPECT_EQ(sentence_of(with(R"("moving":[)" + one + "," + one + "," + one + "]")), "o.json: moving: the tracks have too many points (allowed: at most 20000 in all)");
}

}  // namespace
}  // namespace waywright
