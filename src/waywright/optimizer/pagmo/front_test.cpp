#include "waywright/optimizer/pagmo/front.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace waywright {
namespace {

/// Two corners and the diagonal between them: the front is where no move helps all three. Feasible where x + y ≥ ½.
TradeOff corners(std::span<const double> x) {
  const auto square = [](double v) { return v * v; };
  return {{square(x[0]) + square(x[1]), square(x[0] - 1.0) + square(x[1]), square(x[0]) + square(x[1] - 1.0)}, std::max(0.0, 0.5 - x[0] - x[1])};
}

bool is_no_better(const FrontPoint& a, const FrontPoint& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.objectives[k] < b.objectives[k]) return false;
  }
  return true;
}

const SearchSpace square{{-1.0, -1.0}, {2.0, 2.0}};

std::vector<FrontPoint> front_of(std::int64_t evaluations, std::uint64_t seed, Budget& budget) {
  SearchOptions options;
  options.evaluations = evaluations;
  options.population = 40;
  options.seed = seed;
  return search_front(corners, square, options, budget);
}

TEST(SearchFront, PointsAreFeasibleAndNoneIsBetterInAllThanAnother) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Budget budget{{}, nullptr};
    const auto front = front_of(3000, seed, budget);
    EXPECT_EQ(budget.evaluations(), 3000);
    ASSERT_GT(front.size(), 30U);
    double least[3] = {9.0, 9.0, 9.0};
    std::size_t near = 0;
    for (std::size_t i = 0; i < front.size(); ++i) {
      const FrontPoint& p = front[i];
      EXPECT_EQ(corners(p.x).violation, 0.0);
      EXPECT_EQ(corners(p.x).objectives, p.objectives);
      for (std::size_t k = 0; k < 3; ++k) least[k] = std::min(least[k], p.objectives[k]);
      // The front is the triangle of the corners, less what is not feasible.
      near += std::min(p.x[0], p.x[1]) >= -0.05 && p.x[0] + p.x[1] <= 1.05 ? 1 : 0;
      if (i > 0) {
        EXPECT_LE(front[i - 1].objectives, p.objectives);
      }
      for (std::size_t k = 0; k < front.size(); ++k) EXPECT_FALSE(i != k && is_no_better(p, front[k])) << i << " " << k;
    }
    EXPECT_GT(near, front.size() * 3 / 4);
    EXPECT_NEAR(least[0], 0.125, 0.01);  // at (¼, ¼)
    EXPECT_NEAR(least[1], 0.0, 0.01);
    EXPECT_NEAR(least[2], 0.0, 0.01);
  }
}

TEST(SearchFront, ASeedGivesTheSameFront) {
  Budget a{{}, nullptr}, b{{}, nullptr}, c{{}, nullptr};
  const auto first = front_of(800, 3, a), again = front_of(800, 3, b), other = front_of(800, 4, c);
  ASSERT_EQ(first.size(), again.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].x, again[i].x);
    EXPECT_EQ(first[i].objectives, again[i].objectives);
  }
  EXPECT_TRUE(first.size() != other.size() || first.front().x != other.front().x);
}

TEST(SearchFront, KeepsItsBudget) {
  for (const std::int64_t evaluations : {1, 7, 39, 41, 500}) {
    Budget budget{{}, nullptr};
    const auto front = front_of(evaluations, 1, budget);
    EXPECT_EQ(budget.evaluations(), evaluations);
    EXPECT_LE(front.size(), static_cast<std::size_t>(evaluations));
  }
  std::atomic<bool> cancel{true};
  Budget canceled{{}, &cancel};
  EXPECT_TRUE(front_of(500, 1, canceled).empty());
  EXPECT_EQ(canceled.evaluations(), 0);
}

TEST(SearchFront, WithoutVariablesOrWithoutAFeasiblePoint) {
  SearchOptions options;
  options.evaluations = 200;
  Budget budget{{}, nullptr};
  const auto only = search_front([](std::span<const double> x) { return TradeOff{{1.0, 2.0, static_cast<double>(x.size())}, 0.0}; }, {}, options, budget);
  ASSERT_EQ(only.size(), 1U);
  EXPECT_TRUE(only[0].x.empty());
  EXPECT_EQ(only[0].objectives, (std::array{1.0, 2.0, 0.0}));
  EXPECT_EQ(budget.evaluations(), 1);
  Budget more{{}, nullptr};
  EXPECT_TRUE(search_front([](std::span<const double>) { return TradeOff{{0.0, 0.0, 0.0}, 1.0}; }, square, options, more).empty());
  EXPECT_EQ(more.evaluations(), 200);
}

}  // namespace
}  // namespace waywright
