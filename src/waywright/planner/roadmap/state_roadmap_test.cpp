#include "waywright/planner/roadmap/state_roadmap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "waywright/planner/steering/shortcut.hpp"

namespace waywright {
namespace {

constexpr std::int64_t no_end = std::numeric_limits<std::int64_t>::max();

Scenario rooms() {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {9, 6})};
  s.map.obstacles = {rectangle({4.3, 0}, {4.7, 2.5}), rectangle({4.3, 3.5}, {4.7, 6})};
  s.vehicle.footprint.polygon = rectangle({-0.3, -0.25}, {0.7, 0.25});
  s.vehicle.drive = Differential{0.4};
  s.start = {1.0, 1.0, 0.0};
  s.mission = Pose{8.0, 1.5, -1.2};
  s.clearance = 0.05;
  return s;
}

struct Asked {
  Problem problem = Problem::prepare(rooms()).value();
  Budget budget;
  std::unique_ptr<const Steering> steering;
  MotionTest test;
  StateQuery query;

  explicit Asked(SteeringKind kind, std::int64_t motions = no_end)
      : steering{make_steering(kind, {0.6, 0.2, 0.0})},
        test{problem, {no_end, no_end, 0.001}, budget},
        query{*steering, test, problem.start(), problem.goal(), search_region(problem, 0.6, steering->is_curve()), motions} {}
  Asked(const Asked&) = delete;
  Asked& operator=(const Asked&) = delete;
  bool is_free(const Pose& a, const Pose& b) { return test.motion_free(steering->between(a, b)); }
};

class EveryRoadmap : public testing::TestWithParam<SteeringKind> {};

/// Every motion of the roadmap tested, then plain Dijkstra.
double by_hand(Asked& asked, const StateRoadmap& roadmap, std::int64_t& tested) {
  const std::size_t n = roadmap.size();
  std::vector<double> cost(n + 1, std::numeric_limits<double>::infinity());
  std::vector<bool> done(n + 1, false), ends(n, false);
  const auto is_free = [&](const Pose& a, const Pose& b) {
    ++tested;
    return asked.is_free(a, b);
  };
  double best = std::numeric_limits<double>::infinity();
  const double direct = asked.steering->distance(asked.query.start, asked.query.goal);
  if ((roadmap.neighbours() > 0 || direct <= roadmap.options().radius) && is_free(asked.query.start, asked.query.goal)) best = direct;
  for (const RoadmapNeighbour& k : roadmap.from(asked.query.start)) {
    if (is_free(asked.query.start, roadmap.state(k.index))) cost[k.index] = k.cost;
  }
  for (const RoadmapNeighbour& k : roadmap.into(asked.query.goal)) ends[k.index] = true;
  while (true) {
    std::size_t at = n;
    for (std::size_t i = 0; i < n; ++i) {
      if (!done[i] && cost[i] < cost[at]) at = i;
    }
    if (at == n) return best;
    done[at] = true;
    const Pose& here = roadmap.state(static_cast<std::uint32_t>(at));
    if (ends[at] && is_free(here, asked.query.goal)) best = std::min(best, cost[at] + asked.steering->distance(here, asked.query.goal));
    for (const RoadmapNeighbour& k : roadmap.from(here)) {
      if (!done[k.index] && is_free(here, roadmap.state(k.index))) cost[k.index] = std::min(cost[k.index], cost[at] + k.cost);
    }
  }
}

TEST_P(EveryRoadmap, MotionsTestedWhenWantedGiveTheLeastCostlyWayOfAllOfThem) {
  std::int64_t all = 0, wanted = 0;
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Asked asked{GetParam()};
    const RoadmapOptions options{.samples = 250, .radius = seed % 3 == 0 ? 2.5 : 0.0, .neighbours = seed % 3 == 1 ? 10 : 0};
    const StateRoadmap roadmap{asked.query, options, seed, asked.budget};
    ASSERT_EQ(roadmap.size(), 250U);
    const LazyAnswer<Pose> answer = roadmap.shortest(asked.query, asked.budget);
    const double expected = by_hand(asked, roadmap, all);
    wanted += answer.lines;
    ASSERT_EQ(answer.ended == RoadmapEnd::found, std::isfinite(expected)) << seed;
    if (!std::isfinite(expected)) continue;
    ++compared;
    EXPECT_NEAR(answer.length, expected, 1e-9);
    EXPECT_NEAR(cost_of(*asked.steering, answer.way), answer.length, 1e-9);
    EXPECT_EQ(answer.way.front(), asked.query.start);
    EXPECT_EQ(answer.way.back(), asked.query.goal);
    for (std::size_t i = 1; i < answer.way.size(); ++i) EXPECT_TRUE(asked.is_free(answer.way[i - 1], answer.way[i]));
    EXPECT_GE(answer.length, asked.steering->least(asked.query.start, asked.query.goal) - 1e-9);
  }
  EXPECT_GE(compared, 3);
  EXPECT_LT(wanted, all / 2);
}

TEST_P(EveryRoadmap, FewerSamplesAreTheFirstOfMoreAndMoreAreBetter) {
  double few = 0.0, many = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Asked asked{GetParam()};
    const StateRoadmap small{asked.query, {.samples = 300}, seed, asked.budget}, large{asked.query, {.samples = 2000}, seed, asked.budget};
    for (std::uint32_t i = 0; i < small.size(); ++i) ASSERT_EQ(small.state(i), large.state(i));
    EXPECT_LT(small.neighbours(), large.neighbours());
    const LazyAnswer<Pose> one = small.shortest(asked.query, asked.budget), other = large.shortest(asked.query, asked.budget);
    ASSERT_EQ(other.ended, RoadmapEnd::found);
    many += other.length;
    few += one.ended == RoadmapEnd::found ? one.length : 2.0 * other.length;
  }
  EXPECT_LT(many, few);
}

TEST_P(EveryRoadmap, EndsWithItsBudgetAlsoWhileItGrows) {
  Asked asked{GetParam()};
  std::atomic<bool> flag{true};
  Budget canceled{{}, &flag};
  const StateRoadmap none{asked.query, {.samples = 100'000}, 1, canceled};
  EXPECT_FALSE(none.is_whole());
  EXPECT_EQ(none.size(), 0U);
  const StateRoadmap roadmap{asked.query, {.samples = 500}, 1, asked.budget};
  const LazyAnswer<Pose> whole = roadmap.shortest(asked.query, asked.budget);
  ASSERT_EQ(whole.ended, RoadmapEnd::found);
  Asked less{GetParam(), whole.lines - 1};
  const LazyAnswer<Pose> cut = roadmap.shortest(less.query, less.budget);
  EXPECT_EQ(cut.ended, RoadmapEnd::lines);
  EXPECT_EQ(cut.lines, whole.lines - 1);
  EXPECT_EQ(less.test.motions(), whole.lines - 1);
  EXPECT_FALSE(cut.way.empty());
  EXPECT_EQ(roadmap.shortest(asked.query, canceled).ended, RoadmapEnd::stopped);
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryRoadmap,
                         testing::Values(SteeringKind::turns, SteeringKind::dubins, SteeringKind::reeds_shepp), [](const auto& entry) { return std::string{to_string(entry.param)}; });

}  // namespace
}  // namespace waywright
