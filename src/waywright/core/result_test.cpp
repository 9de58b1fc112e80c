#include "waywright/core/result.hpp"

#include <gtest/gtest.h>

#include <set>

namespace waywright {
namespace {

TEST(Status, WordsRoundTrip) {
  std::set<std::string> words;
  for (const Status status : {Status::solved, Status::unproven, Status::no_path, Status::start_in_collision,
                              Status::goal_in_collision, Status::start_outside, Status::goal_outside,
                              Status::timed_out, Status::canceled}) {
    const std::string word = to_string(status);
    EXPECT_EQ(status_from_string(word), status) << word;
    words.insert(word);
  }
  EXPECT_EQ(words,
            (std::set<std::string>{"solved", "unproven", "no_path", "start_in_collision", "goal_in_collision",
                                   "start_outside", "goal_outside", "timed_out", "canceled"}));
}

TEST(Status, UnknownWordsAreNone) {
  for (const char* word : {"", "Solved", "solved ", "ok", "cancelled"})
    EXPECT_FALSE(status_from_string(word)) << word;
}

TEST(InputError, OneSentence) {
  EXPECT_EQ((InputError{"site.json", "station.shelf.size[0]", "is -1", "more than 0"}.message()),
            "site.json: station.shelf.size[0]: is -1 (allowed: more than 0)");
  EXPECT_EQ((InputError{"site.json", "", "is not JSON", ""}.message()), "site.json: is not JSON");
  EXPECT_EQ((InputError{"", "goal", "is missing", ""}.message()), "goal: is missing");
}

// As a load's name out of a file came through: "a\u0000b".
TEST(InputError, IsOneLineWhateverNamesAreInIt) {
  EXPECT_EQ((InputError{"s\njson", "carried_load", std::string{"the vehicle has no load \"a\0b\"", 29}, "x\x1b[2J\x7f"}.message()),
            "s?json: carried_load: the vehicle has no load \"a?b\" (allowed: x?[2J?)");
  EXPECT_EQ(one_line("ä → 1"), "ä → 1");
}

TEST(Result, ValueOrFailure) {
  const Result<int> value = 3;
  const Result<int> failure = tl::unexpected{Failure{Status::timed_out, "out of time"}};
  ASSERT_TRUE(value);
  EXPECT_EQ(*value, 3);
  ASSERT_FALSE(failure);
  EXPECT_EQ(failure.error().status, Status::timed_out);
  EXPECT_FALSE(failure.error().pose);
}

}  // namespace
}  // namespace waywright
