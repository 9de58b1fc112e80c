#include "waywright/planner/field/sphere_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "waywright/core/random.hpp"
#include "waywright/planner/field/sphere_world_of.hpp"

namespace waywright {
namespace {

const SphereWorld two{{{0, 0}, 5}, {{{0, 0.9}, 0.7}, {{0, -0.9}, 0.7}}};
const SphereWorld three{{{0, 0}, 5}, {{{-1.5, 1.3}, 0.8}, {{0.2, -1.6}, 1.0}, {{1.9, 1.2}, 0.7}}};
const Vec2 behind{3.4, 2.6}, between{0.2, 0.7};

SphereWorld many(int n, Random& random) {
  SphereWorld world{{{0, 0}, 10}, {}};
  while (static_cast<int>(world.obstacles.size()) < n) {
    const Disc disc{random.uniform(0.5, 8.5) * unit(random.uniform(-pi, pi)), random.uniform(0.15, 0.5)};
    bool apart = norm(disc.centre) + disc.radius < 9.8 && distance(disc.centre, {9, 0}) > disc.radius + 0.1;
    for (const Disc& other : world.obstacles) apart = apart && distance(disc.centre, other.centre) > disc.radius + other.radius + 0.1;
    if (apart) world.obstacles.push_back(disc);
  }
  return world;
}

TEST(NavigationFunction, SlopeAndCurvatureAreThoseOfFiniteDifferences) {
  Random random{5};
  for (const double kappa : {3.0, 4.0, 6.0, 8.0}) {
    const NavigationFunction function{three, behind, kappa};
    int looked = 0;
    while (looked < 200) {
      const Vec2 q{random.uniform(-5, 5), random.uniform(-5, 5)};
      if (function.distance_to_rim(q) < 0.05 || distance(q, behind) < 0.05) continue;
      ++looked;
      constexpr double h = 1e-5;
      const Vec2 dx{h, 0}, dy{0, h};
      const Vec2 g = function.gradient(q);
      const Vec2 by_difference{(function.value(q + dx) - function.value(q - dx)) / (2 * h), (function.value(q + dy) - function.value(q - dy)) / (2 * h)};
      EXPECT_LE(distance(g, by_difference), 1e-4 * norm(g) + 1e-9) << kappa << " at " << q.x << ", " << q.y;
      const SymmetricMatrix m = function.curvature(q);
      const Vec2 sx = (0.5 / h) * (function.slope(q + dx) - function.slope(q - dx)), sy = (0.5 / h) * (function.slope(q + dy) - function.slope(q - dy));
      const double size = std::abs(m.xx) + std::abs(m.xy) + std::abs(m.yy);
      EXPECT_NEAR(m.xx, sx.x, 1e-4 * size);
      EXPECT_NEAR(m.xy, sx.y, 1e-4 * size);
      EXPECT_NEAR(m.xy, sy.x, 1e-4 * size);
      EXPECT_NEAR(m.yy, sy.y, 1e-4 * size);
    }
  }
}

TEST(NavigationFunction, IsNoughtAtTheGoalOneOnEveryRimAndBetweenElsewhere) {
  const NavigationFunction function{three, behind, 3.0};  // a greater κ makes it steeper at the rim than numbers resolve
  EXPECT_EQ(function.value(behind), 0.0);
  for (int i = 0; i < 360; ++i) {
    const Vec2 away = unit(i * pi / 180.0);
    EXPECT_NEAR(function.value(5.0 * (1.0 - 1e-12) * away), 1.0, 1e-6);
    for (const Disc& disc : three.obstacles) EXPECT_NEAR(function.value(disc.centre + disc.radius * (1.0 + 1e-12) * away), 1.0, 1e-6);
  }
  Random random{6};
  for (int i = 0; i < 5000; ++i) {
    const Vec2 q{random.uniform(-5, 5), random.uniform(-5, 5)};
    const double value = function.value(q);
    if (!function.is_free(q)) EXPECT_EQ(value, 1.0);
    else EXPECT_TRUE(value > 0.0 && value < 1.0) << q.x << ", " << q.y;
  }
}

// Products of 31 factors to the power 50 would long have left the range of numbers; their logarithm does not.
TEST(NavigationFunction, ThirtyObstaclesAndAKappaOfFiftyNeitherOverflowNorVanish) {
  Random random{7};
  const SphereWorld world = many(30, random);
  const NavigationFunction function{world, {9, 0}, 50.0};
  int looked = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec2 q{random.uniform(-10, 10), random.uniform(-10, 10)};
    if (function.distance_to_rim(q) < 1e-6) continue;
    ++looked;
    const Vec2 slope = function.slope(q);
    EXPECT_TRUE(is_finite(slope));
    EXPECT_GT(norm(slope), 0.0);
    const double value = function.value(q);
    EXPECT_TRUE(value > 0.0 && value <= 1.0);
  }
  EXPECT_GT(looked, 5000);
}

struct Expected {
  const SphereWorld& world;
  Vec2 goal;
  double kappa;
  std::size_t saddles;
  std::vector<Vec2> minima;
};

// The table of the reconstruction: Newton's method and the sign of the Hessian, found with another program.
TEST(CriticalPoints, AreThoseOfTheTable) {
  const Vec2 right{3, 0};
  const std::vector<Expected> table{
      {three, behind, 2, 4, {{-3.417, -2.020}}}, {three, behind, 3, 4, {{-3.432, -1.433}}}, {three, behind, 4, 3, {}}, {three, behind, 5, 4, {{-2.703, -0.711}}},
      {three, behind, 6, 3, {}}, {three, behind, 7, 3, {}}, {three, behind, 8, 3, {}}, {three, behind, 10, 3, {}},
      {three, between, 2, 5, {{-3.173, -1.146}, {3.244, -1.145}}}, {three, between, 3, 3, {}}, {three, between, 6, 3, {}}, {three, between, 10, 3, {}},
      {two, right, 3, 2, {}}, {two, right, 4, 2, {}}, {two, right, 5, 3, {{-1.475, 0}}}, {two, right, 6, 3, {{-0.940, 0}}}, {two, right, 8, 2, {}}, {two, right, 12, 2, {}},
  };
  for (const Expected& e : table) {
    std::vector<Vec2> minima;
    std::size_t others = 0;
    for (const CriticalPoint& c : critical_points({e.world, e.goal, e.kappa})) {
      if (c.is_minimum) minima.push_back(c.at);
      else ++others;
    }
    EXPECT_EQ(others, e.saddles) << e.kappa << ", " << e.world.obstacles.size() << " discs";
    ASSERT_EQ(minima.size(), e.minima.size()) << e.kappa << ", " << e.world.obstacles.size() << " discs";
    for (std::size_t i = 0; i < minima.size(); ++i) EXPECT_LT(distance(minima[i], e.minima[i]), 0.001);
  }
  const auto points = critical_points({three, behind, 8.0});
  ASSERT_EQ(points.size(), 3u);
  EXPECT_LT(distance(points[0].at, {-2.751, 0.602}), 0.001);
  EXPECT_LT(distance(points[1].at, {-1.047, -2.696}), 0.001);
  EXPECT_LT(distance(points[2].at, {1.240, 0.641}), 0.001);
}

// With many discs whole numbers to 20 are too small: there are other minima. Greater ones do, and their saddles lie so near to the discs that starts are needed behind each.
TEST(CriticalPoints, ThirtyAndAHundredDiscsAreShownToLeadToTheGoal) {
  for (const int n : {30, 60, 100}) {
    Random random{static_cast<std::uint64_t>(n)};
    SphereWorld world{{{0, 0}, 10}, {}};
    const double size = 20.0 / std::sqrt(n + 4.0);
    while (static_cast<int>(world.obstacles.size()) < n) {
      const Disc disc{random.uniform(0.0, 9.0) * unit(random.uniform(-pi, pi)), random.uniform(0.05, 0.15) * size};
      bool apart = norm(disc.centre) + disc.radius < 9.9 && distance(disc.centre, {9.5, 0}) > disc.radius + 0.2;
      for (const Disc& other : world.obstacles) apart = apart && distance(disc.centre, other.centre) > disc.radius + other.radius + 0.02;
      if (apart) world.obstacles.push_back(disc);
    }
    const Vec2 goal{9.5, 0};
    const auto kappas = kappas_that_lead_to_goal(world, goal);
    ASSERT_FALSE(kappas.empty()) << n;
    std::printf("%d discs:", n);
    for (const double kappa : kappas) std::printf(" kappa %g", kappa);
    std::printf("\n");
    // Another count: around each disc, farther out than its saddle, the slope turns by one less than around the rim.
    for (const double kappa : kappas) {
      const NavigationFunction function{world, goal, kappa};
      const auto points = critical_points(function);
      int counted = 0;
      for (const Disc& disc : world.obstacles) {
        const auto nearest = std::min_element(points.begin(), points.end(), [&](const CriticalPoint& a, const CriticalPoint& b) { return distance(a.at, disc.centre) - disc.radius < distance(b.at, disc.centre) - disc.radius; });
        const double gap = distance(nearest->at, disc.centre) - disc.radius;
        const auto at_rim = turns_around(function, disc.centre, disc.radius + 1e-3 * gap), beyond = turns_around(function, disc.centre, disc.radius + 1.2 * gap);
        EXPECT_EQ(at_rim.value_or(1), 1);
        if (!beyond) continue;  // another disc is in the way
        const auto inside = std::count_if(points.begin(), points.end(), [&](const CriticalPoint& c) { return distance(c.at, disc.centre) < disc.radius + 1.2 * gap; });
        EXPECT_EQ(*beyond, 1 - inside) << n << " discs, kappa " << kappa;
        ++counted;
      }
      EXPECT_GT(counted, n / 2);
      // Around all: as along the outer rim, towards which it rises.
      EXPECT_EQ(turns_around(function, world.outside.centre, world.outside.radius * (1.0 - 1e-9)), 1);
    }
  }
}

// The sum of all indices, the goal's among them, is 1 − n, be there other minima or not.
TEST(CriticalPoints, AddUpToTheEulerCharacteristic) {
  for (const double kappa : {2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0, 40.0, 200.0}) {
    for (const auto& [world, goal] : {std::pair{two, Vec2{3, 0}}, std::pair{three, behind}, std::pair{three, between}}) {
      int sum = 1;
      for (const CriticalPoint& c : critical_points({world, goal, kappa})) sum += c.is_minimum ? 1 : -1;
      EXPECT_EQ(sum, 1 - static_cast<int>(world.obstacles.size())) << kappa;
    }
  }
}

/// Does a start get to the goal down the slope, by steps of 0.01 m or a fifth of the way to the nearest rim?
bool converges(const NavigationFunction& function, Vec2 q) {
  for (int k = 0; k < 20'000; ++k) {
    if (distance(q, function.goal()) < 0.02) return true;
    const double rim = function.distance_to_rim(q);
    if (!(rim > 0.0)) return false;
    const Vec2 slope = function.slope(q);
    q = q - (std::min(0.01, 0.2 * rim) / norm(slope)) * slope;
  }
  return false;
}

/// Starts that do not, of `side` × `side` over the world.
void converge(int side) {
  struct World {
    const char* name;
    const SphereWorld& world;
    Vec2 goal;
    double kappa;
    bool leads;  // by the table: else there is another minimum
  };
  for (const World& w : {World{"two discs", two, {3, 0}, 8, true}, World{"two discs", two, {3, 0}, 5, false}, World{"three discs", three, behind, 8, true}, World{"three discs", three, behind, 5, false},
                         World{"three discs", three, between, 4, true}}) {
    const NavigationFunction function{w.world, w.goal, w.kappa};
    int asked = 0, stuck = 0;
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const Vec2 q{10.0 * (i + 0.5) / side - 5.0, 10.0 * (j + 0.5) / side - 5.0};
        if (!function.is_free(q)) continue;
        ++asked;
        stuck += converges(function, q) ? 0 : 1;
      }
    }
    std::printf("%s, goal (%g, %g), kappa %g: %d of %d starts get to the goal\n", w.name, w.goal.x, w.goal.y, w.kappa, asked - stuck, asked);
    if (w.leads) EXPECT_EQ(stuck, 0) << w.name << " " << w.kappa;
    else EXPECT_GT(stuck, 0) << w.name << " " << w.kappa;
  }
}

TEST(NavigationFunction, LeadsEveryStartToTheGoalWhereItHasOneMinimum) { converge(30); }
TEST(NavigationFunctionFull, LeadsEveryStartOfFortyThousandToTheGoal) { converge(200); }

TEST(EnclosingDisc, HoldsAllPointsAndRestsOnTwoOrThree) {
  Random random{11};
  for (int i = 0; i < 500; ++i) {
    std::vector<Vec2> points;
    for (std::int64_t n = random.integer(1, 20); n > 0; --n) points.push_back({random.uniform(-3, 3), random.uniform(-3, 3)});
    const Disc disc = enclosing_disc(points);
    int on_rim = 0;
    double least = 1e300;  // of the radius, by trying all pairs and triples as centres of their circle
    for (const Vec2 p : points) {
      EXPECT_LE(distance(p, disc.centre), disc.radius + 1e-9);
      on_rim += std::abs(distance(p, disc.centre) - disc.radius) < 1e-9 ? 1 : 0;
    }
    for (int k = 0; k < 3000; ++k) {  // no centre beside it does with less
      const Vec2 centre = disc.centre + Vec2{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
      double needed = 0.0;
      for (const Vec2 p : points) needed = std::max(needed, distance(p, centre));
      least = std::min(least, needed);
    }
    EXPECT_GE(least, disc.radius - 1e-9);
    EXPECT_GE(on_rim, points.size() > 1 ? 2 : 1);
  }
}

}  // namespace
}  // namespace waywright
