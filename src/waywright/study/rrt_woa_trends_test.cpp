#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/study/paired.hpp"
#include "waywright/study/reproduce_rrt_woa.hpp"

namespace waywright::rrt_woa {
namespace {

TEST(PairedDifference, HasStudentsQuantiles) {
  // Of the distribution's tables.
  EXPECT_NEAR(student_bound(0.95, 1), 12.7062, 1e-4);
  EXPECT_NEAR(student_bound(0.95, 2), 4.30265, 1e-5);
  EXPECT_NEAR(student_bound(0.95, 9), 2.26216, 1e-5);
  EXPECT_NEAR(student_bound(0.99, 30), 2.75000, 1e-5);
  EXPECT_NEAR(student_bound(0.95, 99), 1.98422, 1e-5);
  const PairedDifference three = paired_difference({1.0, 2.0, 3.0}, 0.95);
  EXPECT_NEAR(three.mean, 2.0, 1e-12);
  EXPECT_NEAR(three.high - three.mean, 4.30265 / std::sqrt(3.0), 1e-5);
  EXPECT_TRUE(std::isinf(paired_difference({1.0}, 0.95).high));
}

/// Two rows, seed by seed about 30 m with what all rows of a seed share, the second longer by `change` m, up to `noise`.
Results of_two_rows(double printed_change, double change, double noise, int seeds) {
  Results results;
  results.runs = seeds;
  Table table{"3.3", Variant::global, "population", std::vector<Row>(2)};
  Random random{5};
  for (int s = 0; s < seeds; ++s) {
    const double shared = 30.0 + random.uniform(-5.0, 5.0);
    table.rows[0].ours.metres_by_seed.push_back(shared);
    table.rows[1].ours.metres_by_seed.push_back(shared + change + random.uniform(-noise, noise));
  }
  table.rows[0].published.metres = 35.0;
  table.rows[1].published.metres = 35.0 + printed_change;
  results.tables.push_back(table);
  return results;
}

struct Counts {
  int holding;
  std::size_t broken, undecided;
  bool operator==(const Counts&) const = default;
};
Counts counts_of(const Trends& t) { return {t.holding, t.broken.size(), t.undecided.size()}; }

TEST(WhaleTrends, HoldOrDoNotHoldOrCannotBeTold) {
  constexpr Counts holds{1, 0, 0}, broken{0, 1, 0}, undecided{0, 0, 1};
  // What the seeds share, ± 5 m, says nothing against a change of half a metre that all of them show.
  EXPECT_EQ(counts_of(trends(of_two_rows(-0.7, -0.6, 0.1, 3))), holds);
  EXPECT_EQ(counts_of(trends(of_two_rows(-0.7, +0.6, 0.1, 3))), broken);
  EXPECT_EQ(counts_of(trends(of_two_rows(-0.7, 0.0, 0.1, 20))), broken);   // no effect is none
  EXPECT_EQ(counts_of(trends(of_two_rows(-0.7, -0.6, 3.0, 3))), undecided);
  EXPECT_EQ(counts_of(trends(of_two_rows(-0.7, -0.6, 0.1, 1))), undecided);
  EXPECT_EQ(counts_of(trends(of_two_rows(0.0, 0.0, 0.1, 20))), holds);     // none is printed, none is there
  EXPECT_EQ(counts_of(trends(of_two_rows(0.0, 0.6, 0.1, 20))), broken);
  EXPECT_EQ(counts_of(trends(of_two_rows(0.0, 0.0, 3.0, 3))), undecided);
  const Trends told = trends(of_two_rows(-0.7, +0.6, 0.1, 3));
  EXPECT_NE(told.broken[0].find("3.3, global variant, population: the length falls by 2.0 % as printed, here it changes by +"), std::string::npos) << told.broken[0];
}

/// λ = 0 against 1 and 2; printed: 0 gives the longest ways.
Results of_lambda(double by_one, double by_two, double noise, int seeds) {
  Results results;
  results.runs = seeds;
  Table table{"3.13", Variant::global, "lambda", std::vector<Row>(3)};
  Random random{6};
  for (std::size_t i = 0; i < 3; ++i) {
    table.rows[i].value = static_cast<double>(i);
    table.rows[i].published.metres = 36.0 - static_cast<double>(i);
  }
  for (int s = 0; s < seeds; ++s) {
    const double shared = 30.0 + random.uniform(-5.0, 5.0);
    const double by[] = {0.0, by_one, by_two};
    for (std::size_t i = 0; i < 3; ++i) table.rows[i].ours.metres_by_seed.push_back(shared + by[i] + random.uniform(-noise, noise));
  }
  results.tables.push_back(table);
  return results;
}

TEST(WhaleTrends, OfLambdaZeroIsHeldAgainstEveryOther) {
  EXPECT_EQ(counts_of(trends(of_lambda(-1.0, -1.0, 0.05, 4))), (Counts{1, 0, 0}));
  EXPECT_EQ(counts_of(trends(of_lambda(-1.0, +1.0, 0.05, 4))), (Counts{0, 1, 0}));
  EXPECT_EQ(counts_of(trends(of_lambda(0.008, -1.0, 0.5, 3))), (Counts{0, 0, 1}));
}

}  // namespace
}  // namespace waywright::rrt_woa
