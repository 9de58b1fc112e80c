#include <gtest/gtest.h>

#include <cmath>

#include "waywright/io/plan_io.hpp"
#include "waywright/io/test_files.hpp"

namespace waywright {
namespace {

using test::fingerprint;

std::string sentence_of(const std::string& text) {
  const auto path = parse_poses_csv(text, "p.csv");
  return path ? "accepted" : path.error().message();
}

Pieces pieces_of(const std::string& text) {
  const auto path = parse_poses_csv(text, "p.csv");
  EXPECT_TRUE(path) << path.error().message();
  return path ? path->pieces : Pieces{};
}

const std::vector<Pose>& poses_of(const Piece& piece) { return std::get<PoseSequence>(piece.curve).poses; }

TEST(PosesCsv, HeadersOfManyKindsMeanTheSame) {
  const auto expected = fingerprint(pieces_of("x,y,heading,direction\n0,0,0,1\n1,0.5,0.1,1\n"));
  for (const char* text : {
           "\xEF\xBB\xBFx,y,heading,direction\r\n0,0,0,1\r\n1,0.5,0.1,1\r\n",
           "DIR;Theta;Y;X\n1;0;0;0\n1;0.1;0.5;1\n",
           "# made by hand\n\nx\ty\tYaw\tGear\n0\t0\t0\t1\n  \n# half way\n1\t.5\t1e-1\t+1",
           "\"x\", \"y\", \"th\", \"note\", \"direction\"\n0, 0, 0, \"go\", 1.0\n1 , 5e-1, 0.1, , 1\n",
           "t,x,y,heading\n0.0,0,0,0\n0.5,1,0.5,0.1\n",
       }) {
    EXPECT_EQ(fingerprint(pieces_of(text)), expected) << text;
  }
}

TEST(PosesCsv, DirectionIsFoundFromTheMotion) {
  // Forwards one metre, back half of it, forwards again.
  const auto pieces = pieces_of("x,y,heading\n0,0,0\n0.5,0,0\n1,0,0\n0.5,0,0\n0.7,0,0\n");
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].direction, 1);
  EXPECT_EQ(poses_of(pieces[0]).size(), 3U);
  EXPECT_EQ(pieces[1].direction, -1);
  EXPECT_EQ(poses_of(pieces[1]), (std::vector<Pose>{{1, 0, 0}, {0.5, 0, 0}}));
  EXPECT_EQ(pieces[2].direction, 1);
  // The mean heading counts: a step to +y from heading 1.5 to 3.0 goes with (cos, sin)(2.25).
  EXPECT_EQ(pieces_of("x,y,heading\n0,0,1.5\n0,1,3.0\n")[0].direction, 1);
  EXPECT_EQ(pieces_of("x,y,heading\n0,0,3.0\n1,0,-3.0\n")[0].direction, -1)
      << "along the shorter arc, through pi";
}

TEST(PosesCsv, SpeedsAreGivenWhereTheFileTellsThem) {
  std::vector<PoseSpeed> speeds;
  ASSERT_TRUE(parse_poses_csv("x,y,heading,Speed\n0,0,0,\n1,0,0,0.7\n2,0,0,-0.2\n", "p.csv", nullptr, &speeds));
  ASSERT_EQ(speeds.size(), 2U);
  EXPECT_EQ(speeds[0].pose, (Pose{1, 0, 0}));
  EXPECT_EQ(speeds[0].speed, 0.7);
  EXPECT_EQ(speeds[1].speed, -0.2);
  EXPECT_EQ(sentence_of("x,y,heading,speed\n0,0,0,fast\n1,0,0,1\n"), "p.csv: line 2: speed is \"fast\" (allowed: a finite number)");
  EXPECT_EQ(sentence_of("x,y,heading,speed,speed\n0,0,0,1,1\n1,0,0,1,1\n"), "p.csv: line 1: the header names two columns for speed (allowed: one)");
}

TEST(PosesCsv, DirectionOfTheFileIsKept) {
  const auto pieces = pieces_of("x,y,heading,direction\n0,0,0,-1\n0.5,0,0,-1\n");
  EXPECT_EQ(pieces[0].direction, -1) << "for the proof to find fault with";
  // As plan files have it: the pose of the change stands twice.
  const auto twice = pieces_of("x,y,heading,direction\n0,0,0,1\n1,0,0,1\n1,0,0,-1\n0.5,0,0,-1\n");
  ASSERT_EQ(twice.size(), 2U);
  EXPECT_EQ(twice[1].direction, -1);
  EXPECT_EQ(poses_of(twice[1]).size(), 2U);
  // Elsewhere too a pose that stands twice is a stop: the vehicle may steer there.
  const auto stop = pieces_of("x,y,heading\n0,0,0\n1,0,0\n1,0,0\n1,0,0\n1.5,0,0\n2,0,0\n");
  ASSERT_EQ(stop.size(), 2U);
  EXPECT_EQ(stop[1].direction, 1);
  EXPECT_EQ(poses_of(stop[0]).size(), 2U);
  EXPECT_EQ(poses_of(stop[1]).size(), 3U);
  // Rows that differ: some name the motion that begins, some the one that ends.
  for (const char* text : {"x,y,heading,direction\n0,0,0,1\n1,0,0,-1\n0.5,0,0,-1\n",
                           "x,y,heading,direction\n0,0,0,1\n1,0,0,1\n0.5,0,0,-1\n"}) {
    const auto found = pieces_of(text);
    ASSERT_EQ(found.size(), 2U) << text;
    EXPECT_EQ(found[0].direction, 1);
    EXPECT_EQ(found[1].direction, -1);
  }
}

TEST(PosesCsv, TurnsOnTheSpotArePieces) {
  const auto pieces =
      pieces_of("x,y,heading,direction\n0,0,0,1\n1,0,0,1\n1,0,0.5,0\n1,0,1.0,0\n1,0,0.8,0\n1,2,0.8,1\n");
  ASSERT_EQ(pieces.size(), 4U);
  EXPECT_EQ(pieces[1].direction, 0);
  const Turn& left = std::get<Turn>(pieces[1].curve);
  EXPECT_EQ(left.at, (Vec2{1, 0}));
  EXPECT_EQ(left.from, 0.0);
  EXPECT_NEAR(left.angle, 1.0, 1e-15);
  EXPECT_NEAR(std::get<Turn>(pieces[2].curve).angle, -0.2, 1e-15)
      << "there and back is two turns, not their difference";
  EXPECT_EQ(pieces[3].direction, 1);
  // A turn of more than half a circle stays what it was.
  std::string circle = "x,y,th\n0,0,0\n";
  for (int i = 1; i <= 10; ++i) circle += fmt::format("0,0,{}\n", 0.5 * i);
  const auto turned = pieces_of(circle);
  ASSERT_EQ(turned.size(), 1U);
  EXPECT_NEAR(std::get<Turn>(turned[0].curve).angle, 5.0, 1e-12);
  EXPECT_NEAR(end_pose(turned[0]).heading, 5.0 - two_pi, 1e-12);
}

TEST(PosesCsv, PiecesJoinWithoutGaps) {
  const auto path = parse_poses_csv(
      "x,y,heading\n0,0,0\n0,0,0\n1,0,0.1\n1.0000001,0,0.4\n1.0000002,0,0.4\n0.5,0,0.4\n0.5,0,-3\n0.2,0.1,-"
      "3\n",
      "p");
  ASSERT_TRUE(path);
  for (std::size_t i = 1; i < path->pieces.size(); ++i) {
    const Pose a = end_pose(path->pieces[i - 1]);
    const Pose b = start_pose(path->pieces[i]);
    EXPECT_EQ(a.position(), b.position());
    EXPECT_NEAR(shorter_turn(a.heading, b.heading), 0.0, 1e-12);
  }
  EXPECT_EQ(start_pose(*path), (Pose{0, 0, 0}));
  EXPECT_EQ(end_pose(*path), (Pose{0.2, 0.1, -3}));
}

TEST(PosesCsv, StepsTooSmallToBeAMotionAddUp) {
  std::string text = "x,y,heading\n";
  for (int i = 0; i <= 10'000; ++i) text += fmt::format("{},0,0\n", 1e-7 * i);
  const auto pieces = pieces_of(text);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_NEAR(length(pieces[0]), 1e-3, 2e-6);
}

TEST(PosesCsv, HeadingsAreWrapped) {
  EXPECT_NEAR(poses_of(pieces_of("x,y,heading\n0,0,6.5\n1,0,-12.5\n")[0])[0].heading, 6.5 - two_pi, 1e-12);
}

TEST(PosesCsv, HeadingsInDegreesAreTakenWhereTheColumnSaysSo) {
  std::vector<std::string> notes;
  const auto degrees = parse_poses_csv("x,y,Yaw_deg\n0,0,90\n0,1,450\n", "p.csv", &notes);
  ASSERT_TRUE(degrees);
  EXPECT_NEAR(start_pose(*degrees).heading, pi / 2, 1e-12);
  EXPECT_NEAR(end_pose(*degrees).heading, pi / 2, 1e-12);
  EXPECT_TRUE(notes.empty());
  // Read as they stand, and doubted.
  const auto radians = parse_poses_csv("x,y,heading\n0,0,6.28\n0,1,90\n0,2,90\n", "d/p.csv", &notes);
  ASSERT_TRUE(radians);
  EXPECT_NEAR(end_pose(*radians).heading, wrap(90.0), 1e-12);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0], "p.csv: line 3: heading: 90 rad is more than a whole turn and is taken as 2.0354 rad (116.6°); headings are in radians: 90° would be 1.5708; so are 1 more; a column "
                      "heading_deg takes degrees");
}

TEST(BadPoses, CellsBeyondTheHeaderAreRefused) {
  // A decimal comma would shift the cells: 1,5 is not x = 1.
  EXPECT_EQ(sentence_of("x,y,heading\n1,5,0,0\n"),
            "p.csv: line 2: there are 4 cells, and the header names 3 (allowed: no more cells than columns; a cell that holds the separator stands in double quotes)");
}

TEST(BadPoses, AreOneSentenceWithTheLine) {
  const std::string columns =
      " (allowed: x, y, heading (or theta, yaw, th; heading_deg for degrees) and optionally direction (or dir, gear))";
  EXPECT_EQ(sentence_of(""),
            "p.csv: the file is empty: there is no header (allowed: a header that names x, y, heading and "
            "optionally direction)");
  EXPECT_EQ(sentence_of("# nothing\n\n"),
            "p.csv: the file is empty: there is no header (allowed: a header that names x, y, heading and "
            "optionally direction)");
  EXPECT_EQ(sentence_of("0,0,0\n1,0,0\n"), "p.csv: line 1: the header names no column \"x\"" + columns);
  EXPECT_EQ(sentence_of("x,y,angle\n"), "p.csv: line 1: the header names no column \"heading\"" + columns);
  EXPECT_EQ(sentence_of("x,y,heading,yaw\n"),
            "p.csv: line 1: the header names two columns for heading (allowed: one)");
  EXPECT_EQ(sentence_of("x,y,heading\n0,zero,0\n"),
            "p.csv: line 2: y is \"zero\" (allowed: a finite number)");
  EXPECT_EQ(sentence_of("x,y,heading\n0,0,0\n\n0,0\n"),
            "p.csv: line 4: heading is missing (allowed: a number)");
  EXPECT_EQ(sentence_of("x,y,heading\n,0,0\n"), "p.csv: line 2: x is missing (allowed: a number)");
  for (const char* bad : {"nan", "inf", "-Infinity", "1e999", "0x10", "1,5", "--1", "+-1", "+", "1 2"}) {
    EXPECT_NE(sentence_of(fmt::format("x;y;heading\n{};0;0\n1;0;0\n", bad)).find("p.csv: line 2: x is \""),
              std::string::npos)
        << bad;
  }
  EXPECT_EQ(sentence_of("x,y,heading\n1000001,0,0\n"),
            "p.csv: line 2: x of 1000001 is out of range (allowed: -1000000 to 1000000)");
  EXPECT_EQ(sentence_of("x,y,heading,gear\n0,0,0,2\n"), "p.csv: line 2: direction is 2 (allowed: 1, -1, 0)");
  EXPECT_EQ(sentence_of("x,y,heading\n"),
            "p.csv: there are fewer than two different poses (allowed: at least two)");
  EXPECT_EQ(sentence_of("x,y,heading\n1,2,3\n1,2,3\n"),
            "p.csv: there are fewer than two different poses (allowed: at least two)");
  EXPECT_EQ(sentence_of("x,y,heading\n" + std::string(70'000, ',')),
            "p.csv: line 2: the line is too long (allowed: at most 65536 bytes)");
  EXPECT_NE(sentence_of(std::string("\x00\xff\x89PNG\r\n", 8)).find("p.csv: line 1: "), std::string::npos);
}

TEST(BadPoses, RowsAreBounded) {
  std::string text = "x,y,heading\n";
  for (int i = 0; i < 500'000; ++i) text += "0,0,0\n1,0,0\n";
  EXPECT_EQ(sentence_of(text), "accepted");
  EXPECT_EQ(sentence_of(text + "0,0,0\n"),
            "p.csv: line 1000002: there are too many rows (allowed: at most 1000000)");
}

}  // namespace
}  // namespace waywright
