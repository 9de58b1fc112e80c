#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/tree/improved_way.hpp"
#include "waywright/planner/tree/plane_tree.hpp"
#include "waywright/planner/tree/whale_steering.hpp"

namespace waywright {
namespace {

Problem walls() {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {20, 20})};
  s.map.obstacles = {rectangle({5.0, 0.0}, {5.6, 12.6}), rectangle({5.0, 13.8}, {5.6, 20}), rectangle({10.0, 0.0}, {10.6, 5.4}), rectangle({10.0, 6.6}, {10.6, 20}),
                     rectangle({15.0, 0.0}, {15.6, 13.0}), rectangle({15.0, 14.2}, {15.6, 20})};
  s.vehicle.footprint = {{}, 0.1};
  s.vehicle.drive = Differential{0.5};
  s.start = {1.5, 1.5, 0.0};
  s.mission = Pose{18.5, 18.5, 0.0};
  return Problem::prepare(std::move(s)).value();
}

struct Grown {
  PlaneTree tree;
  const PlaneTree& grow(const PlaneSpace& space, const PlaneTreeOptions& options, std::uint64_t seed) {
    Budget budget;
    tree.grow(space, options, space.problem().start().position(), {{space.problem().goal().position()}}, seed, budget, std::numeric_limits<std::int64_t>::max());
    return tree;
  }
};

TEST(PlaneTree, CostsAddUpAndEdgesAreFreeWhateverWasRewired) {
  const Problem problem = walls();
  const PlaneSpace space{problem};
  for (const double radius : {0.0, 1.5}) {
    Grown grown;
    const PlaneTree& tree = grown.grow(space, {.samples = 4000, .radius = radius}, 3);
    EXPECT_GT(tree.statistics().rewired, 100);
    for (std::uint32_t i = 1; i < tree.size(); ++i) {
      const std::uint32_t p = tree.parent(i);
      ASSERT_NEAR(tree.cost(i), tree.cost(p) + distance(tree.place(i), tree.place(p)), 1e-12);
      ASSERT_TRUE(space.is_free(tree.place(p), tree.place(i)) || space.is_free(tree.place(i), tree.place(p)));
      int steps = 0;
      for (std::uint32_t n = i; n != PlaneTree::none; n = tree.parent(n)) ASSERT_LT(++steps, 5000) << "a circle";
    }
    ASSERT_TRUE(tree.is_found());
    const std::vector<Vec2> way = tree.way();
    EXPECT_NEAR(length_of_way(way), tree.length(), 1e-9);
    EXPECT_EQ(way.front(), problem.start().position());
    EXPECT_EQ(way.back(), problem.goal().position());
  }
}

/// Through a gap that hardly a sample falls into, farther than the goal's threshold.
TEST(PlaneTree, LooksForTheGoalFromTheStartBeforeItDrawsAnything) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {12, 8})};
  s.map.obstacles = {rectangle({5.5, 0}, {6.5, 3.85}), rectangle({5.5, 4.15}, {6.5, 8})};
  s.vehicle.footprint = {{}, 0.1};
  s.vehicle.drive = Differential{0.5};
  s.start = {1.5, 4, 0};
  s.mission = Pose{10.5, 4, 0};
  const Problem problem = Problem::prepare(std::move(s)).value();
  const PlaneSpace space{problem};
  for (const bool rewires : {false, true}) {
    Grown grown;
    const PlaneTree& first = grown.grow(space, {.samples = 3, .rewires = rewires, .first_path = true}, 1);
    ASSERT_TRUE(first.is_found());
    EXPECT_EQ(first.statistics().samples, 0);
    EXPECT_EQ(first.length(), 9.0);
    EXPECT_EQ(first.way().size(), 2U);
    const PlaneTree& all = grown.grow(space, {.samples = 300, .rewires = rewires, .informed = true}, 1);
    EXPECT_EQ(all.length(), 9.0);  // nothing is shorter
    EXPECT_EQ(all.way().size(), 2U);
  }
}

TEST(PlaneTree, RewiringHelpsAndMoreSamplesHelpMore) {
  const Problem problem = walls();
  const PlaneSpace space{problem};
  Budget budget;
  const double least = least_length(space, budget).metres;
  double first = 0.0, short_run = 0.0, long_run = 0.0, informed = 0.0;
  constexpr int runs = 20;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    Grown grown;
    const auto length = [&](const PlaneTreeOptions& options) {
      const PlaneTree& tree = grown.grow(space, options, seed);
      EXPECT_TRUE(tree.is_found());
      EXPECT_GE(tree.length(), least);
      return tree.length();
    };
    first += length({.radius = 1.5, .first_path = true});
    short_run += length({.samples = 2500});
    long_run += length({.samples = 10'000});
    informed += length({.samples = 10'000, .informed = true});
  }
  EXPECT_LT(short_run, first);
  EXPECT_LT(long_run, short_run);
  EXPECT_LT(informed, long_run);
  EXPECT_LT(informed / runs, 1.03 * least);
}

TEST(PlaneTree, SameSeedSameTreeAlsoInMemoryThatWasUsed) {
  const Problem problem = walls();
  const PlaneSpace space{problem};
  Grown one, other;
  other.grow(space, {.samples = 3000, .radius = 2.0}, 77);
  const PlaneTree& a = one.grow(space, {.samples = 2000}, 5);
  const PlaneTree& b = other.grow(space, {.samples = 2000}, 5);
  ASSERT_EQ(a.size(), b.size());
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a.place(i), b.place(i));
    ASSERT_EQ(a.parent(i), b.parent(i));
    ASSERT_EQ(a.cost(i), b.cost(i));
  }
  const PlaneTree& c = other.grow(space, {.samples = 2000}, 6);
  EXPECT_NE(a.place(5), c.place(5));
}

/// Two rooms of 6 × 6 m, a wall of 0.4 m with a passage in its middle between them; a disc of 0.1 m.
Problem rooms(double gap) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {12.4, 6})};
  s.map.obstacles = {rectangle({6.0, 0.0}, {6.4, 3.0 - 0.5 * gap}), rectangle({6.0, 3.0 + 0.5 * gap}, {6.4, 6.0})};
  s.vehicle.footprint = {{}, 0.1};
  s.vehicle.drive = Differential{0.5};
  s.start = {1.0, 1.0, 0.0};
  s.mission = Pose{11.4, 1.0, 0.0};
  return Problem::prepare(std::move(s)).value();
}

// How many samples a passage takes an RRT whose steps are as long as they need be and that looks for the goal from everywhere. Disc's middles (r from everything) have
// w = gap − 2 r across in the passage, which is t = 0.4 + 2 r long; d = w/2. Along its middle stand balls of radius d/5, d/5 apart, the first one just in the left room,
// the last one in the right one: k = ⌈(t + 2 d/5)/(d/5)⌉ + 1 of them. A ball of radius d about each middle is free.
// - The first ball is reached by a sample in it: the nearest node is in the left room, which is convex, or in the strip of the passage, which is, too, or already in the
//   right room, where the goal is seen from every node.
// - With a node in ball i, a sample in ball i + 1 becomes a node: the nearest node is no farther from it than that one, 3 d/5 at most, so 4 d/5 from the middle of ball
//   i + 1, and the line between is within d of that middle: free.
// A sample is in a given ball with p = π (d/5)²/F, F the free area, so that the way is there when k of the samples, each the next one wanted, have come: of n samples fewer
// than k do with a probability of at most exp(−(np − k)²/(2 np)) (Chernoff), which is 0.01 for np = k + l + √(l² + 2 k l), l = ln 100. Of 100 seeds then fewer than 95 find
// a way with a probability under 6·10⁻⁴ (binomial, 0.01, more than 5).
TEST(PlaneTree, RrtFindsAPassageWithAsManySamplesAsItsWidthAsksFor) {
  for (const double gap : {0.4, 0.7, 1.6}) {
    const Problem problem = rooms(gap);
    const PlaneSpace space{problem};
    const double r = space.needed(), w = gap - 2.0 * r, side = 6.0 - 2.0 * r, length = 0.4 + 2.0 * r, ball = 0.5 * w / 5.0;
    const double free = 2.0 * side * side + w * length, p = pi * ball * ball / free;
    const double balls = std::ceil((length + 2.0 * ball) / ball) + 1.0, l = std::log(100.0);
    const auto samples = static_cast<std::int64_t>(std::ceil((balls + l + std::sqrt(l * l + 2.0 * balls * l)) / p));
    int found = 0, found_with_few = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      Grown grown;
      PlaneTreeOptions options{.samples = samples, .step = 100.0, .goal_threshold = 100.0, .rewires = false, .first_path = true};
      found += grown.grow(space, options, seed).is_found() ? 1 : 0;
      options.samples = 3;
      found_with_few += grown.grow(space, options, seed).is_found() ? 1 : 0;
    }
    EXPECT_GE(found, 95) << "gap " << gap << ", samples " << samples;
    EXPECT_LT(found_with_few, 80) << "gap " << gap;
  }
}

TEST(WhaleSteering, FewerNodesThanWithoutIt) {
  const Problem problem = walls();
  const PlaneSpace space{problem};
  std::size_t with = 0, without = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    PlaneTree tree;
    Budget budget;
    WhaleSteering steering{space, {}};
    const PlaneTreeOptions options{.radius = 1.5, .first_path = true};
    tree.grow(space, options, {1.5, 1.5}, {{{18.5, 18.5}}}, seed, budget, 1 << 30, &steering);
    ASSERT_TRUE(tree.is_found());
    with += tree.size();
    tree.grow(space, options, {1.5, 1.5}, {{{18.5, 18.5}}}, seed, budget, 1 << 30);
    ASSERT_TRUE(tree.is_found());
    without += tree.size();
  }
  EXPECT_LT(with, without);
}

TEST(WhaleRefinement, NeverLongerAlwaysFreeSameEnds) {
  const Problem problem = walls();
  const PlaneSpace space{problem};
  WhaleRefinement refinement;
  int better = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Grown grown;
    const std::vector<Vec2> way = grown.grow(space, {.radius = 1.5, .first_path = true}, seed).way();
    for (const double start : {0.0, 2.0, 4.0}) {
      Budget budget;
      const std::vector<Vec2> moved = refinement.refined(way, space, {.whale = {.start = start}}, seed, budget);
      ASSERT_EQ(moved.size(), way.size());
      EXPECT_EQ(moved.front(), way.front());
      EXPECT_EQ(moved.back(), way.back());
      EXPECT_LE(length_of_way(moved), length_of_way(way) + 1e-12);
      EXPECT_EQ(refinement.evaluations(), 10 * 11);
      for (std::size_t i = 1; i < moved.size(); ++i) {
        EXPECT_TRUE(space.is_free(moved[i - 1], moved[i]));
        EXPECT_LE(std::abs(moved[i].x - way[i].x), 2.5 + 1e-12);
        EXPECT_LE(std::abs(moved[i].y - way[i].y), 2.5 + 1e-12);
      }
      better += length_of_way(moved) < length_of_way(way) ? 1 : 0;
    }
  }
  EXPECT_GT(better, 10);
}

TEST(ImprovedWay, ComesNearTheShortest) {
  const Problem problem = walls();
  const PlaneSpace space{problem};
  Budget budget;
  const double least = least_length(space, budget).metres;
  double sum = 0.0, published = 0.0;
  constexpr int runs = 20;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    Grown grown;
    const std::vector<Vec2> way = grown.grow(space, {.radius = 1.5, .first_path = true}, seed).way();
    const ImprovedWay improved = improved_way(way, space, {}, 12, seed, budget);
    EXPECT_LE(length_of_way(improved.points), length_of_way(way));
    EXPECT_GE(length_of_way(improved.points), least - 1e-9);
    for (std::size_t i = 1; i < improved.points.size(); ++i) EXPECT_TRUE(space.is_free(improved.points[i - 1], improved.points[i]));
    sum += length_of_way(improved.points);
    published += length_of_way(WhaleRefinement{}.refined(way, space, {}, seed, budget));
  }
  EXPECT_LT(sum, published);
  EXPECT_LT(sum / runs, 1.05 * least);
}

TEST(ImprovedWay, KeepsNoMoreForPicturesThanAreDrawn) {
  const Problem problem = walls();
  const PlaneSpace space{problem};
  Budget budget;
  Grown grown;
  const std::vector<Vec2> way = grown.grow(space, {.radius = 1.5, .first_path = true}, 1).way();
  const ImprovedWay improved = improved_way(way, space, {.iterations = 100}, 12, 1, budget);
  EXPECT_GT(improved.rounds, 1);
  EXPECT_LE(improved.agents.size(), WhaleRefinement::most_drawn);
  EXPECT_GE(improved.agents.size(), WhaleRefinement::most_drawn / 2);
}

}  // namespace
}  // namespace waywright
