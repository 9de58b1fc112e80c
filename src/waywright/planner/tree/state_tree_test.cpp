#include "waywright/planner/tree/state_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/oracle/brute_force.hpp"
#include "waywright/planner/plane/proven_radius.hpp"
#include "waywright/planner/steering/shortcut.hpp"

namespace waywright {
namespace {

constexpr std::int64_t no_end = std::numeric_limits<std::int64_t>::max();
constexpr SteeringKind with_headings[] = {SteeringKind::turns, SteeringKind::dubins, SteeringKind::reeds_shepp};
constexpr double clearance = 0.05;

/// Two rooms and a door in the middle of the wall between; the vehicle is 1 m × 0.5 m.
Scenario rooms() {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {9, 6})};
  s.map.obstacles = {rectangle({4.3, 0}, {4.7, 2.5}), rectangle({4.3, 3.5}, {4.7, 6})};
  s.vehicle.footprint.polygon = rectangle({-0.3, -0.25}, {0.7, 0.25});
  s.vehicle.drive = Differential{0.4};
  s.start = {1.0, 1.0, 0.0};
  s.mission = Pose{8.0, 1.5, -1.2};
  s.clearance = clearance;
  return s;
}

Scenario hall() {
  Scenario s = rooms();
  s.map.obstacles.clear();
  return s;
}

/// The same, moved.
Scenario moved(const Scenario& s, const Pose& by) {
  const Frame frame{by};
  const auto pose = [&](const Pose& p) { return make_pose(frame.rotate(p.position()) + by.position(), wrap(p.heading + by.heading)); };
  Scenario m = s;
  for (Ring& ring : m.map.boundaries) ring = transformed(ring, frame);
  for (Ring& ring : m.map.obstacles) ring = transformed(ring, frame);
  m.start = pose(s.start);
  m.mission = pose(std::get<Pose>(s.mission));
  return m;
}

/// A problem with a query of it, as the planner asks.
struct Asked {
  Problem problem;
  Budget budget;
  std::unique_ptr<const Steering> steering;
  MotionTest test;
  StateQuery query;

  Asked(const Scenario& scenario, SteeringKind kind, std::int64_t motions = no_end)
      : problem{Problem::prepare(scenario).value()},
        steering{make_steering(kind, {0.6, 0.2, 0.0})},
        test{problem, {no_end, motions, 0.001}, budget},
        query{*steering, test, problem.start(), problem.goal(), search_region(problem, steering->is_curve() ? 0.6 : 0.0, steering->is_curve()), motions} {}
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;
};

const StateTree& grown(StateTree& tree, Asked& asked, const PlaneTreeOptions& options, std::uint64_t seed) {
  tree.grow(asked.query, options, seed, asked.budget);
  return tree;
}

TEST(StateTree, CostsAddUpAndEdgesAreFreeWhateverWasRewired) {
  for (const SteeringKind kind : with_headings) {
    for (const double radius : {0.0, 2.0}) {
      Asked asked{rooms(), kind};
      StateTree tree;
      grown(tree, asked, {.samples = 700, .radius = radius, .goal_threshold = 3.0}, 3);
      EXPECT_GT(tree.statistics().rewired, 30) << to_string(kind);
      ASSERT_GT(tree.size(), 150U);
      for (std::uint32_t i = 1; i < tree.size(); ++i) {
        const std::uint32_t p = tree.parent(i);
        ASSERT_EQ(tree.cost(i), tree.cost(p) + asked.steering->distance(tree.state(p), tree.state(i)));
        ASSERT_GE(tree.cost(i), asked.steering->least(asked.query.start, tree.state(i)) - 1e-9);
        int steps = 0;
        for (std::uint32_t n = i; n != StateTree::none; n = tree.parent(n)) ASSERT_LT(++steps, 1000) << "a circle";
        // What is free is told by a check that shares nothing with the search's.
        if (i % 7 != 0) continue;
        const Path edge{asked.steering->between(tree.state(p), tree.state(i))};
        ASSERT_GE(oracle_path_clearance(asked.problem.world().map(), {}, {}, asked.problem.footprint(), edge, 0.01), clearance - 1e-9) << to_string(kind);
      }
      ASSERT_TRUE(tree.is_found()) << to_string(kind);
      const std::vector<Pose> way = tree.way();
      EXPECT_NEAR(cost_of(*asked.steering, way), tree.cost(), 1e-9);
      EXPECT_EQ(way.front(), asked.query.start);
      EXPECT_EQ(way.back(), asked.query.goal);
      EXPECT_GE(tree.cost(), asked.steering->least(asked.query.start, asked.query.goal) - 1e-9);
    }
  }
}

TEST(StateTree, RewiringHelpsAndNoSeedIsWorseForIt) {
  for (const SteeringKind kind : with_headings) {
    double plain = 0.0, first = 0.0, rewired = 0.0;
    int both = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      Asked asked{rooms(), kind};
      StateTree rrt, star;
      // Up to the first way both draw the same and grow to the same places: RRT* hangs them no worse.
      const PlaneTreeOptions options{.samples = 1500, .goal_threshold = 3.0, .rewires = false, .first_path = true};
      grown(rrt, asked, options, seed);
      grown(star, asked, {.samples = 1500, .goal_threshold = 3.0}, seed);
      if (!rrt.is_found()) continue;
      ++both;
      ASSERT_TRUE(star.is_found());
      EXPECT_LE(*star.statistics().first_cost, rrt.cost() + 1e-9) << to_string(kind) << " " << seed;
      EXPECT_LE(star.cost(), *star.statistics().first_cost);
      plain += rrt.cost();
      first += *star.statistics().first_cost;
      rewired += star.cost();
    }
    EXPECT_GE(both, 5) << to_string(kind);
    EXPECT_LT(rewired, 0.97 * plain) << to_string(kind);
    EXPECT_LE(first, plain);
  }
}

TEST(StateTree, TendsToTheShortestCurve) {
  for (const SteeringKind kind : {SteeringKind::dubins, SteeringKind::reeds_shepp}) {
    Scenario s = hall();
    Asked open{s, kind};
    const double least = open.steering->distance(open.query.start, open.query.goal);
    StateTree direct;
    grown(direct, open, {.samples = 100}, 1);
    ASSERT_TRUE(direct.is_found());
    EXPECT_TRUE(direct.statistics().is_least);
    EXPECT_EQ(direct.statistics().samples, 0);
    EXPECT_EQ(direct.cost(), least);
    // A post that the side of the vehicle would touch on that way: the shortest one is hardly longer, and has to be found.
    const Pose middle = open.steering->at(open.query.start, open.query.goal, 0.5);
    s.map.points.push_back(middle.position() + 0.25 * left_of(unit(middle.heading)));
    double few = 0.0, many = 0.0;
    constexpr int runs = 3;
    for (std::uint64_t seed = 1; seed <= runs; ++seed) {
      Asked asked{s, kind};
      ASSERT_FALSE(asked.test.motion_free(asked.steering->between(asked.query.start, asked.query.goal)));
      StateTree tree;
      grown(tree, asked, {.samples = 300, .goal_threshold = 4.0, .informed = true}, seed);
      ASSERT_TRUE(tree.is_found());
      few += tree.cost() / runs;
      grown(tree, asked, {.samples = 3000, .goal_threshold = 4.0, .informed = true}, seed);
      many += tree.cost() / runs;
      EXPECT_GE(tree.cost(), least - 1e-9);
    }
    EXPECT_LT(many, few);
    EXPECT_LT(many, 1.03 * least) << to_string(kind);
  }
}

TEST(StateTree, SameSeedSameTreeAlsoInMemoryThatWasUsed) {
  for (const SteeringKind kind : with_headings) {
    Asked asked{rooms(), kind}, other{rooms(), kind};
    StateTree one, used;
    used.grow(other.query, {.samples = 200, .radius = 3.0}, 77, other.budget);
    grown(one, asked, {.samples = 300}, 5);
    grown(used, other, {.samples = 300}, 5);
    ASSERT_EQ(one.size(), used.size());
    for (std::uint32_t i = 0; i < one.size(); ++i) {
      ASSERT_EQ(one.state(i), used.state(i));
      ASSERT_EQ(one.parent(i), used.parent(i));
      ASSERT_EQ(one.cost(i), used.cost(i));
    }
    grown(used, other, {.samples = 300}, 6);
    EXPECT_NE(one.state(5), used.state(5));
  }
}

/// Draws are of the map's frame, so that trees differ; what a way may cost does not.
TEST(StateTree, MovingEverythingKeepsWhatIsFree) {
  Random random{12};
  for (const SteeringKind kind : with_headings) {
    const Pose by{3.0, -20.0, 1.1};
    Asked asked{rooms(), kind}, other{moved(rooms(), by), kind};
    const Frame frame{by};
    int free = 0;
    for (int i = 0; i < 300; ++i) {
      const Pose a{random.uniform(0.5, 8.5), random.uniform(0.5, 5.5), random.uniform(-3, 3)}, b{random.uniform(0.5, 8.5), random.uniform(0.5, 5.5), random.uniform(-3, 3)};
      const auto pose = [&](const Pose& p) { return make_pose(frame.rotate(p.position()) + by.position(), wrap(p.heading + by.heading)); };
      EXPECT_NEAR(asked.steering->distance(a, b), other.steering->distance(pose(a), pose(b)), 1e-7);
      const bool is_free = asked.test.motion_free(asked.steering->between(a, b));
      EXPECT_EQ(is_free, other.test.motion_free(other.steering->between(pose(a), pose(b))));
      free += is_free ? 1 : 0;
    }
    EXPECT_GT(free, 5);
    double here = 0.0, there = 0.0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      StateTree tree;
      here += grown(tree, asked, {.samples = 1200, .goal_threshold = 3.0, .informed = true}, seed).cost();
      there += grown(tree, other, {.samples = 1200, .goal_threshold = 3.0, .informed = true}, seed).cost();
    }
    EXPECT_NEAR(here / there, 1.0, 0.15) << to_string(kind);
  }
}

TEST(StateTree, EndsWithItsWork) {
  Scenario shut = rooms();
  shut.map.obstacles = {rectangle({4.3, 0}, {4.7, 6})};
  Asked few{shut, SteeringKind::reeds_shepp, 40};
  StateTree tree;
  grown(tree, few, {.samples = 100'000}, 1);
  EXPECT_FALSE(tree.is_found());
  EXPECT_LE(few.test.motions(), 40);
  EXPECT_TRUE(tree.way().empty());
  for (std::uint32_t i = 0; i < tree.size(); ++i) EXPECT_LT(tree.state(i).x, 4.3);
  Asked asked{shut, SteeringKind::turns};
  std::atomic<bool> flag{true};
  Budget canceled{{}, &flag};
  tree.grow(asked.query, {.samples = 100'000}, 1, canceled);
  EXPECT_EQ(tree.size(), 1U);
  // Where hardly a state is free a search that finds none to draw ends.
  Scenario tight = shut;
  tight.map.boundaries = {rectangle({0.6, 0.65}, {1.8, 1.35})};
  tight.map.obstacles.clear();
  tight.mission = Pose{1.02, 1.0, 0.0};
  Asked box{tight, SteeringKind::dubins};
  tree.grow(box.query, {.samples = 3, .goal_threshold = 1e-3}, 1, box.budget);
  EXPECT_LE(tree.statistics().samples, 3);
}

}  // namespace
}  // namespace waywright
