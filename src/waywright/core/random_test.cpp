#include "waywright/core/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace waywright {
namespace {

TEST(Random, KnownVectors) {
  Random random{1};
  EXPECT_EQ(random.next(), 0x910a2dec89025cc1ULL);
  EXPECT_EQ(random.next(), 0xbeeb8da1658eec67ULL);
  EXPECT_EQ(random.next(), 0xf893a2eefb32555eULL);
}

TEST(Random, UniformStaysInItsRange) {
  Random random{2};
  double sum = 0.0;
  double squares = 0.0;
  constexpr int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
    const double v = random.uniform(-3, 5);
    ASSERT_GE(v, -3.0);
    ASSERT_LT(v, 5.0);
  }
  // Five standard deviations of the mean and of the mean square.
  EXPECT_NEAR(sum / n, 0.5, 5 * 0.2887 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1.0 / 3.0, 5 * 0.2981 / std::sqrt(n));
}

TEST(Random, IntegersIncludeBothEnds) {
  Random random{3};
  std::array<int, 4> count{};
  for (int i = 0; i < 40000; ++i) ++count.at(static_cast<std::size_t>(random.integer(-1, 2) + 1));
  for (const int c : count) EXPECT_NEAR(c, 10000, 450);
  EXPECT_EQ(random.integer(7, 7), 7);
  // The widest range there is must not overflow.
  random.integer(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max());
  // As the reconstruction of the maps draws: a + next() mod (b − a + 1).
  Random a{1};
  EXPECT_EQ(a.integer(10, 19), 10 + static_cast<std::int64_t>(0x910a2dec89025cc1ULL % 10));
}

TEST(Random, StreamsAreReproducibleAndDiffer) {
  EXPECT_EQ(Random::stream(5, 3).next(), Random::stream(5, 3).next());
  std::set<std::uint64_t> first;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    for (std::uint64_t index = 0; index < 50; ++index) first.insert(Random::stream(seed, index).next());
  }
  EXPECT_EQ(first.size(), 2500u);
}

}  // namespace
}  // namespace waywright
