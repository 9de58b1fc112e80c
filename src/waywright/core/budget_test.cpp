#include "waywright/core/budget.hpp"

#include <gtest/gtest.h>

namespace waywright {
namespace {

TEST(Budget, WithoutAClockItNeverEnds) {
  Budget budget{{.evaluations = 10, .expansions = {}, .samples = {}, .seconds = {}}};
  budget.count_evaluations();
  budget.count_evaluations(20);
  EXPECT_EQ(budget.evaluations(), 21);
  EXPECT_FALSE(budget.exhausted());
  EXPECT_FALSE(budget.cut_short());
  EXPECT_FALSE(budget.seconds_left());
}

TEST(Budget, TheClockCutsShortAndSaysSo) {
  Budget budget{{.evaluations = {}, .expansions = {}, .samples = {}, .seconds = 1e-9}};
  while (budget.elapsed() <= 1e-9) {
  }
  EXPECT_FALSE(budget.cut_short());  // nobody has asked yet
  EXPECT_TRUE(budget.exhausted());
  EXPECT_TRUE(budget.cut_short());
  EXPECT_LE(*budget.seconds_left(), 0.0);
}

TEST(Budget, TheFlagCancels) {
  std::atomic<bool> flag = false;
  Budget budget{{}, &flag};
  EXPECT_FALSE(budget.exhausted());
  flag = true;
  EXPECT_TRUE(budget.canceled());
  EXPECT_TRUE(budget.exhausted());
  EXPECT_FALSE(budget.cut_short());  // the clock had no part in it
}

}  // namespace
}  // namespace waywright
