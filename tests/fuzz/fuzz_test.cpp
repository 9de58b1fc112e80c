// The fuzz targets without a fuzzer: their seeds and a few thousand seeded mutations of them.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/fuzz/mutator.hpp"
#include "tests/fuzz/target.hpp"

namespace waywright::fuzz {
namespace {

/// Only letters and digits, so that it can be pasted into a test.
std::string quoted(const std::string& bytes) {
  std::string text;
  for (const char c : bytes.substr(0, 20'000)) {
    if (c >= 0x20 && c < 0x7F) text += c;
    else text += "\\x" + std::string{"0123456789abcdef"[static_cast<unsigned char>(c) / 16]} + "0123456789abcdef"[static_cast<unsigned char>(c) % 16];
  }
  return text;
}

struct Count {
  int accepted = 0;
  int refused = 0;
};

/// Runs one input; false where a promise is broken.
bool holds(const Target& target, const std::string& bytes, Count& count) {
  try {
    ++(target.run(bytes) == Outcome::accepted ? count.accepted : count.refused);
    return true;
  } catch (const Broken& broken) {
    ADD_FAILURE() << target.name << ": " << broken.what() << "\ninput: " << quoted(bytes);
  } catch (const std::exception& e) {
    ADD_FAILURE() << target.name << " threw " << e.what() << "\ninput: " << quoted(bytes);
  }
  return false;
}

struct Quota {
  const char* target;
  int mutations;
  int least_accepted;  ///< the mutations must reach beyond the first check
  int least_refused;
};

class Fuzz : public testing::TestWithParam<Quota> {};

TEST_P(Fuzz, SeedsAndTheirMutationsKeepEveryPromise) {
  const Quota& run = GetParam();
  const auto target = std::find_if(targets().begin(), targets().end(), [&](const Target& t) { return t.name == run.target; });
  ASSERT_NE(target, targets().end());
  const std::vector<std::string> seeds = target->seeds();
  std::vector<Mutator::Json> trees;
  Count count;
  for (const std::string& seed : seeds) {
    ASSERT_TRUE(holds(*target, seed, count));
    if (target->is_json) trees.push_back(Mutator::Json::parse(seed));
  }
  Mutator mutate{20260101};
  for (int i = 0; i < run.mutations; ++i) {
    const std::size_t seed = static_cast<std::size_t>(i) % seeds.size();
    const bool tree = target->is_json && i / static_cast<int>(seeds.size()) % 2 == 1;
    ASSERT_TRUE(holds(*target, tree ? mutate.tree(trees[seed]) : mutate.bytes(seeds[seed]), count)) << "mutation " << i;
  }
  EXPECT_GE(count.accepted, run.least_accepted);
  EXPECT_GE(count.refused, run.least_refused);
}

INSTANTIATE_TEST_SUITE_P(Targets, Fuzz,
                         testing::Values(Quota{"scenario", 30'000, 1000, 10'000}, Quota{"plan", 30'000, 1000, 10'000}, Quota{"poses", 30'000, 1000, 5'000}, Quota{"site", 30'000, 1000, 5'000},
                                         Quota{"whale_config", 30'000, 500, 10'000}, Quota{"obstacles", 30'000, 1000, 5'000},
                                         Quota{"image", 20'000, 1000, 5'000}, Quota{"ros_map", 10'000, 500, 1'000}, Quota{"movingai", 10'000, 40, 1'000}, Quota{"svg", 20'000, 500, 5'000}, Quota{"rmf", 12'000, 500, 3'000}, Quota{"opentcs", 12'000, 500, 3'000}, Quota{"trace", 3'000, 1'000, 0}, Quota{"dxf", 6'000, 500, 500}, Quota{"station", 600, 50, 50}),
                         [](const auto& entry) { return std::string{entry.param.target}; });

}  // namespace
}  // namespace waywright::fuzz
