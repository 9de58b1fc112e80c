#include "waywright/planner/visiting_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

using Order = std::vector<std::size_t>;

struct Wanted {
  std::size_t jobs = 0;     ///< pairs of places, the first of which takes a load
  std::size_t between = 0;  ///< places that are visited with the load of a job
  double missing = 0.0;     ///< share of the ways that are not there
  double asymmetry = 0.3;   ///< ways are up to so much longer one way than the other
  bool keeps_last = false;
  std::size_t rules = 0;  ///< places that come after another one
};

/// Places in a square; ways by distance, longer one way than the other.
VisitProblem random_problem(std::size_t n, std::uint64_t seed, const Wanted& wanted) {
  Random random{seed};
  VisitProblem problem;
  problem.places.resize(n);
  problem.keeps_last = wanted.keeps_last;
  for (std::size_t j = 0; j < wanted.jobs; ++j) {
    const int state = static_cast<int>(j) + 1;
    problem.places[2 * j] = {0, state, {}};
    problem.places[2 * j + 1] = {state, 0, {2 * j}};
  }
  for (std::size_t v = 0; v < wanted.between && wanted.jobs > 0; ++v) {
    const std::size_t place = 2 * wanted.jobs + v, job = v % wanted.jobs;
    problem.places[place] = {static_cast<int>(job) + 1, static_cast<int>(job) + 1, {2 * job}};
    problem.places[2 * job + 1].after.push_back(place);
  }
  for (std::size_t r = 0; r < wanted.rules; ++r) {
    const auto b = static_cast<std::size_t>(random.integer(1, static_cast<std::int64_t>(n) - 1));
    problem.places[b].after.push_back(static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(b) - 1)));
  }
  std::vector<double> x(n + 1), y(n + 1);
  for (std::size_t i = 0; i <= n; ++i) x[i] = random.uniform(0.0, 100.0), y[i] = random.uniform(0.0, 100.0);
  problem.lengths.assign((n + 1) * n, no_way);
  for (std::size_t from = 0; from <= n; ++from) {
    for (std::size_t to = 0; to < n; ++to) {
      if (!may_follow(problem, from, to)) continue;
      const double longer = 1.0 + random.uniform(0.0, wanted.asymmetry);
      if (random.uniform() < wanted.missing) continue;
      problem.lengths[from * n + to] = std::llround(1e6 * longer * std::hypot(x[from] - x[to], y[from] - y[to]));
    }
  }
  return problem;
}

/// The shortest of all permutations; empty where none is allowed and has all its ways.
std::optional<Order> by_permutations(const VisitProblem& problem) {
  Order order(problem.places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::optional<Order> best;
  std::int64_t least = no_way;
  do {
    const auto length = visit_length(problem, order);
    if (length && *length < least) least = *length, best = order;
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(VisitingOrder, DynamicProgrammingFindsWhatAllPermutationsShow) {
  int without = 0, solved = 0;
  for (std::uint64_t seed = 1; seed <= 240; ++seed) {
    const std::size_t n = 1 + seed % 7;
    Wanted wanted;
    wanted.jobs = seed % 3 == 0 ? 0 : std::min<std::size_t>(n / 2, seed % 4);
    wanted.between = wanted.jobs > 0 && n > 2 * wanted.jobs ? 1 : 0;
    wanted.missing = seed % 5 == 0 ? 0.5 : seed % 5 == 1 ? 0.2 : 0.0;
    wanted.keeps_last = seed % 2 == 0;
    wanted.rules = wanted.jobs == 0 && n > 2 && seed % 4 != 1 ? 2 : 0;
    const VisitProblem problem = random_problem(n, seed, wanted);
    const auto expected = by_permutations(problem);
    const auto found = shortest_visit_order(problem);
    ASSERT_EQ(found.has_value(), expected.has_value()) << seed;
    (found ? solved : without) += 1;
    const auto good = good_visit_order(problem);
    if (!found) {
      EXPECT_FALSE(good) << seed;
      continue;
    }
    EXPECT_EQ(*found, *expected) << seed;  // of several as short the first in the order of the places
    const std::int64_t length = *visit_length(problem, *found);
    EXPECT_LE(visit_length_bound(problem, length), length) << seed;
    if (good) {
      EXPECT_GE(*visit_length(problem, *good), length) << seed;
    }
  }
  EXPECT_GT(without, 10);
  EXPECT_GT(solved, 150);
}

TEST(VisitingOrder, EightPlacesByAllPermutations) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const VisitProblem problem = random_problem(8, seed, {.jobs = seed % 3, .asymmetry = 2.0, .keeps_last = seed % 2 == 0});
    EXPECT_EQ(shortest_visit_order(problem), by_permutations(problem)) << seed;
  }
}

TEST(VisitingOrder, TheOrderGivenWinsTies) {
  VisitProblem problem;
  problem.places.resize(9);
  problem.lengths.assign(10 * 9, 1'000'000);
  Order given(9);
  std::iota(given.begin(), given.end(), std::size_t{0});
  EXPECT_EQ(shortest_visit_order(problem), given);
  EXPECT_EQ(good_visit_order(problem), given);
  EXPECT_EQ(visit_length_bound(problem, 9'000'000), 9'000'000);
}

TEST(VisitingOrder, SearchIsHeldAgainstTheShortestAtTenToTwelvePlaces) {
  double gap = 0.0, bound_gap = 0.0, worst = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const std::size_t n = 10 + seed % 3;
    const VisitProblem problem = random_problem(n, seed,
                                                {.jobs = seed % 4 == 0 ? 0 : seed % 4 + 1,
                                                 .between = seed % 3 == 0 && seed % 5 != 0 ? 2U : 0U,
                                                 .asymmetry = seed % 2 == 0 ? 0.3 : 2.0,
                                                 .keeps_last = seed % 5 == 0,
                                                 .rules = seed % 4 == 0 ? 3U : 0U});
    const auto exact = shortest_visit_order(problem);
    ASSERT_TRUE(exact) << seed;
    const auto good = good_visit_order(problem);
    ASSERT_TRUE(good) << seed;
    const auto shortest = static_cast<double>(*visit_length(problem, *exact));
    const auto found = visit_length(problem, *good);
    ASSERT_TRUE(found) << seed;
    const double share = static_cast<double>(*found) / shortest - 1.0;
    ASSERT_GE(share, 0.0);
    gap += share;
    worst = std::max(worst, share);
    const auto bound = static_cast<double>(visit_length_bound(problem, *found));
    ASSERT_LE(bound, shortest) << seed;
    bound_gap += 1.0 - bound / shortest;
    ++count;
  }
  RecordProperty("mean_gap_percent", std::to_string(100.0 * gap / count));
  RecordProperty("worst_gap_percent", std::to_string(100.0 * worst));
  RecordProperty("mean_bound_gap_percent", std::to_string(100.0 * bound_gap / count));
  std::printf("search over the shortest: mean %.4f %%, worst %.4f %%; bound below it: mean %.3f %%\n", 100.0 * gap / count, 100.0 * worst,
              100.0 * bound_gap / count);
  EXPECT_LT(gap / count, 0.002);
  EXPECT_LT(bound_gap / count, 0.04);
}

TEST(VisitingOrder, ManyPlacesAreOrderedWithinTheBound) {
  for (const std::size_t n : {20U, 50U, 100U}) {
    for (const std::size_t jobs : {std::size_t{0}, n / 3}) {
      const VisitProblem problem = random_problem(n, n, {.jobs = jobs, .between = jobs / 4, .keeps_last = true});
      const auto order = good_visit_order(problem);
      ASSERT_TRUE(order);
      const auto length = visit_length(problem, *order);
      ASSERT_TRUE(length) << "the order breaks a rule";
      EXPECT_EQ(order->back(), n - 1);
      const std::int64_t bound = visit_length_bound(problem, *length);
      std::printf("%zu places, %zu jobs: %.1f m, bound %.1f m, gap %.2f %%\n", n, jobs, static_cast<double>(*length) / 1e6, static_cast<double>(bound) / 1e6,
                  100.0 * (static_cast<double>(*length) / static_cast<double>(bound) - 1.0));
      EXPECT_LE(bound, *length);
      EXPECT_GT(static_cast<double>(bound), 0.95 * static_cast<double>(*length));
      EXPECT_EQ(order, good_visit_order(problem));
    }
  }
}

TEST(VisitingOrder, ARaisedFlagEndsTheSearch) {
  const VisitProblem problem = random_problem(200, 3, {});
  const std::atomic<bool> raised{true};
  const auto order = good_visit_order(problem, &raised);
  ASSERT_TRUE(order);
  EXPECT_TRUE(visit_length(problem, *order));
}

}  // namespace
}  // namespace waywright
