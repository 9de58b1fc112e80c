#include "waywright/core/spelling.hpp"

#include <gtest/gtest.h>

namespace waywright {
namespace {

TEST(Spelling, TheNearestWordWithinAFewEdits) {
  const std::vector<std::string> known{"astar", "theta_star", "safe_astar", "dijkstra", "w"};
  EXPECT_EQ(nearest_word("asatr", known), "astar") << "two swapped";
  EXPECT_EQ(nearest_word("a_star", known), "astar") << "one more";
  EXPECT_EQ(nearest_word("thetastar", known), "theta_star") << "one less";
  EXPECT_EQ(nearest_word("dijkstrb", known), "dijkstra") << "another";
  EXPECT_EQ(nearest_word("saf_astra", known), "safe_astar");
  EXPECT_EQ(nearest_word("voronoi", known), "");
  EXPECT_EQ(nearest_word("", known), "") << "no letter of it would be left";
  EXPECT_EQ(nearest_word("v", known), "");
  EXPECT_EQ(nearest_word("x", {}), "");
  EXPECT_EQ(nearest_word(std::string(65, 'a'), {std::string(65, 'a')}), "");
  EXPECT_EQ(nearest_word("ab", {"ac", "ad"}), "ac") << "the first of several";
}

TEST(Spelling, WordsForMessages) {
  EXPECT_EQ(meant_instead("forbiden", {"directed", "forbidden"}), ", did you mean \"forbidden\"?");
  EXPECT_EQ(meant_instead("speed", {"directed", "forbidden"}), "");
  EXPECT_EQ(list_of_words({"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(list_of_words({}), "");
}

}  // namespace
}  // namespace waywright
