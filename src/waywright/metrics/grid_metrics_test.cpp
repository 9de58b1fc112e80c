#include "waywright/metrics/grid_metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace waywright {
namespace {

TEST(GridMetrics, PowerOfThePublishedWays) {
  EXPECT_NEAR(residual_power(380.5584, 89.5353), 47.69, 0.005);
  EXPECT_NEAR(residual_power(384.0731, 89.5353), 47.34, 0.01);
  EXPECT_NEAR(residual_power(369.5521, 6.1191), 62.07, 0.005);
  EXPECT_NEAR(residual_power(69.5979, 10.9955), 91.29, 0.005);
  EXPECT_NEAR(residual_power(0.0, 0.0, 5.0), 99.0, 1e-12);
}

TEST(GridMetrics, RiskOfOneCell) {
  EXPECT_NEAR(risk_of(1.0, {}), 0.7788, 5e-5);
  EXPECT_NEAR(risk_of(1.0, {1.5, 2.0, 2}), 0.8825, 5e-5);
  EXPECT_EQ(risk_of(1.6, {}), 0.0);
}

TEST(GridMetrics, RiskAddsUpOverPointsAndCells) {
  // Three columns, one blocked cell in the middle of the first row; y points down the rows.
  const unsigned char blocked[] = {0, 1, 0, 0, 0, 0};
  const Vec2 beside[] = {{0, 0}, {0, 1}, {5, 5}};
  EXPECT_NEAR(way_risk(beside, blocked, 3, 2, 1.0), std::exp(-0.25) + std::exp(-0.25 * std::sqrt(2.0)), 1e-12);
  const Vec2 smaller[] = {{0, 0}};
  EXPECT_NEAR(way_risk(smaller, blocked, 3, 2, 0.5), std::exp(-0.125), 1e-12);
}

TEST(GridMetrics, LengthAndTurningOfAWay) {
  const std::vector<Vec2> way{{0, 0}, {2, 0}, {2, 0}, {2, 3}, {1, 3}, {2, 3}};
  EXPECT_NEAR(way_length(way), 7.0, 1e-12);
  EXPECT_NEAR(way_turning(way), 0.5 * pi + 0.5 * pi + pi, 1e-12);
  const auto more = with_points_between(way, 1.0);
  EXPECT_EQ(more.size(), 9U);
  EXPECT_NEAR(way_length(more), 7.0, 1e-12);
  EXPECT_NEAR(way_turning(more), 2.0 * pi, 1e-9);
}

TEST(GridMetrics, ReductionsAsPublished) {
  EXPECT_NEAR(reduction(380.5584, 369.5521), 2.89, 0.005);
  EXPECT_NEAR(reduction(0.821, 1.084), -32.03, 0.005);
  EXPECT_NEAR(power_reduction(47.69, 62.07), 27.49, 0.005);
  EXPECT_EQ(reduction(0.0, 0.0), 0.0);
  EXPECT_TRUE(std::isinf(reduction(0.0, 1.0)));
}

TEST(GridMetrics, TimeIsDistanceOverSpeed) { EXPECT_NEAR(way_time(73.73, 0.9286), 79.4, 0.01); }

}  // namespace
}  // namespace waywright
