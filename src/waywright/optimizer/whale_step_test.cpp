// The laws that whale_step.hpp names, and its moves against their formulas.
#include "waywright/optimizer/whale_step.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "waywright/optimizer/whale_search.hpp"

namespace waywright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(WhaleStep, TheThresholdsSettleWhichMoveItIs) {
  Random random{1};
  for (int i = 0; i < 10'000; ++i) {
    const WhaleDraws draws = WhaleDraws::from(random);
    const double reach = i % 100 == 0 ? 0.0 : random.uniform(0.0, 4.0);
    EXPECT_EQ(whale_step({.choice = 1.0, .threshold = 0.0}, reach, draws).move, WhaleMove::search);
    EXPECT_EQ(whale_step({.choice = 1.0, .threshold = infinity}, reach, draws).move, WhaleMove::encircle);
    EXPECT_EQ(whale_step({.choice = 0.0}, reach, draws).move, WhaleMove::spiral);
    const WhaleStep usual = whale_step({}, reach, draws);
    const double a = 2.0 * reach * draws.r1 - reach;
    EXPECT_EQ(usual.move, draws.p >= 0.5 ? WhaleMove::spiral : std::abs(a) < 1.0 ? WhaleMove::encircle : WhaleMove::search);
  }
}

TEST(WhaleStep, ManySpiralsAtOnceHaveTheSameBits) {
  Random random{4};
  for (const std::size_t count : {0U, 1U, 50U, 64U, 65U, 300U}) {
    const WhaleParameters parameters{.spiral = random.uniform(-3.0, 3.0)};
    std::vector<double> values(count);
    for (double& l : values) l = random.uniform(-1.0, 1.0);
    const std::vector<double> drawn = values;
    whale_spirals(parameters, values);
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(values[i], whale_spiral(parameters, drawn[i]));
  }
}

TEST(WhaleStep, MovesAreThoseOfTheFormulas) {
  // Bounds about (3, −2), so that the publication's origin is not theirs.
  const std::array low{-7.0, -12.0}, high{13.0, 8.0}, middle{3.0, -2.0};
  Random random{2};
  for (int i = 0; i < 2000; ++i) {
    const WhaleDraws draws = WhaleDraws::from(random);
    const WhaleParameters parameters{.spiral = random.uniform(0.2, 2.0)};
    const double reach = random.uniform(0.0, 2.0);
    const WhaleStep step = whale_step(parameters, reach, draws);
    std::array<double, 2> target{}, x{};
    for (std::size_t k = 0; k < 2; ++k) {
      target[k] = random.uniform(low[k], high[k]);
      x[k] = random.uniform(low[k], high[k]);
    }
    const std::array before = x;
    make_whale_step(step, target, low, high, x);
    const double big_a = 2.0 * reach * draws.r1 - reach, big_c = 2.0 * draws.r2;
    for (std::size_t k = 0; k < 2; ++k) {
      double expected = 0.0;  // relative to the middle, as the publication has it about its origin
      const double t = target[k] - middle[k], from = before[k] - middle[k];
      if (step.move == WhaleMove::spiral) {
        expected = std::abs(t - from) * std::exp(parameters.spiral * draws.l) * std::cos(2.0 * std::numbers::pi * draws.l) + t;
      } else {
        expected = t - big_a * std::abs(big_c * t - from);
      }
      EXPECT_NEAR(x[k], std::clamp(expected + middle[k], low[k], high[k]), 1e-12);
    }
  }
}

TEST(WhaleStep, MovingEverythingMovesTheResult) {
  Random random{3};
  for (int i = 0; i < 2000; ++i) {
    const double by = random.uniform(-50.0, 50.0);
    const WhaleStep step = whale_step({}, random.uniform(0.0, 2.0), WhaleDraws::from(random));
    std::vector<double> low(3), high(3), target(3), origin(3), x(3), low2(3), high2(3), target2(3), origin2(3), x2(3);
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = random.uniform(-5.0, 0.0);
      high[k] = random.uniform(1.0, 5.0);
      for (auto* v : {&target, &origin, &x}) (*v)[k] = random.uniform(low[k], high[k]);
      low2[k] = low[k] + by, high2[k] = high[k] + by, target2[k] = target[k] + by, origin2[k] = origin[k] + by, x2[k] = x[k] + by;
    }
    std::vector<double> y = x, y2 = x2;
    make_whale_step(step, target, low, high, x);
    make_whale_step(step, target2, low2, high2, x2);
    const std::uint64_t seed = random.next();
    Random a{seed}, b{seed};
    make_unbiased_whale_step({}, step, target, origin, low, high, y, a);
    make_unbiased_whale_step({}, step, target2, origin2, low2, high2, y2, b);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(x2[k], x[k] + by, 1e-12);
      EXPECT_NEAR(y2[k], y[k] + by, 1e-12);
      for (const double v : {x[k], y[k]}) EXPECT_TRUE(v >= low[k] && v <= high[k]);
    }
  }
}

TEST(WhaleStep, ReachFallsInAStraightLineToNothing) {
  EXPECT_EQ(whale_reach(4.0, 0, 10), 4.0);
  EXPECT_EQ(whale_reach(4.0, 5, 10), 2.0);
  EXPECT_EQ(whale_reach(4.0, 10, 10), 0.0);
}

TEST(WhaleSearch, MovesAreCountedAndTheBestIsKept) {
  const std::vector<double> low(4, -1.0), high(4, 2.0);
  for (const bool unbiased : {false, true}) {
    for (const auto& [parameters, which] : {std::pair{WhaleParameters{.choice = 1.0, .threshold = 0.0}, 0}, std::pair{WhaleParameters{.choice = 1.0, .threshold = infinity}, 1},
                                            std::pair{WhaleParameters{.choice = 0.0}, 2}}) {
      Random random{7};
      std::vector<double> places(4 * 12), best(4, 2.0), mean(unbiased ? 4 : 0);
      for (double& v : places) v = random.uniform(-1.0, 2.0);
      WhaleAgents agents{low, high, places, best, 1e9, mean};
      double least = 1e9;
      const WhaleCounts counts = whale_search(
          parameters, 20, agents, random,
          [&](std::size_t, std::span<const double> x) {
            double sum = 0.0;
            for (const double v : x) sum += (v - 1.3) * (v - 1.3);
            least = std::min(least, sum);
            return sum;
          },
          [](std::size_t) { return false; });
      EXPECT_EQ(counts.searches, which == 0 ? 240 : 0);
      EXPECT_EQ(counts.encircles, which == 1 ? 240 : 0);
      EXPECT_EQ(counts.spirals, which == 2 ? 240 : 0);
      EXPECT_EQ(agents.best_value, least);
      double sum = 0.0;
      for (const double v : best) sum += (v - 1.3) * (v - 1.3);
      EXPECT_EQ(sum, least);
    }
  }
}

}  // namespace
}  // namespace waywright
