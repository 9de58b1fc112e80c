#include <gtest/gtest.h>

#include "waywright/curve/bezier.hpp"
#include "waywright/path/path.hpp"

namespace waywright {
namespace {

Path every_kind() {
  const Spline spline{SplineKind::quintic, {straight_ended_quintic({0, 0}, {2, 0}, {2, 1}, {1, 2})}};
  const Piece first{spline, -1};
  const Pose a = end_pose(first);
  const Piece line{Line{a.position(), a.position() + 1.5 * unit(a.heading)}, 1};
  const Pose b = end_pose(line);
  const Piece turn{Turn{b.position(), b.heading, -0.7}, 0};
  const Pose c = end_pose(turn);
  const Piece arc{Arc{make_pose(c.position(), c.heading), 0.4, 2.0}, 1};
  const Pose d = end_pose(arc);
  const Piece poses{PoseSequence{{d, make_pose(d.position() + 0.1 * unit(d.heading), d.heading + 0.01)}}, 1};
  return {{first, line, turn, arc, poses}};
}

TEST(Reversed, PassesTheSamePosesTheOtherWay) {
  const Path path = every_kind();
  const Path back = reversed(path);
  const auto forth = sample(path, 1.0, 0.001);
  auto other = sample(back, 1.0, 0.001);
  EXPECT_NEAR(length(path), length(back), 1e-12);
  ASSERT_EQ(other.size(), forth.size());
  for (std::size_t i = 0; i < forth.size(); ++i) {
    const Sample& f = forth[i];
    const Sample& o = other[other.size() - 1 - i];
    EXPECT_NEAR(distance(f.pose().position(), o.pose().position()), 0.0, 1e-3) << i;
    EXPECT_NEAR(shorter_turn(f.heading, o.heading), 0.0, 2e-3) << i;
    EXPECT_EQ(f.direction, -o.direction) << i;
  }
  EXPECT_NEAR(distance(start_pose(back).position(), end_pose(path).position()), 0.0, 1e-12);
  EXPECT_NEAR(shorter_turn(start_pose(back).heading, end_pose(path).heading), 0.0, 1e-12);
}

TEST(Reversed, TwiceIsTheSame) {
  const Path path = every_kind();
  const Path twice = reversed(reversed(path));
  ASSERT_EQ(twice.pieces.size(), path.pieces.size());
  const auto a = sample(path, 1.0, 0.001), b = sample(twice, 1.0, 0.001);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(distance(a[i].pose().position(), b[i].pose().position()), 0.0, 1e-12);
    EXPECT_NEAR(shorter_turn(a[i].heading, b[i].heading), 0.0, 1e-12);
    EXPECT_EQ(a[i].direction, b[i].direction);
  }
}

}  // namespace
}  // namespace waywright
