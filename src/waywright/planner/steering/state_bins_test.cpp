#include "waywright/planner/steering/state_bins.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

const Box region{{-3, -2}, {7, 6}};

Pose drawn(Random& random) { return {random.uniform(-3.5, 7.5), random.uniform(-2.5, 6.5), random.uniform(-pi, pi)}; }

class EveryBins : public testing::TestWithParam<SteeringKind> {};

TEST_P(EveryBins, ABoundIsNoMoreThanTheMotionCosts) {
  Random random{3};
  for (const double radius : {0.2, 0.8, 5.0}) {
    const auto steering = make_steering(GetParam(), {radius, 0.1, 0.0});
    double tightest = 0.0;
    for (int i = 0; i < 20'000; ++i) {
      const Pose a = drawn(random);
      const double reach = i % 2 == 0 ? 8.0 : 0.3 * radius;
      const Pose b{a.x + random.uniform(-reach, reach), a.y + random.uniform(-reach, reach), wrap(a.heading + (i % 3 == 0 ? 3.0 : 0.3) * random.uniform(-1, 1))};
      const double bound = steering->bound(Facing{a}, Facing{b}), cost = steering->distance(a, b);
      ASSERT_LE(bound, cost + 1e-9) << a.x << " " << a.y << " " << a.heading << " " << b.x << " " << b.y << " " << b.heading;
      ASSERT_GE(bound, distance(a.position(), b.position()) - 1e-9);
      tightest = std::max(tightest, bound / cost);
    }
    EXPECT_GT(tightest, 0.97);
  }
}

TEST_P(EveryBins, AnswersAreThoseOfLookingAtAll) {
  Random random{4};
  for (const double radius : {0.3, 2.0}) {
    const auto steering = make_steering(GetParam(), {radius, 0.1, 0.0});
    StateBins bins;
    bins.clear(*steering, region);
    std::vector<StateBins::Near> found, all;
    for (int i = 0; i < 700; ++i) {
      // Some lie together, some on each other.
      const Pose p = i % 10 == 9 ? bins[static_cast<std::uint32_t>(i / 2)] : i % 3 == 0 ? Pose{random.uniform(0, 0.5), random.uniform(0, 0.5), random.uniform(-pi, pi)} : drawn(random);
      ASSERT_EQ(bins.add(p), static_cast<std::uint32_t>(i));
      if (i % 9 != 0) continue;
      const Pose at = i % 2 == 0 ? drawn(random) : bins[static_cast<std::uint32_t>(i / 3)];
      for (const StateBins::Way way : {StateBins::Way::to_it, StateBins::Way::from_it}) {
        all.clear();
        for (std::uint32_t k = 0; k < bins.size(); ++k) all.push_back({way == StateBins::Way::to_it ? steering->distance(bins[k], at) : steering->distance(at, bins[k]), k});
        std::sort(all.begin(), all.end());
        EXPECT_EQ(bins.nearest(at, way).cost, all.front().cost);
        for (const std::size_t count : {1U, 7U, 40U}) {
          bins.nearest(at, way, count, found);
          ASSERT_EQ(found.size(), std::min(count, all.size()));
          for (std::size_t k = 0; k < found.size(); ++k) ASSERT_NEAR(found[k].cost, all[k].cost, 1e-9);
        }
        bins.within(at, way, 1.5, found);
        const auto end = std::partition_point(all.begin(), all.end(), [](const StateBins::Near& n) { return n.cost <= 1.5; });
        ASSERT_EQ(found.size(), static_cast<std::size_t>(end - all.begin()));
        for (std::size_t k = 0; k < found.size(); ++k) ASSERT_EQ(found[k].index, all[k].index);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryBins,
                         testing::Values(SteeringKind::turns, SteeringKind::dubins, SteeringKind::reeds_shepp), [](const auto& entry) { return std::string{to_string(entry.param)}; });

}  // namespace
}  // namespace waywright
