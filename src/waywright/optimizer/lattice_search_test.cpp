#include "waywright/optimizer/lattice_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace waywright {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

SearchSpace box(std::size_t n) { return {std::vector<double>(n, -2.0), std::vector<double>(n, 3.0)}; }

Evaluation with(double objective, double violation) { return {objective, violation, violation > 0.0 ? 1000.0 + violation : objective}; }

SearchResult minimise(const CostFunction& cost, const SearchSpace& space, std::int64_t evaluations) {
  Budget budget;
  SearchOptions options;
  options.evaluations = evaluations;
  const SearchResult result = LatticeSearch{}.minimise(cost, space, options, budget);
  EXPECT_EQ(budget.evaluations(), result.evaluations);
  EXPECT_LE(result.evaluations, evaluations);
  return result;
}

TEST(LatticeSearch, FindsTheBottomOfABowlInOneToSixVariables) {
  for (std::size_t n = 1; n <= LatticeSearch::most_variables; ++n) {
    const auto bowl = [](std::span<const double> x, double) {
      double sum = 0.0;
      for (std::size_t i = 0; i < x.size(); ++i) sum += (1.0 + static_cast<double>(i)) * (x[i] - 0.3) * (x[i] - 0.3);
      return with(sum, 0.0);
    };
    EXPECT_LT(minimise(bowl, box(n), 600).cost, n <= 3 ? 1e-4 : 0.05) << n;
  }
  EXPECT_TRUE(minimise([](std::span<const double>, double) { return Evaluation{}; }, box(7), 10).best.empty());
}

TEST(LatticeSearch, FollowsTheEdgeOfWhatIsFeasibleIntoItsCorner) {
  // Least (x + 2 y)/10 (so that objectives differ by about as much as the cliff) outside of a disc and above a slope: the optimum is
  // where two edges meet, known in closed form.
  const auto cost = [](std::span<const double> x, double) {
    const double disc = 1.0 - std::hypot(x[0], x[1]);
    const double slope = 0.5 * x[0] - x[1] - 0.5;
    return with(0.1 * (x[0] + 2.0 * x[1]), std::max(0.0, disc) + std::max(0.0, slope));
  };
  // On the slope y = x/2 − 1/2 the objective is 2x − 1, so that x is as small as the box lets it: −2.
  EXPECT_NEAR(minimise(cost, box(2), 400).cost, -0.5, 0.002);
  const auto beside = [&](std::span<const double> x, double) {
    const double disc = 1.0 - std::hypot(x[0], x[1]);
    const double slope = 0.5 * x[0] - x[1] - 0.5;
    return with(0.1 * (x[0] + 2.0 * x[1]), std::max(0.0, disc) + std::max(0.0, slope) + std::max(0.0, 0.2 - x[0]));
  };
  // x ≥ 0.2 as well: along the slope from the disc, (x, x/2 − 1/2) with x² + (x/2 − 1/2)² = 1.
  const double x = (0.5 + std::sqrt(0.25 + 4.0 * 1.25 * 0.75)) / 2.5;
  EXPECT_NEAR(minimise(beside, box(2), 400).cost, 0.1 * (2.0 * x - 1.0), 0.002);
}

TEST(LatticeSearch, FindsANarrowWayThatIsTheOnlyOne) {
  // 0.3 % of the box are feasible.
  const auto cost = [](std::span<const double> x, double) {
    return with(1.0 + 0.1 * x[1], std::max(0.0, std::abs(x[0] - 1.37) - 0.0075) + std::max(0.0, std::abs(x[1] + 1.0) - 0.5));
  };
  EXPECT_NEAR(minimise(cost, box(2), 300).cost, 0.85, 0.005);
}

TEST(LatticeSearch, WhatIsLeftOutBeyondEnoughChangesNothing) {
  int left_out = 0;
  const auto whole = [](std::span<const double> x, double) {
    return with((x[0] - 1.0) * (x[0] - 1.0) + std::abs(x[1]), std::max(0.0, 0.5 - x[0] * x[1]));
  };
  const auto lazy = [&](std::span<const double> x, double enough) {
    const Evaluation e = whole(x, enough);
    if (e.objective < enough) return e;
    ++left_out;
    return Evaluation{e.objective, 0.0, e.objective};
  };
  const SearchResult a = minimise(whole, box(2), 500), b = minimise(lazy, box(2), 500);
  EXPECT_EQ(a.best, b.best);
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_GT(left_out, 100);
}

TEST(LatticeSearch, NumbersThatAreNoneEndNothing) {
  const auto cost = [](std::span<const double> x, double) {
    return x[0] < 0.0 ? Evaluation{std::nan(""), infinity, std::nan("")} : with(x[0] + x[1] * x[1], 0.0);
  };
  EXPECT_NEAR(minimise(cost, box(2), 300).cost, 0.0, 0.01);
  const SearchResult nothing = minimise([](std::span<const double>, double) { return Evaluation{std::nan(""), 0.0, 0.0}; }, box(2), 50);
  EXPECT_EQ(nothing.evaluations, 50);
}

TEST(LatticeSearch, StopsWhereItIsTold) {
  std::atomic<bool> cancel{false};
  Budget budget{{}, &cancel};
  SearchOptions options;
  options.evaluations = 1'000'000'000'000;
  int calls = 0;
  const SearchResult result = LatticeSearch{}.minimise(
      [&](std::span<const double> x, double) {
        if (++calls == 20000) cancel = true;
        return with(x[0], 1.0);
      },
      box(3), options, budget);
  EXPECT_EQ(result.evaluations, 20000);
}

}  // namespace
}  // namespace waywright
