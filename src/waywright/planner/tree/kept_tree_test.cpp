// What is kept of a tree on a changed map: its laws on random maps, and that keeping is worth it.
#include "waywright/planner/tree/kept_tree.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "waywright/map/whale_maps.hpp"
#include "waywright/planner/tree/tree_session.hpp"
#include "waywright/proof/proof.hpp"

namespace waywright {
namespace {

constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();
const Vec2 goal{18.5, 18.5};

Scenario hall(Random& random, int boxes) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {20, 20})};
  for (int i = 0; i < boxes; ++i) {
    const Vec2 at{random.uniform(2.5, 16.0), random.uniform(2.5, 16.0)};
    s.map.obstacles.push_back(rectangle(at, at + Vec2{random.uniform(0.4, 2.0), random.uniform(0.4, 2.0)}));
  }
  s.vehicle.footprint = {{}, 0.1};
  s.vehicle.drive = Differential{0.5};
  s.start = {1.5, 1.5, 0.0};
  s.mission = Pose{goal.x, goal.y, 0.0};
  return s;
}

/// A tree on a map, and the map with more on it, seen from somewhere along the way.
struct Changed {
  Problem before, after;
  PlaneSpace old_space, space;
  World appeared;
  PlaneTree tree;
  Vec2 root;

  Changed(Scenario scenario, const std::vector<Ring>& more, std::uint64_t seed, double share)
      : before{Problem::prepare(scenario).value()}, after{Problem::prepare(with(scenario, more)).value()}, old_space{before}, space{after}, appeared{only(more)} {
    appeared.build();
    Budget budget;
    tree.grow(old_space, {.samples = 2000}, scenario.start.position(), {{goal}}, seed, budget, no_limit);
    root = scenario.start.position();
    const std::vector<Vec2> way = tree.way();
    double left = share * tree.length();
    for (std::size_t i = 0; i + 1 < way.size() && left > 0.0; ++i) {
      const double here = distance(way[i], way[i + 1]);
      root = here > left ? way[i] + (left / here) * (way[i + 1] - way[i]) : way[i + 1];
      left -= here;
    }
  }
  Changed(const Changed&) = delete;

  static Scenario with(Scenario s, const std::vector<Ring>& more) {
    s.map.obstacles.insert(s.map.obstacles.end(), more.begin(), more.end());
    return s;
  }
  static World only(const std::vector<Ring>& more) {
    Map map;
    map.obstacles = more;
    return World{map};
  }
};

TEST(KeptTree, CostsAddUpAndEveryEdgeIsFreeOfWhatIsNew) {
  Random random{7};
  int looked_at = 0, reattached = 0, cut = 0;
  for (int i = 0; i < 30; ++i) {
    const Scenario s = hall(random, 3 + i % 8);
    std::vector<Ring> more;
    for (int k = 0; k <= i % 4; ++k) {
      const Vec2 at{random.uniform(3.0, 16.0), random.uniform(3.0, 16.0)};
      more.push_back(rectangle(at, at + Vec2{random.uniform(0.3, 2.5), random.uniform(0.3, 2.5)}));
    }
    Changed changed{s, more, static_cast<std::uint64_t>(i), 0.1 * (i % 8)};
    if (!changed.tree.is_found() || !changed.space.is_free(changed.root)) continue;
    KeptTree kept;
    kept.take(changed.tree);
    if (!kept.carry_over(changed.space, changed.appeared, changed.root, 1.0, {{goal}})) continue;
    ++looked_at;
    const auto& nodes = kept.nodes();
    const auto& costs = kept.costs();
    EXPECT_EQ(nodes.front().at, changed.root);
    EXPECT_EQ(costs.front(), 0.0);
    for (std::size_t n = 1; n < nodes.size(); ++n) {
      ASSERT_LT(nodes[n].parent, n);
      const Vec2 a = nodes[nodes[n].parent].at, b = nodes[n].at;
      ASSERT_EQ(costs[n], costs[nodes[n].parent] + distance(a, b));
      ASSERT_TRUE(changed.space.is_free(a, b) || changed.space.is_free(b, a)) << i << " " << n;
    }
    const KeptTreeStatistics& statistics = kept.statistics();
    EXPECT_EQ(statistics.kept, static_cast<std::int64_t>(nodes.size()));
    EXPECT_LE(statistics.kept, statistics.nodes + 1);
    // Who is gone is blocked, or joined to nobody.
    for (std::uint32_t n = 0; n < changed.tree.size(); ++n) {
      const Vec2 at = changed.tree.place(n);
      bool is_there = false, sees_someone = false;
      for (const auto& node : nodes) is_there = is_there || node.at == at;
      if (is_there) continue;
      for (const auto& node : nodes) sees_someone = sees_someone || (distance(node.at, at) <= 1.0 && changed.space.is_free(node.at, at));
      EXPECT_FALSE(sees_someone) << i << " " << n;
    }
    reattached += static_cast<int>(statistics.reattached);
    cut += static_cast<int>(statistics.cut);
  }
  EXPECT_GT(looked_at, 15);
  EXPECT_GT(cut, 100);
  EXPECT_GT(reattached, 100);
}

TEST(KeptTree, NothingNewAndTheOldRootIsTheOldTree) {
  Random random{9};
  Changed changed{hall(random, 5), {}, 1, 0.0};
  ASSERT_TRUE(changed.tree.is_found());
  KeptTree kept;
  kept.take(changed.tree);
  ASSERT_TRUE(kept.carry_over(changed.space, changed.appeared, changed.root, 1.0, {{goal}}));
  EXPECT_EQ(kept.statistics().cut, 0);
  EXPECT_EQ(kept.statistics().near, 0);
  EXPECT_EQ(kept.statistics().orphans, 0);
  EXPECT_EQ(kept.nodes().size(), changed.tree.size() + 1);
  // The way to the goal is no longer than it was, and no node is farther from the root.
  for (std::uint32_t n = 0; n < changed.tree.size(); n += 7) {
    double cost = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < kept.nodes().size(); ++k) {
      if (kept.nodes()[k].at == changed.tree.place(n)) cost = std::min(cost, kept.costs()[k]);
    }
    EXPECT_LE(cost, changed.tree.cost(n) + 1e-9);
  }
}

TEST(KeptTree, GrownOnItIsAsGoodAsANewOneForFewerLines) {
  Random random{31};
  double kept_length = 0.0, new_length = 0.0;
  std::int64_t kept_lines = 0, new_lines = 0;
  int runs = 0;
  for (int i = 0; i < 12; ++i) {
    const Scenario s = hall(random, 6);
    const Vec2 at{random.uniform(8.0, 13.0), random.uniform(8.0, 13.0)};
    Changed changed{s, {rectangle(at, at + Vec2{1.5, 1.5})}, static_cast<std::uint64_t>(i), 0.3};
    if (!changed.tree.is_found() || !changed.space.is_free(changed.root) || !changed.space.is_free(goal)) continue;
    KeptTree kept;
    kept.take(changed.tree);
    ASSERT_TRUE(kept.carry_over(changed.space, changed.appeared, changed.root, 1.0, {{goal}}));
    Budget budget;
    PlaneTree grown, anew;
    grown.grow_on(kept.nodes(), changed.space, {.samples = 300}, {{goal}}, 77, budget, no_limit);
    anew.grow(changed.space, {.samples = 2000}, changed.root, {{goal}}, 77, budget, no_limit);
    if (!grown.is_found() || !anew.is_found()) continue;
    ++runs;
    kept_length += grown.length();
    new_length += anew.length();
    kept_lines += kept.statistics().lines + grown.statistics().edges;
    new_lines += anew.statistics().edges;
    EXPECT_EQ(grown.way().front(), changed.root);
    EXPECT_EQ(grown.way().back(), goal);
    for (std::uint32_t n = 1; n < grown.size(); ++n) {
      ASSERT_NEAR(grown.cost(n), grown.cost(grown.parent(n)) + distance(grown.place(n), grown.place(grown.parent(n))), 1e-12);
      ASSERT_TRUE(changed.space.is_free(grown.place(grown.parent(n)), grown.place(n)) || changed.space.is_free(grown.place(n), grown.place(grown.parent(n))));
    }
  }
  EXPECT_GE(runs, 8);
  EXPECT_LT(kept_length, 1.02 * new_length);
  EXPECT_LT(static_cast<double>(kept_lines), 0.7 * static_cast<double>(new_lines));
}

TEST(TreeSession, GoesOnAsTheRobotDrivesAndBoxesAppear) {
  Scenario s;
  s.map = whale_map("WOA-2")->map;
  s.vehicle.footprint = {{}, 0.1};
  s.vehicle.drive = Differential{0.5};
  s.start = {1.5, 1.5, 0.0};
  s.mission = Pose{18.5, 18.5, 0.0};
  Budget budget;
  TreeSession session{{.samples = 3000}, 1};
  Problem problem = Problem::prepare(s).value();
  auto path = session.plan(problem, budget);
  ASSERT_TRUE(path);
  const std::vector<Ring> boxes{rectangle({11.5, 11.5}, {13.0, 13.0}), rectangle({15.0, 16.5}, {16.0, 17.5})};
  double left = length(*path);
  for (const Ring& box : boxes) {
    const std::vector<Sample> samples = sample(*path, 0.1, 1e-3);
    for (const Sample& at : samples) {
      if (at.s <= 6.0) s.start = at.pose();
    }
    Map appeared;
    appeared.obstacles = {box};
    s.map.obstacles.push_back(box);
    problem = Problem::prepare(s).value();
    path = session.replan(problem, appeared, 200, budget);
    ASSERT_TRUE(path);
    EXPECT_TRUE(prove(problem, *path).holds());
    EXPECT_LT(length(*path), left);
    left = length(*path);
    EXPECT_LT(session.upkeep().near, session.upkeep().nodes / 2);
    EXPECT_GT(session.upkeep().kept, 1500);
  }
}

}  // namespace
}  // namespace waywright
