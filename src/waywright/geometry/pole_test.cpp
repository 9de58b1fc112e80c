// The point inside a polygon that is farthest from its outline.
#include "waywright/geometry/pole.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

TEST(Pole, OfConvexShapesIsTheirCentre) {
  EXPECT_LT(distance(pole_of_inaccessibility(rectangle({1e4, 2}, {1e4 + 8, 4}), 0.01), {1e4 + 4, 3}), 1e-9);
  EXPECT_LT(distance(pole_of_inaccessibility({{0, 0}, {3, 0}, {0, 4}}, 1e-4), {1, 1}), 0.02);  // the inscribed circle's middle, radius 1
}

// The middle of the box of a U, an L and a crescent lies outside of them, or at their edge.
TEST(Pole, OfConcaveShapesIsDeepInside) {
  const Ring u{{0, 0}, {10, 0}, {10, 8}, {8, 8}, {8, 3}, {2, 3}, {2, 8}, {0, 8}};
  const Vec2 in_u = pole_of_inaccessibility(u, 0.01);
  EXPECT_GT(inner_radius(u, in_u), 1.49);
  const Ring l{{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}};
  EXPECT_GT(inner_radius(l, pole_of_inaccessibility(l, 0.001)), 0.58);  // at the bend: 2 − √2 = 0.586
  Ring crescent;
  for (int i = 0; i <= 40; ++i) crescent.push_back(5.0 * unit(pi * i / 40.0));
  for (int i = 39; i > 0; --i) crescent.push_back(Vec2{0.0, -1.0} + 5.0 * unit(pi * i / 40.0));
  EXPECT_GT(inner_radius(crescent, pole_of_inaccessibility(crescent, 0.01)), 0.47);
}

// Of stars with random corners no point of a fine grid lies deeper.
TEST(Pole, IsDeeperThanAnyPointOfAGrid) {
  Random random{7};
  for (int round = 0; round < 30; ++round) {
    Ring ring;
    const int corners = 5 + round % 9;
    for (int i = 0; i < corners; ++i) ring.push_back(random.uniform(0.5, 4.0) * unit(two_pi * i / corners));
    const double depth = inner_radius(ring, pole_of_inaccessibility(ring, 0.01));
    for (int i = 0; i <= 60; ++i) {
      for (int k = 0; k <= 60; ++k) ASSERT_LE(inner_radius(ring, {-4.0 + i * 8.0 / 60.0, -4.0 + k * 8.0 / 60.0}), depth + 0.0101) << round;
    }
  }
}

TEST(Pole, OfWhatHasNoAreaIsTheMeanOfItsCorners) {
  EXPECT_EQ(pole_of_inaccessibility({{2, 3}}, 0.01), (Vec2{2, 3}));
  EXPECT_EQ(pole_of_inaccessibility({{0, 0}, {4, 0}, {2, 0}}, 0.01), (Vec2{2, 0}));
}

}  // namespace
}  // namespace waywright
