// A million random motions: the proven bound against an independent measure of the clearance.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/oracle/brute_force.hpp"
#include "tests/oracle/random_motions.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

using namespace random_motions;

constexpr double fine = 0.0005;  // m of motion between the poses measured where it is tight

/// What of the motions was seen.
struct Tally {
  int motions = 0, free = 0;
  int bent = 0;      ///< nearly a cusp somewhere: refused, as it would take too many samples
  int cautious = 0;  ///< free by more than the tolerance, not bent like that, and not proven
  int low = 0;       ///< proven, but under the clearance by more than the tolerance
};

void measure(int motions, std::uint64_t seed, Tally& tally) {
  Random random = Random::stream(seed, 4);
  for (int i = 0; i < motions; ++i) {
    const Clutter clutter{static_cast<int>(random.integer(0, 6)), static_cast<int>(random.integer(0, 10)), static_cast<int>(random.integer(0, 3)),
                          static_cast<int>(random.integer(0, 2))};
    const Map map = random_map(random, clutter);
    const Path path = random_path(random);
    const Footprint footprint = random_footprint(random);
    const Proof proof = prove(problem_for(map, path, footprint), path);
    const double truth = oracle_refined_clearance(map, footprint, path, 0.1, fine);
    const Certificate& c = proof.certificate;
    ASSERT_LE(c.clearance, truth + 1e-9) << "seed " << seed << " motion " << i;
    ASSERT_TRUE(truth > 0.0 || !c.collision_free) << "seed " << seed << " motion " << i;
    ++tally.motions;
    if (truth > 0.0) ++tally.free;
    if (samples_needed(path, footprint.radius(), c.tolerance) > static_cast<double>(most_samples)) {
      ++tally.bent;
    } else if (truth > c.tolerance && !c.collision_free) {
      ++tally.cautious;
    }
    if (c.collision_free && c.clearance < truth - c.tolerance - fine) ++tally.low;
  }
}

void report(const Tally& tally) {
  std::printf("%d motions, %d of them free; too bent to be judged: %d; proof needlessly refused: %d; bound lower than its tolerance: %d\n", tally.motions,
              tally.free, tally.bent, tally.cautious, tally.low);
  EXPECT_LE(tally.bent, tally.motions / 20);
  EXPECT_GT(tally.free, tally.motions / 20);
  EXPECT_LE(tally.cautious, tally.motions / 1000);
  EXPECT_LE(tally.low, tally.motions / 1000);
}

class RandomMotions : public testing::TestWithParam<int> {};

TEST_P(RandomMotions, BoundIsNeverAboveTheClearance) {
  Tally tally;
  measure(100'000, static_cast<std::uint64_t>(GetParam()), tally);
  report(tally);
}

INSTANTIATE_TEST_SUITE_P(Full, RandomMotions, testing::Range(100, 110));

TEST(RandomMotions, AFewOfThem) {
  Tally tally;
  measure(1'000, 99, tally);
  report(tally);
}

// A vehicle that moves any way: headings of their own along lines and arcs, turning by up to three times around.
TEST(RandomMotions, HeadingsOfTheirOwn) {
  Random random{1234};
  int free = 0, cautious = 0, low = 0;
  for (int i = 0; i < 1500; ++i) {
    const Map map = random_map(random, {static_cast<int>(random.integer(0, 6)), static_cast<int>(random.integer(0, 10)), 1, 1});
    const Path path = random_sliding_path(random);
    const Footprint footprint = random_footprint(random);
    const Problem problem = problem_for(map, path, footprint, mecanum_base());
    const Proof proof = prove(problem, path);
    for (const Violation& v : proof.violations) EXPECT_TRUE(v.sentence.find("touch") != std::string::npos || v.sentence.find("within the pose error") != std::string::npos) << i << ": " << v.sentence;
    const double truth = oracle_refined_clearance(map, footprint, path, 0.1, fine);
    const Certificate& c = proof.certificate;
    ASSERT_LE(c.clearance, truth + 1e-9) << i;
    ASSERT_TRUE(truth > 0.0 || !c.collision_free) << i;
    free += truth > 0.0 ? 1 : 0;
    cautious += truth > c.tolerance && !c.collision_free ? 1 : 0;
    low += c.collision_free && c.clearance < truth - c.tolerance - fine ? 1 : 0;
  }
  EXPECT_GT(free, 300);
  EXPECT_LE(cautious, 1);
  EXPECT_LE(low, 2);
}

// The measure itself, against dense sampling.
TEST(RandomMotions, TheMeasureFindsWhatDenseSamplingFinds) {
  Random random{77};
  for (int i = 0; i < 60; ++i) {
    const Map map = random_map(random, {4, 8, 2, 1});
    const Path path = random_path(random);
    const Footprint footprint = random_footprint(random);
    EXPECT_NEAR(oracle_refined_clearance(map, footprint, path, 0.1, fine), oracle_path_clearance(map, {}, {}, footprint, path, 0.002), 0.0015) << i;
  }
}

}  // namespace
}  // namespace waywright
