#include "waywright/planner/steering/reeds_shepp.hpp"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <cmath>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

constexpr double radius = 1.25;

Pose random_pose(Random& random, double scale) {
  return {random.uniform(-scale, scale), random.uniform(-scale, scale), wrap(random.uniform(-4.0, 4.0))};
}

double total(const Pieces& pieces) { return length(Path{pieces}); }

TEST(ReedsShepp, PiecesJoinAndEndOnTheGoal) {
  const ReedsShepp curves{radius};
  Random random{3};
  for (const double scale : {0.01, 1.0, 5.0, 100.0, 1e4}) {
    for (int i = 0; i < 4000; ++i) {
      const Pose from = random_pose(random, scale);
      Pose to = random_pose(random, scale);
      if (i % 4 == 1) to.heading = wrap(from.heading + pi);
      if (i % 4 == 2)
        to = make_pose(from.position() + random.uniform(-scale, scale) * unit(from.heading), from.heading);
      if (i % 4 == 3) to.heading = pi;
      Pose at = from;
      for (const Piece& piece : curves.between(from, to)) {
        EXPECT_LT(distance(start_pose(piece).position(), at.position()), 1e-11 * (1.0 + scale));
        EXPECT_LT(std::abs(shorter_turn(start_pose(piece).heading, at.heading)), 1e-11);
        at = end_pose(piece);
        if (const auto* arc = std::get_if<Arc>(&piece.curve)) {
          EXPECT_EQ(std::abs(arc->curvature), 1.0 / radius);
          EXPECT_GT(arc->length, 0.0);
        }
      }
      ASSERT_LT(distance(at.position(), to.position()), 1e-9) << "scale " << scale << ", pair " << i;
      ASSERT_LT(std::abs(shorter_turn(at.heading, to.heading)), 1e-9);
    }
  }
}

TEST(ReedsShepp, LengthIsThatOfAnotherImplementationAndTheSameBothWays) {
  const ReedsShepp curves{radius};
  namespace ob = ompl::base;
  auto space = std::make_shared<ob::ReedsSheppStateSpace>(radius);
  ob::ScopedState<ob::ReedsSheppStateSpace> a{space};
  ob::ScopedState<ob::ReedsSheppStateSpace> b{space};
  Random random{4};
  for (int i = 0; i < 5000; ++i) {
    const Pose from = random_pose(random, 6.0);
    const Pose to = random_pose(random, 6.0);
    a->setXY(from.x, from.y);
    a->setYaw(from.heading);
    b->setXY(to.x, to.y);
    b->setYaw(to.heading);
    const double metres = total(curves.between(from, to));
    ASSERT_NEAR(metres, space->distance(a.get(), b.get()), 1e-9);
    ASSERT_NEAR(metres, total(curves.between(to, from)), 1e-9);
    ASSERT_GE(metres, distance(from.position(), to.position()) - 1e-9);
    ASSERT_GE(metres, radius * std::abs(shorter_turn(from.heading, to.heading)) - 1e-9);
    // Triangle inequality over a third pose: the curves are shortest.
    const Pose by = random_pose(random, 6.0);
    ASSERT_LE(metres, curves.distance(from, by) + curves.distance(by, to) + 1e-9);
  }
}

/// Between near ends an angle is all rounding: a short straight part beside an arc must not be lost to it.
TEST(ReedsShepp, NoWayIsLongerThanOneOfAnArcAndAStraightPartHoweverShort) {
  Random random{6};
  for (int i = 0; i < 100000; ++i) {
    const double metres = random.uniform(0.2, 3.0);
    const ReedsShepp curves{metres};
    const Pose from = random_pose(random, 10.0);
    const double turn = random.uniform(-1.5, 1.5) * (i % 4 == 0 ? 1e-6 : 1.0), way = std::pow(10.0, random.uniform(-12.0, 0.0)) * (random.uniform() < 0.5 ? -1.0 : 1.0);
    const int side = random.uniform() < 0.5 ? 1 : -1;
    const auto parts = i % 2 == 0 ? std::array{TurningPart{side, turn}, TurningPart{0, way}} : std::array{TurningPart{0, way}, TurningPart{side, turn}};
    Pose to = from;
    for (const TurningPart& part : parts) {
      const double chord = metres * (part.side == 0 ? part.length : 2.0 * std::sin(0.5 * part.length));
      to = make_pose(to.position() + chord * unit(to.heading + 0.5 * part.side * part.length), wrap(to.heading + part.side * part.length));
    }
    // Rounding to the side costs its root.
    ASSERT_LE(curves.distance(from, to), metres * (std::abs(turn) + std::abs(way)) + 5e-7) << "turn " << turn << ", way " << way;
  }
}

TEST(ReedsShepp, KnownShortestCurves) {
  const ReedsShepp curves{radius};
  const Pose origin{};
  // Straight ahead, straight back.
  for (const double way : {3.0, -3.0}) {
    const auto pieces = curves.between(origin, {way, 0.0, 0.0});
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<Line>(pieces[0].curve));
    EXPECT_EQ(pieces[0].direction, way > 0.0 ? 1 : -1);
    EXPECT_NEAR(total(pieces), 3.0, 1e-12);
  }
  // A quarter circle to the left; backwards the same bends the course to the other side.
  const auto left = curves.between(origin, {radius, radius, 0.5 * pi});
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(std::get<Arc>(left[0].curve).curvature, 1.0 / radius);
  const auto back = curves.between(origin, {-radius, radius, -0.5 * pi});
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(back[0].direction, -1);
  EXPECT_EQ(std::get<Arc>(back[0].curve).curvature, -1.0 / radius);
  EXPECT_NEAR(total(back), 0.5 * pi * radius, 1e-12);
  // Facing about on the spot: three arcs of 60 degrees.
  const auto about = curves.between(origin, {0.0, 0.0, pi});
  EXPECT_EQ(about.size(), 3u);
  EXPECT_NEAR(total(about), pi * radius, 1e-9);
  EXPECT_TRUE(curves.between(origin, origin).empty());
}

TEST(ReedsShepp, PartsOfAPathJoinToTheWhole) {
  const ReedsShepp curves{radius};
  Random random{5};
  for (int i = 0; i < 500; ++i) {
    const auto pieces = curves.between(random_pose(random, 5.0), random_pose(random, 5.0));
    const double whole = total(pieces);
    const double at = random.uniform(0.0, whole);
    const auto first = part_of(pieces, 0.0, at);
    const auto second = part_of(pieces, at, whole);
    ASSERT_NEAR(total(first), at, 1e-8);
    ASSERT_NEAR(total(first) + total(second), whole, 1e-8);
    if (first.empty() || second.empty()) continue;
    const Pose middle = pose_at(pieces, at);
    EXPECT_LT(distance(end_pose(first.back()).position(), middle.position()), 1e-8);
    EXPECT_LT(distance(start_pose(second.front()).position(), middle.position()), 1e-8);
    EXPECT_LT(std::abs(shorter_turn(end_pose(first.back()).heading, middle.heading)), 1e-8);
    Pieces joined;
    for (const auto* part : {&first, &second}) {
      for (const Piece& piece : *part) append_merged(joined, piece);
    }
    EXPECT_EQ(joined.size(), pieces.size());
    EXPECT_NEAR(total(joined), whole, 1e-8);
  }
}

}  // namespace
}  // namespace waywright
