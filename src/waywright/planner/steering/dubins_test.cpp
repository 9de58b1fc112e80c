#include "waywright/planner/steering/dubins.hpp"

#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>

#include <cmath>
#include <set>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

Pose random_pose(Random& random, double scale) {
  return {random.uniform(-scale, scale), random.uniform(-scale, scale), random.uniform(-pi, pi)};
}

std::string kind(const DubinsWord& word) {
  std::string text;
  for (std::size_t i = 0; i < word.count; ++i) text += word.parts[i].side > 0 ? 'L' : word.parts[i].side < 0 ? 'R' : 'S';
  return text;
}

TEST(Dubins, EndsAreHitForwardsAloneWithinTheRadius) {
  Random random{31};
  std::set<std::string> kinds;
  for (int i = 0; i < 20000; ++i) {
    const double radius = random.uniform(0.2, 3.0);
    const Dubins curves{radius};
    const Pose from = random_pose(random, i % 2 == 0 ? 2.0 * radius : 10.0), to = random_pose(random, i % 2 == 0 ? 2.0 * radius : 10.0);
    const Pieces pieces = curves.between(from, to);
    ASSERT_FALSE(pieces.empty());
    EXPECT_LT(distance(start_pose(pieces.front()).position(), from.position()), 1e-12);
    EXPECT_LT(distance(end_pose(pieces.back()).position(), to.position()), 1e-9);
    EXPECT_LT(std::abs(shorter_turn(end_pose(pieces.back()).heading, to.heading)), 1e-9);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      EXPECT_EQ(pieces[k].direction, 1);
      if (const auto* arc = std::get_if<Arc>(&pieces[k].curve)) {
        EXPECT_EQ(std::abs(arc->curvature), 1.0 / radius);
      }
      if (k > 0) {
        EXPECT_LT(distance(end_pose(pieces[k - 1]).position(), start_pose(pieces[k]).position()), 1e-12);
      }
    }
    EXPECT_NEAR(length(Path{pieces}), curves.distance(from, to), 1e-9);
    kinds.insert(kind(curves.shortest(from, to)));
  }
  for (const char* word : {"LSL", "RSR", "LSR", "RSL", "LRL", "RLR"}) EXPECT_TRUE(kinds.contains(word)) << word;
}

TEST(Dubins, NeverShorterThanReedsSheppOrTheStraightLine) {
  Random random{32};
  for (int i = 0; i < 20000; ++i) {
    const double radius = random.uniform(0.2, 3.0);
    const Pose from = random_pose(random, 5.0), to = random_pose(random, 5.0);
    const double metres = Dubins{radius}.distance(from, to);
    EXPECT_GE(metres, ReedsShepp{radius}.distance(from, to) - 1e-9);
    EXPECT_GE(metres, distance(from.position(), to.position()) - 1e-9);
  }
}

TEST(Dubins, MirroredOrDrivenBackwardsInTimeItIsAsLong) {
  Random random{33};
  const auto mirrored = [](const Pose& p) { return Pose{p.x, -p.y, wrap(-p.heading)}; };
  const auto about = [](const Pose& p) { return Pose{p.x, p.y, wrap(p.heading + pi)}; };
  for (int i = 0; i < 20000; ++i) {
    const Dubins curves{random.uniform(0.2, 3.0)};
    const Pose from = random_pose(random, 4.0), to = random_pose(random, 4.0);
    const double metres = curves.distance(from, to);
    EXPECT_NEAR(curves.distance(mirrored(from), mirrored(to)), metres, 1e-9);
    EXPECT_NEAR(curves.distance(about(to), about(from)), metres, 1e-9);
  }
}

TEST(Dubins, SpecialPoses) {
  const Dubins curves{2.0};
  EXPECT_TRUE(curves.between({1, 2, 0.3}, {1, 2, 0.3}).empty());
  EXPECT_NEAR(curves.distance({0, 0, 0.0}, {7, 0, 0.0}), 7.0, 1e-12);
  EXPECT_EQ(curves.between({0, 0, 0.0}, {7, 0, 0.0}).size(), 1u);
  EXPECT_NEAR(curves.distance({0, 0, 0.0}, {0, 4, pi}), 2.0 * pi, 1e-9);          // half a circle
  EXPECT_EQ(curves.between({0, 0, 0.0}, {2, 2, 0.5 * pi}).size(), 1u);            // a quarter of one
  EXPECT_NEAR(curves.distance({0, 0, 0.0}, {-1e-3, 0, 0.0}), 4.0 * pi, 0.01);     // there is no way back but round
  EXPECT_NEAR(curves.distance({0, 0, 0.0}, {0, 0, pi}), 2.0 * (pi / 3.0 * 2.0 + 5.0 * pi / 3.0), 1e-9);  // turned about: 60°, 300°, 60°
}

/// The shorter the straight part, the less is known of its direction: no turn beside it may become a full one.
TEST(Dubins, NoWayIsLongerThanOneOfAnArcAndAStraightPartHoweverShort) {
  Random random{35};
  for (int i = 0; i < 100000; ++i) {
    const double radius = random.uniform(0.2, 3.0);
    const Dubins curves{radius};
    const Pose from = random_pose(random, 10.0);
    const double turn = random.uniform(0.0, 3.0), way = radius * std::pow(10.0, random.uniform(-12.0, 0.0));
    const TurningPart arc{random.uniform() < 0.5 ? 1 : -1, turn}, line{0, way / radius};
    const auto parts = i % 2 == 0 ? std::array{arc, line} : std::array{line, arc};
    Pose to = from;
    for (const TurningPart& part : parts) {
      const double heading = to.heading + 0.5 * part.side * part.length;
      const double chord = radius * (part.side == 0 ? part.length : 2.0 * std::sin(0.5 * part.length));
      to = make_pose(to.position() + chord * unit(heading), wrap(to.heading + part.side * part.length));
    }
    ASSERT_LE(curves.distance(from, to), radius * turn + way + 1e-8) << "turn " << turn << ", way " << way;
  }
}

TEST(Dubins, AsLongAsTheLibrarysOfOthers) {
  namespace ob = ompl::base;
  Random random{34};
  for (int i = 0; i < 5000; ++i) {
    const double radius = random.uniform(0.3, 2.0);
    ob::DubinsStateSpace theirs{radius};
    const Pose from = random_pose(random, 4.0), to = random_pose(random, 4.0);
    ob::State* a = theirs.allocState();
    ob::State* b = theirs.allocState();
    for (const auto& [state, pose] : {std::pair{a, from}, std::pair{b, to}}) {
      state->as<ob::SE2StateSpace::StateType>()->setXY(pose.x, pose.y);
      state->as<ob::SE2StateSpace::StateType>()->setYaw(pose.heading);
    }
    EXPECT_NEAR(Dubins{radius}.distance(from, to), theirs.distance(a, b), 1e-5);
    theirs.freeState(a);
    theirs.freeState(b);
  }
}

}  // namespace
}  // namespace waywright
