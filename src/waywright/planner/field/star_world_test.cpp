#include "waywright/planner/field/star_world.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/geometry/obstacle_index.hpp"
#include "waywright/map/field_worlds.hpp"

namespace waywright {
namespace {

const Vec2 centres[] = {{-1.5, 1.3}, {0.2, -1.6}, {1.9, 1.2}};
const Vec2 behind{3.4, 2.6}, between{0.2, 0.7};

StarWorld stars(double grown = 0.0) {
  const FieldWorld world = field_world("NF-ST").value();
  StarWorld all{{world.map.boundaries.front(), {0, 0}, grown, true}, {}};
  for (std::size_t i = 0; i < 3; ++i) all.obstacles.emplace_back(world.map.obstacles[i], centres[i], grown, false);
  return all;
}

TEST(Star, KernelOfAConvexPolygonIsAllOfIt) {
  const Ring box = rectangle({0, 0}, {3, 2});
  EXPECT_NEAR(signed_area(kernel_of(box)), 6.0, 1e-12);
  const InnerCircle circle = largest_circle_in(box);
  EXPECT_NEAR(circle.radius, 1.0, 1e-9);
  EXPECT_NEAR(circle.centre.y, 1.0, 1e-9);
}

TEST(Star, KernelOfAnLIsItsCornerAndOfAUNothing) {
  const Ring l{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  const Ring kernel = kernel_of(l);
  EXPECT_NEAR(signed_area(kernel), 1.0, 1e-12);
  const Box box = bounding_box(kernel);
  EXPECT_NEAR(box.high.x, 1.0, 1e-12);
  EXPECT_NEAR(box.high.y, 1.0, 1e-12);
  EXPECT_TRUE(kernel_of({{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}).empty());
}

// By sight: the segment from a place of the kernel to any corner stays in the polygon.
TEST(Star, AllOfAPolygonIsSeenFromItsKernel) {
  Random random{4};
  for (int i = 0; i < 200; ++i) {
    Ring ring;  // a star about the origin, so that its kernel is not empty
    const std::int64_t n = random.integer(5, 12);
    for (std::int64_t k = 0; k < n; ++k) ring.push_back(random.uniform(0.5, 2.0) * unit(two_pi * static_cast<double>(k) / static_cast<double>(n)));
    const Ring kernel = kernel_of(ring);
    if (kernel.empty()) continue;
    const Vec2 c = largest_circle_in(kernel).centre;
    for (const Vec2 corner : ring) {
      for (double t = 0.05; t < 1.0; t += 0.05) EXPECT_TRUE(contains(ring, c + t * (corner - c)));
    }
  }
}

TEST(Star, RimOfAGrownPolygonIsWhereTheDistanceIs) {
  Random random{5};
  const Ring l{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  for (const double grown : {0.0, 0.3}) {
    const Star star{l, {0.5, 0.5}, grown, false};
    for (int i = 0; i < 1000; ++i) {
      const Vec2 q = Vec2{0.5, 0.5} + random.uniform(0.1, 5.0) * unit(random.uniform(-pi, pi));
      const Dual rim = star.rim(q);
      const Vec2 u = (1.0 / distance(q, star.centre())) * (q - star.centre());
      const auto apart = [&](double t) { return distance(star.centre() + t * u, nearest_in(l, star.centre() + t * u)); };
      EXPECT_NEAR(apart(rim.value), grown, 1e-9);
      EXPECT_GT(apart(rim.value + 0.01), grown);
      EXPECT_GE(rim.value, star.least_rim() - 1e-12);
      EXPECT_LE(rim.value, star.greatest_rim() + 1e-12);
      constexpr double h = 1e-7;
      const double dx = (star.rim(q + Vec2{h, 0}).value - star.rim(q - Vec2{h, 0}).value) / (2 * h), dy = (star.rim(q + Vec2{0, h}).value - star.rim(q - Vec2{0, h}).value) / (2 * h);
      if (std::abs(rim.dx - dx) + std::abs(rim.dy - dy) > 1e-4 * (1.0 + std::abs(dx) + std::abs(dy))) {
        // Only at a corner of the rim, where the derivative jumps.
        EXPECT_GT(std::abs(star.rim(q + Vec2{h, 0}).dx - star.rim(q - Vec2{h, 0}).dx) + std::abs(star.rim(q + Vec2{0, h}).dy - star.rim(q - Vec2{0, h}).dy), 1e-3);
      }
    }
  }
}

TEST(Star, RimOfABoundaryIsTheFirstPlaceTooNear) {
  Random random{6};
  const Ring hall{{0, 0}, {6, 0}, {6, 2}, {3, 2}, {3, 5}, {0, 5}};
  const Star star{hall, {1.5, 1.0}, 0.3, true};
  for (int i = 0; i < 500; ++i) {
    const Vec2 u = unit(random.uniform(-pi, pi)), q = star.centre() + u;
    const double rim = star.rim(q).value;
    for (double t = 0.0; t < rim - 1e-6; t += 0.01) {
      double nearest = 1e9;
      for (std::size_t k = 0; k < hall.size(); ++k) nearest = std::min(nearest, point_segment_distance(star.centre() + t * u, hall[k], hall[(k + 1) % hall.size()]));
      ASSERT_GE(nearest, 0.3 - 1e-9);
    }
  }
}

TEST(StarMap, TakesRimsToCirclesAndTheGoalToItself) {
  const StarWorld world = stars();
  for (const Vec2 goal : {behind, between}) {
    const StarMap map{world, goal, 1e6};
    EXPECT_LT(distance(map.at(goal).at, goal), 1e-12);
    for (int i = 0; i < 360; ++i) {
      const Vec2 u = unit(0.5 + i * pi / 180.0);
      for (std::size_t k = 0; k < 3; ++k) {
        const Star& star = world.obstacles[k];
        const Vec2 on = star.centre() + star.rim(star.centre() + u).value * (1.0 + 1e-13) * u;
        EXPECT_NEAR(distance(map.at(on).at, star.centre()), map.model().obstacles[k].radius, 1e-6);
      }
      const Vec2 on = world.outside.rim(u).value * (1.0 - 1e-13) * u;
      EXPECT_NEAR(norm(map.at(on).at), map.model().outside.radius, 1e-6);
    }
  }
}

TEST(StarMap, JacobianIsThatOfFiniteDifferencesAndDoesNotFold) {
  const StarWorld world = stars();
  const StarMap map{world, behind, 1e6};
  Random random{8};
  int looked = 0, off = 0;
  while (looked < 500) {
    const Vec2 q{random.uniform(-5, 5), random.uniform(-5, 5)};
    constexpr double h = 1e-7;
    if (!map.is_free(q) || !map.is_free(q + Vec2{2 * h, 0})) continue;
    ++looked;
    const StarMap::Image image = map.at(q);
    const Vec2 dx = (0.5 / h) * (map.at(q + Vec2{h, 0}).at - map.at(q - Vec2{h, 0}).at), dy = (0.5 / h) * (map.at(q + Vec2{0, h}).at - map.at(q - Vec2{0, h}).at);
    off += std::abs(image.xx - dx.x) + std::abs(image.yx - dx.y) + std::abs(image.xy - dy.x) + std::abs(image.yy - dy.y) > 1e-4 ? 1 : 0;
  }
  EXPECT_LE(off, 3);  // polygons have corners
  constexpr int side = 140;
  double least = 1e9;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const Vec2 q{10.0 * (i + 0.5) / side - 5.0, 10.0 * (j + 0.5) / side - 5.0};
      if (map.is_free(q)) least = std::min(least, map.at(q).determinant());
    }
  }
  EXPECT_GT(least, 0.2);
}

TEST(StarMap, FoldsWithTooSmallALambda) {
  const StarWorld world = stars();
  const ChosenLambda chosen = choose_lambda(world, behind);
  EXPECT_TRUE(chosen.is_shown);
  EXPECT_GE(chosen.lambda, 1e4);
  EXPECT_LE(chosen.lambda, 1e6);
}

TEST(StarNavigation, SlopeIsThatOfItsValue) {
  const StarNavigation navigation{stars(), behind, 1e6, 8.0};
  Random random{9};
  int looked = 0, off = 0;
  while (looked < 300) {
    const Vec2 q{random.uniform(-5, 5), random.uniform(-5, 5)};
    constexpr double h = 1e-6;
    const double value = navigation.value(q);
    if (value >= 0.999 || value < 0.05 || !navigation.map().is_free(q + Vec2{h, h})) continue;
    ++looked;
    const Vec2 slope = navigation.slope(q), by_difference{navigation.value(q + Vec2{h, 0}) - navigation.value(q - Vec2{h, 0}), navigation.value(q + Vec2{0, h}) - navigation.value(q - Vec2{0, h})};
    off += std::abs(cross(slope, by_difference)) > 1e-3 * norm(slope) * norm(by_difference) || dot(slope, by_difference) < 0.0 ? 1 : 0;
  }
  EXPECT_LE(off, 3);
}

}  // namespace
}  // namespace waywright
