#include "waywright/scenario/moving_obstacle.hpp"

#include <gtest/gtest.h>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

MovingObstacle cart() {
  MovingObstacle obstacle;
  obstacle.footprint = {rectangle({-0.5, -0.2}, {1.0, 0.2}), 0.0};
  obstacle.track = {{1.0, {0, 0, 3.0}}, {3.0, {4, 0, -3.0}}, {4.0, {4, 2, 0.0}}};
  obstacle.velocity = {0.5, 0.0};
  return obstacle;
}

TEST(MovingObstacle, GoesStraightBetweenItsPlacesAndOnAfterTheLast) {
  const MovingObstacle c = cart();
  EXPECT_EQ(c.at(0.0), (Pose{0, 0, 3.0}));
  EXPECT_EQ(c.at(2.0).position(), (Vec2{2, 0}));
  EXPECT_NEAR(std::abs(c.at(2.0).heading), pi, 1e-12);  // the shorter way
  EXPECT_EQ(c.at(3.5).position(), (Vec2{4, 1}));
  EXPECT_EQ(c.at(6.0), (Pose{5, 2, 0.0}));
  EXPECT_FALSE(c.stands_from());
  MovingObstacle stays = cart();
  stays.velocity = {};
  EXPECT_EQ(stays.stands_from(), 4.0);
}

TEST(MovingObstacle, SeenLaterItIsTheSame) {
  const MovingObstacle c = cart();
  for (const double now : {0.0, 0.5, 1.0, 2.2, 3.0, 3.9, 4.0, 9.0}) {
    const MovingObstacle later = seen_from(c, now);
    EXPECT_GE(later.track.front().t, 0.0);
    for (double t = 0.0; t < 8.0; t += 0.13) {
      const Pose is = later.at(t), should = c.at(now + t);
      EXPECT_NEAR(distance(is.position(), should.position()), 0.0, 1e-12) << now << " " << t;
      EXPECT_NEAR(shorter_turn(is.heading, should.heading), 0.0, 1e-12);
    }
    for (std::size_t i = 1; i < later.track.size(); ++i) EXPECT_GT(later.track[i].t, later.track[i - 1].t);
  }
}

TEST(MovingObstacle, NoPointOfItLeavesWhatBoundsIt) {
  const MovingObstacle c = cart();
  const MovingPlaces places{c};
  Random random{3};
  for (int i = 0; i < 500; ++i) {
    const double begin = random.uniform(0.0, 6.0), end = begin + random.uniform(0.0, 2.0);
    const MovingPlaces::Stretch stretch = places.between(begin, end);
    for (double t = begin; t <= end; t += 0.05) {
      for (const Vec2 p : c.footprint.polygon) {
        EXPECT_LE(distance(Frame{stretch.pose}.to_world(p), Frame{c.at(t)}.to_world(p)), stretch.reach + 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace waywright
