#include "waywright/geometry/boolean.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

const Ring square = rectangle({0, 0}, {2, 2});

double area_of(const std::vector<Ring>& rings) {
  double area = 0.0;
  for (const Ring& ring : rings) area += signed_area(ring);
  return area;
}

TEST(Boolean, Joined) {
  const auto both = joined(square, rectangle({1, 0.5}, {3, 1.5}));
  ASSERT_TRUE(both);
  EXPECT_NEAR(signed_area(*both), 5.0, 1e-12);
  EXPECT_FALSE(joined(square, rectangle({3, 0}, {4, 1}))) << "two pieces";
  const Ring u{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  EXPECT_FALSE(joined(u, rectangle({0, 2.5}, {3, 3.5}))) << "a hole";
  EXPECT_NEAR(signed_area(*joined(square, rectangle({0.5, 0.5}, {1, 1}))), 4.0, 1e-12) << "one inside the other";
}

TEST(Boolean, Without) {
  EXPECT_TRUE(without(square, rectangle({-1, -1}, {3, 3}))->empty());
  const auto halves = without(square, rectangle({0.5, -1}, {1.5, 3}));
  ASSERT_TRUE(halves);
  EXPECT_EQ(halves->size(), 2U);
  EXPECT_NEAR(area_of(*halves), 2.0, 1e-12);
  EXPECT_FALSE(without(square, rectangle({0.5, 0.5}, {1, 1}))) << "a hole";
  EXPECT_NEAR(area_of(*without(square, rectangle({5, 5}, {6, 6}))), 4.0, 1e-12) << "apart";
}

TEST(Boolean, WithoutSeveralKeepsHoles) {
  const auto left = without(square, std::vector<Ring>{rectangle({0.5, 0.5}, {0.8, 1}), rectangle({0.7, 0.5}, {1, 1}), rectangle({1.5, -1}, {1.6, 3})});
  ASSERT_TRUE(left);
  ASSERT_EQ(left->size(), 2U);
  const Region& holed = left->front().holes.empty() ? left->back() : left->front();
  ASSERT_EQ(holed.holes.size(), 1U);
  EXPECT_NEAR(signed_area(holed.holes.front()), 0.25, 1e-12);
  EXPECT_NEAR(signed_area(holed.outer), 3.0, 1e-12);
  EXPECT_FALSE(without(square, std::vector<Ring>{rectangle({0.5, 0.5}, {0.8, 1})}, [] { return true; })) << "stopped";
}

TEST(Boolean, AreasAddUpWhateverThePose) {
  Random random{5};
  int answered = 0;
  for (int i = 0; i < 500; ++i) {
    const Frame frame{make_pose({random.uniform(-1, 3), random.uniform(-1, 3)}, random.uniform(-pi, pi))};
    const Ring other = transformed(rectangle({0, 0}, {random.uniform(0.1, 3), random.uniform(0.1, 3)}), frame);
    const auto rest = without(square, other);
    const auto both = joined(square, other);
    if (!rest || !both) continue;
    ++answered;
    EXPECT_NEAR(signed_area(*both), signed_area(other) + area_of(*rest), 1e-8);
  }
  EXPECT_GT(answered, 200);
}

}  // namespace
}  // namespace waywright
