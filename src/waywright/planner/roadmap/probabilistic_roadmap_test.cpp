#include "waywright/planner/roadmap/probabilistic_roadmap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/least_length.hpp"

namespace waywright {
namespace {

constexpr std::int64_t no_end = std::numeric_limits<std::int64_t>::max();

/// Two rooms of 6 m × 6 m, the wall between them 0.4 m thick with a gap in the middle.
Problem two_rooms(double gap, double disc = 0.2) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {12.4, 6})};
  s.map.obstacles = {rectangle({6.0, 0}, {6.4, 3.0 - 0.5 * gap}), rectangle({6.0, 3.0 + 0.5 * gap}, {6.4, 6.0})};
  s.vehicle.footprint = {{}, disc};
  s.vehicle.drive = Differential{0.5};
  s.start = {1.0, 1.0, 0.0};
  s.mission = Pose{11.4, 1.0, 0.0};
  return Problem::prepare(std::move(s)).value();
}

Problem walls() {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {20, 20})};
  s.map.obstacles = {rectangle({5.0, 0.0}, {5.6, 12.0}), rectangle({5.0, 14.4}, {5.6, 20}), rectangle({10.0, 0.0}, {10.6, 4.8}), rectangle({10.0, 7.2}, {10.6, 20}),
                     rectangle({15.0, 0.0}, {15.6, 12.4}), rectangle({15.0, 14.8}, {15.6, 20})};
  s.vehicle.footprint = {{}, 0.1};
  s.vehicle.drive = Differential{0.5};
  s.start = {1.5, 1.5, 0.0};
  s.mission = Pose{18.5, 18.5, 0.0};
  return Problem::prepare(std::move(s)).value();
}

RoadmapAnswer answer_of(const PlaneSpace& space, const RoadmapOptions& options, std::uint64_t seed) {
  Budget budget;
  const ProbabilisticRoadmap roadmap{space, options, seed, budget};
  return roadmap.shortest(space.problem().start().position(), {{space.problem().goal().position()}}, budget, no_end);
}

TEST(ProbabilisticRoadmap, JoinsStartAndGoalHoweverFarTheyAreApart) {
  Scenario s = two_rooms(0.5).scenario();
  s.start = {1.0, 3.0, 0.0};
  s.mission = Pose{11.4, 3.0, 0.0};
  const Problem problem = Problem::prepare(std::move(s)).value();
  const PlaneSpace space{problem};
  for (const RoadmapOptions& options : {RoadmapOptions{100, 0.0, 0}, RoadmapOptions{100, 0.5, 0}, RoadmapOptions{100, 0.0, 5}}) {
    const RoadmapAnswer answer = answer_of(space, options, 1);
    ASSERT_EQ(answer.ended, RoadmapEnd::found);
    EXPECT_EQ(answer.way.size(), 2U);
    EXPECT_EQ(answer.length, 10.4);
    EXPECT_EQ(answer.lines, 1);
  }
}

// How many samples a passage takes. Disc's middles have w = gap − 2 needed across in it. The strip of that width that goes on straight into both rooms is convex and free.
// So any place a in the left room's part of the strip sees any place b in the right one's; rooms are convex, so the start sees a and b sees the goal. A roadmap whose radius
// spans all finds a way as soon as one sample falls into each of the two parts. Each part has the share p = w (6 − 2 needed) / F of the free area F, so n samples miss one
// of the two with a probability of at most 2 (1 − p)^n ≤ 2 exp(−n p), which is 0.01 for n = ln(200)/p. Of 100 seeds then fewer than 95 find a way with a probability
// under 6·10⁻⁴ (binomial, 0.01, more than 5).
TEST(ProbabilisticRoadmap, FindsAPassageWithAsManySamplesAsItsWidthAsksFor) {
  for (const double gap : {0.7, 1.0, 1.6}) {
    const Problem problem = two_rooms(gap);
    const PlaneSpace space{problem};
    const double r = space.needed(), w = gap - 2.0 * r;
    const double part = w * (6.0 - 2.0 * r), free = 2.0 * (6.0 - 2.0 * r) * (6.0 - 2.0 * r) + w * (0.4 + 2.0 * r);
    const auto samples = static_cast<std::int64_t>(std::ceil(std::log(200.0) * free / part));
    int found = 0, found_narrower = 0;
    Budget budget;
    const double least = least_length(space, budget).metres;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      const RoadmapAnswer answer = answer_of(space, {.samples = samples, .radius = 14.0}, seed);
      found += answer.ended == RoadmapEnd::found ? 1 : 0;
      if (answer.ended == RoadmapEnd::found) {
        EXPECT_GE(answer.length, least);
      }
      // A twentieth of them does not do (more than the strip helps, so some get through).
      found_narrower += answer_of(space, {.samples = std::max<std::int64_t>(1, samples / 20), .radius = 14.0}, seed).ended == RoadmapEnd::found ? 1 : 0;
    }
    EXPECT_GE(found, 95) << "gap " << gap << ", samples " << samples;
    EXPECT_LT(found_narrower, 80) << "gap " << gap;
  }
}

TEST(ProbabilisticRoadmap, MoreSamplesAreBetterOnTheAverageAndNoneIsUnderTheBound) {
  const Problem problem = walls();
  const PlaneSpace space{problem};
  Budget budget;
  const double least = least_length(space, budget).metres;
  for (const int neighbours : {0, 12}) {
    double before = std::numeric_limits<double>::infinity();
    for (const std::int64_t samples : {500, 2000, 6000}) {
      double sum = 0.0;
      int found = 0;
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const RoadmapAnswer answer = answer_of(space, {.samples = samples, .neighbours = neighbours}, seed);
        if (answer.ended != RoadmapEnd::found) continue;
        ++found;
        sum += answer.length;
        EXPECT_GE(answer.length, least - 1e-9);
        EXPECT_NEAR(length_of_way(answer.way), answer.length, 1e-9);
        for (std::size_t i = 1; i < answer.way.size(); ++i) EXPECT_TRUE(space.is_free(answer.way[i - 1], answer.way[i]));
      }
      EXPECT_GE(found, 19) << samples;
      const double mean = sum / found;
      EXPECT_LT(mean, before) << samples << " samples, " << neighbours << " neighbours";
      before = mean;
    }
    if (neighbours == 0) {
      EXPECT_LT(before, 1.02 * least);
    }
  }
}

/// Every line of the roadmap tested, then plain Dijkstra.
double by_hand(const PlaneSpace& space, const ProbabilisticRoadmap& roadmap, Vec2 start, const PlaneTarget& goal, std::int64_t& lines) {
  const std::size_t n = roadmap.size();
  std::vector<double> cost(n + 1, std::numeric_limits<double>::infinity());
  std::vector<bool> done(n + 1, false);
  const auto is_free = [&](Vec2 a, Vec2 b) {
    ++lines;
    return space.is_free(a, b);
  };
  double best = std::numeric_limits<double>::infinity();
  if (distance(start, goal.nearest(start)) <= roadmap.radius() && is_free(start, goal.nearest(start))) best = distance(start, goal.nearest(start));
  for (const std::uint32_t i : roadmap.near(start)) {
    if (is_free(start, roadmap.places()[i])) cost[i] = distance(start, roadmap.places()[i]);
  }
  std::vector<bool> ends(n, false);
  for (const std::uint32_t i : roadmap.near(goal)) ends[i] = true;
  while (true) {
    std::size_t at = n;
    for (std::size_t i = 0; i < n; ++i) {
      if (!done[i] && cost[i] < cost[at]) at = i;
    }
    if (at == n) return best;
    done[at] = true;
    const Vec2 here = roadmap.places()[at];
    if (ends[at] && is_free(here, goal.nearest(here))) best = std::min(best, cost[at] + distance(here, goal.nearest(here)));
    for (const std::uint32_t k : roadmap.neighbours_of(static_cast<std::uint32_t>(at))) {
      if (!done[k] && is_free(here, roadmap.places()[k])) cost[k] = std::min(cost[k], cost[at] + distance(here, roadmap.places()[k]));
    }
  }
}

TEST(ProbabilisticRoadmap, LinesTestedWhenWantedGiveTheShortestWayOfAllOfThem) {
  const Problem problem = walls();
  const PlaneSpace space{problem};
  const PlaneTarget point{{problem.goal().position()}}, region{rectangle({16.5, 12.0}, {19.0, 19.0})};
  std::int64_t all = 0, wanted = 0;
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Budget budget;
    const ProbabilisticRoadmap roadmap{space, {.samples = 600, .radius = seed % 3 == 0 ? 3.0 : 0.0}, seed, budget};
    for (const PlaneTarget& goal : {point, region}) {
      const RoadmapAnswer answer = roadmap.shortest(problem.start().position(), goal, budget, no_end);
      const double expected = by_hand(space, roadmap, problem.start().position(), goal, all);
      wanted += answer.lines;
      ASSERT_EQ(answer.ended == RoadmapEnd::found, std::isfinite(expected)) << seed;
      if (!std::isfinite(expected)) continue;
      EXPECT_NEAR(answer.length, expected, 1e-9);
      ++compared;
    }
  }
  EXPECT_GT(compared, 15);
  EXPECT_LT(wanted, all / 2);
}

TEST(ProbabilisticRoadmap, NeighboursAreThoseWithinTheRadiusOrTheNearestBothWays) {
  const Problem problem = walls();
  const PlaneSpace space{problem};
  Budget budget;
  for (const int neighbours : {0, 7}) {
    const ProbabilisticRoadmap roadmap{space, {.samples = 250, .radius = 2.0, .neighbours = neighbours}, 9, budget};
    const std::vector<Vec2>& p = roadmap.places();
    ASSERT_EQ(p.size(), 250U);
    const auto is_near = [&](std::size_t i, std::size_t k) {
      if (neighbours == 0) return distance(p[i], p[k]) <= 2.0;
      int nearer = 0;
      for (std::size_t j = 0; j < p.size(); ++j) nearer += j != i && distance(p[i], p[j]) < distance(p[i], p[k]) ? 1 : 0;
      return nearer < neighbours;
    };
    for (std::uint32_t i = 0; i < p.size(); ++i) {
      EXPECT_TRUE(space.is_free(p[i]));
      std::vector<bool> joined(p.size(), false);
      for (const std::uint32_t k : roadmap.neighbours_of(i)) joined[k] = true;
      for (std::uint32_t k = 0; k < p.size(); ++k) ASSERT_EQ(joined[k], k != i && (is_near(i, k) || is_near(k, i))) << i << " " << k;
    }
  }
  // Those of fewer samples are the first of more.
  const ProbabilisticRoadmap small{space, {.samples = 100}, 9, budget}, large{space, {.samples = 300}, 9, budget};
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(small.places()[i], large.places()[i]);
  EXPECT_GT(small.radius(), large.radius());
}

TEST(ProbabilisticRoadmap, EndsWithItsBudgetAlsoWhileItGrows) {
  const Problem problem = walls();
  const PlaneSpace space{problem};
  std::atomic<bool> flag{true};
  Budget canceled{{}, &flag};
  const ProbabilisticRoadmap none{space, {.samples = 100'000}, 1, canceled};
  EXPECT_FALSE(none.is_whole());
  EXPECT_LE(none.size(), 32U);
  Budget budget;
  const ProbabilisticRoadmap roadmap{space, {.samples = 800}, 1, budget};
  const auto shortest = [&](Budget& b, std::int64_t lines) { return roadmap.shortest(problem.start().position(), {{problem.goal().position()}}, b, lines); };
  const RoadmapAnswer whole = shortest(budget, no_end);
  ASSERT_EQ(whole.ended, RoadmapEnd::found);
  EXPECT_EQ(shortest(budget, whole.lines).ended, RoadmapEnd::found);
  const RoadmapAnswer less = shortest(budget, whole.lines - 1);
  EXPECT_EQ(less.ended, RoadmapEnd::lines);
  EXPECT_EQ(less.lines, whole.lines - 1);
  EXPECT_FALSE(less.way.empty());
  EXPECT_EQ(shortest(canceled, no_end).ended, RoadmapEnd::stopped);
}

}  // namespace
}  // namespace waywright
