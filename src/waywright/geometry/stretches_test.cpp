#include "waywright/geometry/stretches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

Ring star(Random& random, Vec2 middle) {
  Ring ring;
  const auto corners = random.integer(3, 9);
  for (std::int64_t i = 0; i < corners; ++i) ring.push_back(middle + random.uniform(0.3, 2.0) * unit(two_pi * static_cast<double>(i) / static_cast<double>(corners)));
  return ring;
}

// Each point of the way is in a stretch exactly where it is as deep as that.
TEST(Stretches, HoldThePointsThatAreDeepEnough) {
  Random random{5};
  int inside = 0, outside = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec2 far = i % 3 == 0 ? Vec2{random.uniform(-1e4, 1e4), random.uniform(-1e4, 1e4)} : Vec2{};
    const Ring ring = star(random, far);
    const double depth = i % 2 == 0 ? 1e-3 : random.uniform(0.01, 0.3);
    const Vec2 from = far + Vec2{random.uniform(-2, 2), random.uniform(-2, 2)}, to = far + Vec2{random.uniform(-2, 2), random.uniform(-2, 2)};
    const auto found = stretches_deeper_than(ring, depth, from, to);
    for (std::size_t k = 1; k < found.size(); ++k) ASSERT_LE(found[k - 1].end, found[k].begin);
    for (int k = 0; k <= 200; ++k) {
      const double share = k / 200.0;
      const double deep = depth_in(ring, from + share * (to - from));
      if (std::abs(deep - depth) < 1e-9) continue;
      const bool is_in = std::any_of(found.begin(), found.end(), [&](const WayPart& s) { return share >= s.begin && share <= s.end; });
      ASSERT_EQ(is_in, deep > depth) << i << " at " << share;
      ++(is_in ? inside : outside);
    }
  }
  EXPECT_GT(inside, 5000);
  EXPECT_GT(outside, 5000);
}

TEST(Stretches, AlongAnEdgeThereIsNone) {
  const Ring square = rectangle({0, 0}, {4, 4});
  EXPECT_TRUE(stretches_deeper_than(square, 1e-3, {-1, 0}, {5, 0}).empty());
  EXPECT_TRUE(stretches_deeper_than(square, 1e-3, {-1, 0.0009}, {5, 0.0009}).empty());
  const auto found = stretches_deeper_than(square, 1e-3, {-1, 0.0011}, {5, 0.0011});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].begin, 1.001 / 6.0, 1e-12);
  EXPECT_NEAR(found[0].end, 4.999 / 6.0, 1e-12);
}

TEST(Stretches, OfAPointAreAllOrNothing) {
  const Ring square = rectangle({0, 0}, {4, 4});
  EXPECT_EQ(stretches_deeper_than(square, 1e-3, {2, 2}, {2, 2}).size(), 1U);
  EXPECT_TRUE(stretches_deeper_than(square, 1e-3, {4, 2}, {4, 2}).empty());
}

}  // namespace
}  // namespace waywright
