#include "waywright/core/elementary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "waywright/core/exponentials.hpp"
#include "waywright/core/random.hpp"

namespace waywright {
namespace {

TEST(Elementary, AgreesWithTheSystem) {
  Random random{1};
  for (int i = 0; i < 1000000; ++i) {
    const double a = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-12, 4.9));
    const SinCos sc = sin_cos(a);
    ASSERT_NEAR(sc.sin, std::sin(a), 5e-16) << a;
    ASSERT_NEAR(sc.cos, std::cos(a), 5e-16) << a;
    const double x = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-8, 8));
    const double y = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-8, 8));
    const double t = std::atan2(y, x);
    ASSERT_NEAR(arc_tangent(y, x), t, 5e-16 * std::abs(t)) << y << " " << x;
    const double e = random.uniform(-700, 700);
    ASSERT_NEAR(exponential(e) / std::exp(e), 1.0, 1e-15) << e;
  }
}

TEST(Elementary, ManyExponentialsAtOnceHaveTheSameBits) {
  Random random{2};
  for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 64U, 1000U}) {
    std::vector<double> values, expected;
    for (std::size_t i = 0; i < count; ++i) values.push_back(i % 97 == 5 ? 705.0 + static_cast<double>(i % 3) * 4.0 : random.uniform(-1.0, 1.0) * (i % 2 == 0 ? 1.0 : 720.0));
    for (const double x : values) expected.push_back(exponential(x));
    exponential_each(values);
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(values[i], expected[i]) << i << " of " << count;
  }
}

TEST(Elementary, SpecialValuesAreExact) {
  constexpr double pi = 3.14159265358979323846;
  EXPECT_EQ(sin_cos(0.0).sin, 0.0);
  EXPECT_EQ(sin_cos(0.0).cos, 1.0);
  EXPECT_EQ(sin_cos(pi / 2).sin, 1.0);
  EXPECT_EQ(sin_cos(pi).cos, -1.0);
  EXPECT_NEAR(sin_cos(pi).sin, std::sin(pi), 1e-20);
  EXPECT_EQ(arc_tangent(0.0, 1.0), 0.0);
  EXPECT_EQ(arc_tangent(0.0, -1.0), pi);
  EXPECT_EQ(arc_tangent(-0.0, -1.0), -pi);
  EXPECT_EQ(arc_tangent(1.0, 0.0), pi / 2);
  EXPECT_EQ(arc_tangent(-1.0, 0.0), -pi / 2);
  EXPECT_EQ(arc_tangent(1.0, 1.0), pi / 4);
  EXPECT_EQ(arc_tangent(0.0, 0.0), 0.0);
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_EQ(exponential(-1000.0), 0.0);
  EXPECT_TRUE(std::isnan(sin_cos(std::numeric_limits<double>::infinity()).sin));
  EXPECT_TRUE(std::isnan(arc_tangent(std::nan(""), 1.0)));
  EXPECT_TRUE(std::isfinite(sin_cos(1e300).sin));
}

}  // namespace
}  // namespace waywright
