// Trees of stars: what is cut, what draws leaves in, and the map of all to discs.
#include "waywright/planner/field/star_trees.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "waywright/core/random.hpp"
#include "waywright/geometry/convex_partition.hpp"
#include "waywright/geometry/obstacle_index.hpp"
#include "waywright/planner/field/free_region.hpp"
#include "waywright/planner/field/tree_world.hpp"

namespace waywright {
namespace {

const Ring hall = rectangle({0, 0}, {10, 10});
const Ring u_wall{{3, 3}, {5.4, 3}, {5.4, 7}, {3, 7}, {3, 6.6}, {5, 6.6}, {5, 3.4}, {3, 3.4}};
const Ring l_wall{{2, 2}, {6, 2}, {6, 2.5}, {2.5, 2.5}, {2.5, 7}, {2, 7}};
const Ring t_wall{{3, 7}, {3, 6.5}, {4.8, 6.5}, {4.8, 3}, {5.2, 3}, {5.2, 6.5}, {7, 6.5}, {7, 7}};
const Ring s_wall{{3, 3}, {7, 3}, {7, 5.3}, {3.5, 5.3}, {3.5, 7}, {7, 7}, {7, 7.5}, {3, 7.5}, {3, 4.8}, {6.5, 4.8}, {6.5, 3.5}, {3, 3.5}};

/// A bar with teeth.
Ring comb(int teeth, double wide, double gap, double deep) {
  Ring ring{{1, 2}, {1 + teeth * wide + (teeth - 1) * gap, 2}};
  for (int i = teeth; i-- > 0;) {
    const double left = 1 + i * (wide + gap);
    for (const Vec2 p : {Vec2{left + wide, 3 + deep}, Vec2{left, 3 + deep}}) ring.push_back(p);
    if (i > 0) {
      ring.push_back({left, 3});
      ring.push_back({left - gap, 3});
    }
  }
  return ring;
}

/// A corridor wound inwards, as a wall.
Ring spiral(int turns) {
  std::vector<Vec2> middle;
  Vec2 at{5, 5};
  double along = 0.6;
  for (int i = 0; i <= turns; ++i) {
    middle.push_back(at);
    const Vec2 ways[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    at = at + along * ways[i % 4];
    if (i % 2 == 1) along += 0.6;
  }
  constexpr double half = 0.1;
  Ring right, left;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const Vec2 in = i > 0 ? middle[i] - middle[i - 1] : middle[1] - middle[0], out = i + 1 < middle.size() ? middle[i + 1] - middle[i] : in;
    const Vec2 a = (1.0 / norm(in)) * in, b = (1.0 / norm(out)) * out, n = i == 0 || i + 1 == middle.size() ? left_of(a) : left_of(a) + left_of(b);
    left.push_back(middle[i] + half * n);
    right.push_back(middle[i] - half * n);
  }
  right.insert(right.end(), left.rbegin(), left.rend());
  return right;
}

/// A simple polygon of any shape: places in order of angle, at any distance, then bent along a wave.
Ring wild(Random& random, Vec2 centre, double size, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) ring.push_back(centre + random.uniform(0.25, 1.0) * size * unit(two_pi * (i + random.uniform(0.0, 0.8)) / corners));
  return ring;
}

TEST(ConvexPartition, PartsAreConvexAndAddUpToTheRing) {
  Random random{3};
  std::vector<Ring> rings{u_wall, l_wall, t_wall, s_wall, comb(5, 0.4, 0.6, 3), spiral(9)};
  for (int i = 0; i < 300; ++i) rings.push_back(wild(random, {5, 5}, 3, static_cast<int>(random.integer(3, 40))));
  for (const Ring& ring : rings) {
    const auto partition = convex_partition(ring);
    ASSERT_TRUE(partition);
    double area = 0.0;
    for (const auto& corners : partition->parts) {
      Ring part;
      for (const std::size_t c : corners) part.push_back(ring[c]);
      EXPECT_TRUE(is_convex(part));
      area += signed_area(part);
    }
    EXPECT_NEAR(area, signed_area(ring), 1e-9);
    EXPECT_EQ(partition->cuts.size() + 1, partition->parts.size());
    std::size_t inward = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[(i + ring.size() - 1) % ring.size()], b = ring[i], c = ring[(i + 1) % ring.size()];
      inward += cross(b - a, c - b) < 0.0 ? 1 : 0;
    }
    EXPECT_LE(partition->parts.size(), 2 * inward + 1);
  }
  EXPECT_EQ(convex_partition(u_wall)->parts.size(), 3u);
  EXPECT_EQ(convex_partition(l_wall)->parts.size(), 2u);
}

TEST(LeafPurge, IsOneToOneAndItsJacobianIsThatOfDifferences) {
  Random random{7};
  const Ring leaf{{0, 0}, {0.5, 0}, {0.6, 1.5}, {0.3, 2.0}, {-0.1, 1.2}};
  for (const auto& [slope_a, slope_b] : {std::pair{-0.6, 0.7}, std::pair{-1.5, 0.2}, std::pair{-0.2, 0.15}, std::pair{-0.3, 3.0}}) {
    auto purge = LeafPurge::of(leaf, slope_a, slope_b);
    ASSERT_TRUE(purge);
    purge->set_collar(std::min(0.6, 0.7 * (purge->reach() - 1.0)));
    int looked = 0, moved = 0, off = 0;
    while (looked < 20'000) {
      const Vec2 q{random.uniform(-2, 2.5), random.uniform(-0.5, 4)};
      if (contains(leaf, q)) continue;
      ++looked;
      const PlaneImage image = purge->at(q);
      EXPECT_GT(image.determinant(), 0.0);
      EXPECT_LT(distance(purge->back(image.at), q), 1e-9);
      if (image.at == q) continue;
      ++moved;
      constexpr double h = 1e-7;
      const Vec2 dx = (0.5 / h) * (purge->at(q + Vec2{h, 0}).at - purge->at(q - Vec2{h, 0}).at), dy = (0.5 / h) * (purge->at(q + Vec2{0, h}).at - purge->at(q - Vec2{0, h}).at);
      const double size = 1.0 + std::abs(image.xx) + std::abs(image.xy) + std::abs(image.yx) + std::abs(image.yy);
      off += std::abs(image.xx - dx.x) + std::abs(image.yx - dx.y) + std::abs(image.xy - dy.x) + std::abs(image.yy - dy.y) > 1e-4 * size ? 1 : 0;
    }
    EXPECT_GT(moved, 500);
    EXPECT_LE(off, 5);  // at bends of the rim
    // The rim goes to the cut, its ends stay.
    for (std::size_t i = 1; i < leaf.size(); ++i) {
      for (double share = 0.0; share <= 1.0; share += 0.01) {
        const Vec2 at = purge->at(leaf[i] + share * (leaf[(i + 1) % leaf.size()] - leaf[i])).at;
        EXPECT_LT(std::abs(at.y), 1e-9);
        EXPECT_TRUE(at.x > -1e-9 && at.x < 0.5 + 1e-9);
      }
    }
  }
}

TEST(LeafPurge, LinesThatMeetInTheLeafAreNone) {
  const Ring leaf{{0, 0}, {0.5, 0}, {0.5, 2.0}, {0, 2.0}};
  EXPECT_FALSE(LeafPurge::of(leaf, 0.2, -0.2));
  EXPECT_FALSE(LeafPurge::of(leaf, 0.0, 0.0));  // along its sides
  EXPECT_TRUE(LeafPurge::of(leaf, -0.1, 0.1));
}

struct Case {
  const char* name;
  Ring outside;
  std::vector<Ring> obstacles;
  Vec2 goal;
};
std::vector<Case> cases() {
  const Ring u_hall{{0, 0}, {10, 0}, {10, 10}, {7, 10}, {7, 3}, {3, 3}, {3, 10}, {0, 10}};
  const Ring h_hall{{0, 0}, {3, 0}, {3, 4}, {7, 4}, {7, 0}, {10, 0}, {10, 10}, {7, 10}, {7, 6}, {3, 6}, {3, 10}, {0, 10}};
  return {{"U", hall, {u_wall}, {8.5, 5}},
          {"U, goal in it", hall, {u_wall}, {3.5, 5}},
          {"T and L", hall, {t_wall, {{1, 1}, {3, 1}, {3, 1.4}, {1.4, 1.4}, {1.4, 3}, {1, 3}}}, {8.5, 5}},
          {"S", hall, {s_wall}, {5, 6.2}},
          {"comb", hall, {comb(5, 0.4, 0.6, 3)}, {8.5, 8}},
          {"spiral of 6", hall, {spiral(6)}, {9, 8.6}},
          {"U hall", u_hall, {}, {8.5, 9}},
          {"H hall", h_hall, {{{4, 4.8}, {4.4, 4.8}, {4.4, 5.2}, {4, 5.2}}}, {8.5, 9}}};
}

TEST(TreeMap, DoesNotFoldAndTakesRimsToCircles) {
  for (const Case& c : cases()) {
    const auto made = TreeMap::of(c.outside, c.obstacles);
    ASSERT_TRUE(made) << c.name << made.error();
    const TreeMap& map = *made;
    double least = 1e300, least_collar = 1e300, worst = 0.0, back = 0.0;
    for (const LeafPurge& leaf : map.leaves()) least_collar = std::min(least_collar, leaf.collar());
    int looked = 0, folds = 0;
    const auto look = [&](Vec2 q) {
      if (!map.is_free(q)) return;
      ++looked;
      const PlaneImage image = map.at(q);
      least = std::min(least, image.determinant());
      folds += image.determinant() > 0.0 ? 0 : 1;
      back = std::max(back, distance(map.back(image.at), q));
    };
    for (int j = 0; j < 140; ++j) {
      for (int i = 0; i < 140; ++i) look({10.0 * (i + 0.5) / 140, 10.0 * (j + 0.5) / 140});
    }
    const auto along = [&](const Ring& ring, double out, const Disc& disc) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()], normal = (-1.0 / distance(a, b)) * left_of(b - a);
        for (double share = 0.005; share < 1.0; share += 0.01) {
          const Vec2 on = a + share * (b - a);
          for (const double off : {1e-6, 1e-4, 1e-2}) look(on + out * off * normal);
          worst = std::max(worst, std::abs(distance(map.at(on).at, disc.centre) - disc.radius));
        }
      }
    };
    along(c.outside, -1.0, map.model().outside);
    for (std::size_t i = 0; i < c.obstacles.size(); ++i) along(c.obstacles[i], 1.0, map.model().obstacles[i]);
    EXPECT_EQ(folds, 0) << c.name;
    EXPECT_LT(worst, 1e-6) << c.name;
    EXPECT_LT(back, 1e-6) << c.name;
    double least_room = 1e300;
    for (const StarRounding& star : map.stars()) least_room = std::min(least_room, star.room());
    std::printf("%s: %zu leaves, narrowest collar %.3g, room %.3g, least det J %.3g at %d places, rims off by %.2g, back by %.2g\n", c.name, map.leaves().size(), least_collar, least_room, least, looked, worst, back);
  }
}

/// Worlds of polygons of any shape that overlap, touch and reach beyond the walls, for a disc of 0.1 m.
void expect_no_failure(int worlds) {
  Random random{5};
  for (const int n : {2, 5, 10, 20}) {
    std::size_t most = 0;
    int made = 0;
    double worst = 0.0;
    for (int k = 0; k < worlds; ++k) {
      std::vector<Ring> obstacles;
      for (int i = 0; i < n; ++i) {
        const Vec2 centre{random.uniform(1, 9), random.uniform(1, 9)};
        obstacles.push_back(wild(random, centre, 6.0 / std::sqrt(n) * random.uniform(0.3, 0.8), static_cast<int>(random.integer(3, 14))));
        obstacles.back() = repair_ring(obstacles.back()).ring;
      }
      const auto region = free_region(hall, obstacles, 0.1, {0.3, 0.3});
      if (!region) continue;  // that corner is covered
      const auto map = TreeMap::of(region->outer, region->holes);
      ASSERT_TRUE(map) << n << " polygons, world " << k << ": " << map.error();
      ++made;
      most = std::max(most, map->leaves().size());
      for (int t = 0; t < 300; ++t) {
        const Vec2 q{random.uniform(0, 10), random.uniform(0, 10)};
        bool keeps = true;
        for (const Ring& ring : obstacles) keeps = keeps && distance(nearest_in(ring, q), q) >= 0.1;
        if (!map->is_free(q)) continue;
        EXPECT_TRUE(keeps);
        const PlaneImage image = map->at(q);
        EXPECT_GT(image.determinant(), 0.0);
        EXPECT_LT(distance(map->back(image.at), q), 1e-6);
      }
      for (std::size_t r = 0; r < map->rims().size(); ++r) {
        const Disc& disc = r == 0 ? map->model().outside : map->model().obstacles[r - 1];
        const Ring& ring = map->rims()[r];
        for (std::size_t i = 0; i < ring.size(); ++i) worst = std::max(worst, std::abs(distance(map->at(0.5 * (ring[i] + ring[(i + 1) % ring.size()])).at, disc.centre) - disc.radius));
      }
    }
    EXPECT_LT(worst, 1e-6);
    EXPECT_GT(made, worlds * 3 / 4);
    std::printf("%d polygons: %d worlds, up to %zu leaves, rims off by %.2g\n", n, made, most, worst);
  }
}

TEST(TreeMap, TakesAnyPolygons) { expect_no_failure(12); }
TEST(TreeMapFull, TakesAnyPolygonsOfAThousandWorlds) { expect_no_failure(250); }

// Walls that are wound up, of more and more pieces: each leaf is drawn in onto the one before.
TEST(TreeMap, TakesDeepTrees) {
  for (const int turns : {8, 12, 16, 20}) {
    Ring wall = spiral(turns);
    for (Vec2& p : wall) p = Vec2{5, 5} + 6.0 / turns * (p - Vec2{5, 5});
    const auto map = TreeMap::of(hall, {wall});
    ASSERT_TRUE(map) << turns;
    Random random{6};
    double worst = 0.0;
    for (int k = 0; k < 2000; ++k) {
      const Vec2 q{random.uniform(0, 10), random.uniform(0, 10)};
      if (!map->is_free(q)) continue;
      const PlaneImage image = map->at(q);
      EXPECT_GT(image.determinant(), 0.0);
      worst = std::max(worst, distance(map->back(image.at), q));
    }
    std::printf("%d turns: %zu leaves, back by %.2g\n", turns, map->leaves().size(), worst);
    EXPECT_LT(worst, 1e-6);
  }
}

// Along parallel lines, off a triangle of height 1: h → (h − H)(1 + c)/c with H = 2s and 2 − 2s.
TEST(LeafPurge, OfATriangleIsItsClosedForm) {
  auto purge = LeafPurge::of({{0, 0}, {1, 0}, {0.5, 1}}, 0.0, 0.0);
  ASSERT_TRUE(purge);
  EXPECT_EQ(purge->reach(), std::numeric_limits<double>::infinity());
  purge->set_collar(0.5);
  const auto at = [&](double x, double h) { return purge->at({x, h}).at; };
  EXPECT_LT(distance(at(0.25, 0.6), {0.25, 0.3}), 1e-12);
  EXPECT_LT(distance(at(0.75, 0.5), {0.75, 0.0}), 1e-12);
  EXPECT_EQ(at(0.25, 0.76), (Vec2{0.25, 0.76}));
  EXPECT_NEAR(purge->at({0.25, 0.6}).determinant(), 3.0, 1e-12);
  // Its nearest place on a level line is over the tip.
  EXPECT_NEAR(purge->nearest({-3, 1.5}, {3, 1.5}), 1.5, 1e-4);
  EXPECT_EQ(purge->nearest({-3, -0.1}, {3, -0.1}), std::numeric_limits<double>::infinity());
}

// Of a square on the way through the middle of a side: from between 1 and R to between the disc's radius and R.
TEST(StarRounding, OfASquareIsItsClosedForm) {
  const Ring square = rectangle({-1, -1}, {1, 1});
  const StarRounding rounding{square, {0, 0}, false, {rectangle({-5, -5}, {5, 5})}};
  const double end = std::sqrt(1.0 + rounding.room() * rounding.room()), radius = rounding.disc().radius;
  EXPECT_NEAR(rounding.room(), std::sqrt(2.0), 1e-9);  // as wide as its farthest corner: 1.4 m
  EXPECT_NEAR(radius, 0.5 * (1.0 + end), 1e-12);
  EXPECT_NEAR(rounding.at({1.0, 0.0}).at.x, radius, 1e-12);
  EXPECT_NEAR(rounding.at({1.3, 0.0}).at.x, radius + 0.3 * (end - radius) / (end - 1.0), 1e-12);
  EXPECT_EQ(rounding.at({end + 1e-9, 0.0}).at, (Vec2{end + 1e-9, 0.0}));
  EXPECT_NEAR(norm(rounding.at({1.0, 1.0}).at), radius, 1e-12);
}

// Turned and moved, the world's map is the map turned and moved.
TEST(TreeMap, DoesNotHangOnWhereTheWorldLies) {
  const Ring outside{{0, 0.2}, {9.7, -0.3}, {10.4, 9.6}, {7.1, 10.2}, {6.8, 8.1}, {4.9, 10.3}, {-0.4, 9.5}};
  const std::vector<Ring> obstacles{{{3, 3.1}, {5.5, 2.9}, {5.3, 6.8}, {3.1, 7.2}, {2.9, 6.5}, {4.7, 6.3}, {4.9, 3.7}, {3.2, 3.6}}, {{7, 2}, {8.2, 2.3}, {7.6, 3.4}}};
  const Frame frame{Pose{-3.0, 8.0, 0.7}};
  const auto map = TreeMap::of(outside, obstacles).value(), other = TreeMap::of(transformed(outside, frame), {transformed(obstacles[0], frame), transformed(obstacles[1], frame)}).value();
  ASSERT_GE(map.leaves().size(), 1u);
  ASSERT_EQ(map.leaves().size(), other.leaves().size());
  Random random{12};
  int looked = 0;
  while (looked < 2000) {
    const Vec2 q{random.uniform(0, 10), random.uniform(0, 10)};
    if (!map.is_free(q)) continue;
    ++looked;
    EXPECT_LT(distance(frame.to_world(map.at(q).at), other.at(frame.to_world(q)).at), 2e-4);  // middles of circles are searched for
  }
}

TEST(TreeNavigation, SlopeIsThatOfItsValueAndEachStepLeadsDown) {
  for (const Case& c : cases()) {
    const auto map = TreeMap::of(c.outside, c.obstacles).value();
    const TreeNavigation navigation{map, c.goal, 4.0};
    Random random{9};
    int looked = 0, off = 0;
    while (looked < 300) {
      const Vec2 q{random.uniform(0, 10), random.uniform(0, 10)};
      constexpr double h = 1e-6;
      const double value = navigation.value(q);
      if (map.distance_to_rim(q) < 1e-3 || value > 0.999 || value < 0.01) continue;
      ++looked;
      const Vec2 slope = navigation.slope(q), by_difference{navigation.value(q + Vec2{h, 0}) - navigation.value(q - Vec2{h, 0}), navigation.value(q + Vec2{0, h}) - navigation.value(q - Vec2{0, h})};
      off += std::abs(cross(slope, by_difference)) > 1e-3 * norm(slope) * norm(by_difference) || dot(slope, by_difference) < 0.0 ? 1 : 0;
      const Vec2 next = navigation.next(q, 1e-4);
      EXPECT_LE(distance(q, next), 1e-4);
      EXPECT_LT(navigation.value(next), value) << c.name;
    }
    EXPECT_LE(off, 3) << c.name;  // at bends
  }
}

/// All of `side` × `side` starts, by steps of the model (a hundredth of its radius, a fifth of the distance to its nearest rim) of at most 0.5 m.
void expect_all_to_the_goal(int side, const std::vector<std::string>& names) {
  for (const Case& c : cases()) {
    if (std::find(names.begin(), names.end(), c.name) == names.end()) continue;
    const auto map = TreeMap::of(c.outside, c.obstacles).value();
    const auto kappas = kappas_that_lead_to_goal(map.model(), map.at(c.goal).at);
    ASSERT_FALSE(kappas.empty()) << c.name;
    const TreeNavigation navigation{map, c.goal, kappas.front()};
    int asked = 0, led = 0;
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        Vec2 q{10.0 * (i + 0.5) / side, 10.0 * (j + 0.5) / side};
        if (!map.is_free(q)) continue;
        ++asked;
        for (int k = 0; k < 20'000 && distance(q, c.goal) > 0.02; ++k) q = navigation.next(q, 0.5);
        EXPECT_TRUE(map.is_free(q));
        led += distance(q, c.goal) <= 0.02 ? 1 : 0;
      }
    }
    std::printf("%s, kappa %g: %d of %d starts get to the goal\n", c.name, kappas.front(), led, asked);
    EXPECT_EQ(led, asked) << c.name;
  }
}

TEST(TreeNavigation, LeadsEveryStartToTheGoal) { expect_all_to_the_goal(9, {"U", "U, goal in it", "S", "comb", "spiral of 6", "U hall", "H hall"}); }
TEST(TreeNavigationFull, LeadsEveryStartOfTenThousandToTheGoal) { expect_all_to_the_goal(100, {"U", "U, goal in it", "S", "comb", "spiral of 6", "U hall", "H hall"}); }

// Parts of a comb, grown, have edges in one line but for rounding.
TEST(FreeRegion, IsFoundAroundCombsOfManyTeeth) {
  for (const int teeth : {5, 13, 20, 40}) {
    Ring comb{{-20, -1}, {20, -1}};
    const double pitch = 40.0 / teeth;
    for (int k = 0; k < teeth; ++k) {
      const double right = 20.0 - k * pitch;
      for (const Vec2 p : {Vec2{right - 0.2 * pitch, 0.0}, Vec2{right - 0.25 * pitch, 3.0}, Vec2{right - 0.55 * pitch, 3.0}, Vec2{right - 0.6 * pitch, 0.0}}) comb.push_back({std::round(p.x * 1e6) / 1e6, p.y});
    }
    const auto region = free_region(rectangle({-40, -20}, {40, 20}), {comb}, 0.35, {0, -10});
    ASSERT_TRUE(region) << teeth << ": " << region.error();
    ASSERT_EQ(region->holes.size(), 1u) << teeth;
    for (const Vec2 p : comb) EXPECT_TRUE(contains(region->holes.front(), p)) << teeth;
  }
}

}  // namespace
}  // namespace waywright
