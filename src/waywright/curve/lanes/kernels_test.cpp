#include "waywright/curve/lanes/kernels.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

using clothoid_lanes::Kernels;
using clothoid_lanes::Moments;

TEST(ClothoidLanes, EveryInstructionSetGivesTheSameBits) {
  Random random{1};
  for (int i = 0; i < 20'000; ++i) {
    const double a = random.uniform(-25, 25), delta = random.uniform(-13, 13), phi0 = random.uniform(-4, 4);
    const int panels = static_cast<int>(random.integer(0, 5));
    const Moments first = clothoid_lanes::available().front().moments(a, delta, phi0, panels);
    for (const Kernels& k : clothoid_lanes::available()) {
      const Moments m = k.moments(a, delta, phi0, panels);
      EXPECT_EQ(m.along, first.along) << k.name;
      EXPECT_EQ(m.across, first.across) << k.name;
      EXPECT_EQ(m.along_slope, first.along_slope) << k.name;
      EXPECT_EQ(m.across_slope, first.across_slope) << k.name;
    }
  }
}

TEST(ClothoidLanes, FitsAndStepsAreTheSameBits) {
  Random random{3};
  for (int i = 0; i < 5000; ++i) {
    clothoid_lanes::Fits fits;
    for (int k = 0; k < clothoid_lanes::width; ++k) {
      fits.phi0[k] = random.uniform(-3.1, 3.1);
      fits.delta[k] = random.uniform(-3.1, 3.1) - fits.phi0[k];
      fits.a[k] = random.uniform(-9, 9);
    }
    const double heading = random.uniform(-3, 3), curvature = random.uniform(-2, 2), rate = random.uniform(-1, 1), s0 = random.uniform(0, 5), h = random.uniform(0.01, 0.5);
    const int points = std::array{0, 6, 8, 16}[static_cast<std::size_t>(random.integer(0, 3))];
    clothoid_lanes::Fits first_fits = fits;
    clothoid_lanes::Steps first_steps;
    clothoid_lanes::available().front().fit(first_fits, 24.0, 0.02);
    clothoid_lanes::available().front().steps(heading, curvature, rate, s0, h, points, first_steps);
    for (const Kernels& kernels : clothoid_lanes::available()) {
      clothoid_lanes::Fits own = fits;
      clothoid_lanes::Steps steps;
      kernels.fit(own, 24.0, 0.02);
      kernels.steps(heading, curvature, rate, s0, h, points, steps);
      for (int k = 0; k < clothoid_lanes::width; ++k) {
        EXPECT_EQ(own.solved[k], first_fits.solved[k]) << kernels.name;
        if (own.solved[k]) {
          EXPECT_EQ(own.a[k], first_fits.a[k]) << kernels.name;
          EXPECT_EQ(own.share[k], first_fits.share[k]) << kernels.name;
        }
        EXPECT_EQ(steps.dx[k], first_steps.dx[k]) << kernels.name;
        EXPECT_EQ(steps.dy[k], first_steps.dy[k]) << kernels.name;
      }
    }
  }
}

TEST(ClothoidLanes, TheSeriesIsTheIntegral) {
  Random random{4};
  for (int i = 0; i < 20'000; ++i) {
    const double h = std::pow(10.0, random.uniform(-3, 1));
    const double rate = random.uniform(-1, 1) * 16e-3 / (h * h);  // c up to 0.002
    // The first step has all of the turning that is allowed, the last one, eight on, no more.
    const double curvature = random.uniform(-1, 1) * (0.18 / h - 8.0 * std::abs(rate) * h);
    if (std::abs(curvature) + 8.0 * std::abs(rate) * h > 0.18 / h) continue;
    const double heading = random.uniform(-3, 3);
    clothoid_lanes::Steps series, points;
    clothoid_lanes::best().steps(heading, curvature, rate, 0.0, h, 0, series);
    clothoid_lanes::best().steps(heading, curvature, rate, 0.0, h, 16, points);
    for (int k = 0; k < clothoid_lanes::width; ++k) {
      ASSERT_NEAR(series.dx[k], points.dx[k], 3e-14 * h);
      ASSERT_NEAR(series.dy[k], points.dy[k], 3e-14 * h);
    }
  }
}

TEST(ClothoidLanes, MomentsAreTheIntegrals) {
  Random random{2};
  for (int i = 0; i < 200; ++i) {
    const double a = random.uniform(-20, 20), delta = random.uniform(-7, 7), phi0 = random.uniform(-4, 4);
    const int panels = static_cast<int>(std::ceil((std::abs(a) + std::abs(delta)) / 8.0));
    const Moments m = clothoid_lanes::best().moments(a, delta, phi0, panels);
    // Simpson's rule in long double.
    constexpr int n = 4000;
    long double along = 0, across = 0, along_slope = 0, across_slope = 0;
    for (int k = 0; k <= 2 * n; ++k) {
      const long double t = static_cast<long double>(k) / (2 * n);
      const long double w = (k == 0 || k == 2 * n ? 1.0L : k % 2 == 1 ? 4.0L : 2.0L) / (6.0L * n);
      const long double phase = static_cast<long double>(a) * t * t + (static_cast<long double>(delta) - static_cast<long double>(a)) * t + static_cast<long double>(phi0);
      along += w * std::cos(phase);
      across += w * std::sin(phase);
      along_slope -= w * std::sin(phase) * (t * t - t);
      across_slope += w * std::cos(phase) * (t * t - t);
    }
    EXPECT_NEAR(m.along, static_cast<double>(along), 1e-11);
    EXPECT_NEAR(m.across, static_cast<double>(across), 1e-11);
    EXPECT_NEAR(m.along_slope, static_cast<double>(along_slope), 1e-11);
    EXPECT_NEAR(m.across_slope, static_cast<double>(across_slope), 1e-11);
  }
}

}  // namespace
}  // namespace waywright
