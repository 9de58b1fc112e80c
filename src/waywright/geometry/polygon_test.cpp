#include "waywright/geometry/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "waywright/core/random.hpp"
#include "waywright/geometry/obstacle_index.hpp"

namespace waywright {
namespace {

const Ring square = rectangle({0, 0}, {2, 2});
const Ring u_shape{{0, 0}, {5, 0}, {5, 4}, {4, 4}, {4, 1}, {1, 1}, {1, 4}, {0, 4}};

/// Corners at growing angles about the origin: simple, any degree of concavity.
Ring random_star(Random& random) {
  Ring ring;
  const auto n = static_cast<std::size_t>(random.integer(3, 12));
  for (std::size_t i = 0; i < n; ++i) {
    const double angle =
        two_pi * (static_cast<double>(i) + random.uniform(0.1, 0.9)) / static_cast<double>(n);
    ring.push_back(random.uniform(0.3, 5.0) * unit(angle));
  }
  return ring;
}

Frame random_frame(Random& random) {
  return Frame{Pose{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-4, 4)}};
}

/// Winding number by summed angles: shares nothing with the even-odd rule.
bool winds_around(const Ring& ring, Vec2 p) {
  double turned = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    turned += shorter_turn(angle_of(ring[i] - p), angle_of(ring[(i + 1) % ring.size()] - p));
  }
  return std::abs(turned) > pi;
}

TEST(Polygon, AreaOfKnownRings) {
  EXPECT_EQ(signed_area(square), 4.0);
  EXPECT_EQ(signed_area(u_shape), 11.0);
  EXPECT_EQ(signed_area(Ring(u_shape.rbegin(), u_shape.rend())), -11.0);
  EXPECT_EQ(signed_area({{0, 0}, {1, 0}}), 0.0);
}

TEST(Polygon, AreaKeptByRigidMotionFarFromTheOrigin) {
  const Ring far = transformed(u_shape, Frame{Pose{1e6, -1e6, 0.7}});
  EXPECT_NEAR(signed_area(far), 11.0, 1e-8);
}

TEST(Polygon, ContainsCornersEdgesAndInside) {
  for (const Vec2 p : u_shape) EXPECT_TRUE(contains(u_shape, p));
  EXPECT_TRUE(contains(u_shape, {2.5, 0.0}));
  EXPECT_TRUE(contains(u_shape, {2.5, 1.0}));
  EXPECT_TRUE(contains(u_shape, {0.5, 3.0}));
  EXPECT_FALSE(contains(u_shape, {2.5, 1.01}));
  EXPECT_FALSE(contains(u_shape, {2.5, 4.0}));
  EXPECT_FALSE(contains(u_shape, {-1e-9, 2.0}));
}

TEST(Polygon, ContainsAgreesWithTheWindingNumber) {
  Random random{3};
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ring ring = random_star(random);
    const Vec2 p{random.uniform(-4, 4), random.uniform(-4, 4)};
    inside += contains(ring, p) ? 1 : 0;
    ASSERT_EQ(contains(ring, p), winds_around(ring, p)) << p.x << ", " << p.y;
  }
  EXPECT_GT(inside, 1000);
}

TEST(Polygon, HullHoldsEveryPointAndIsConvex) {
  Random random{4};
  for (int i = 0; i < 300; ++i) {
    std::vector<Vec2> points;
    for (int k = 0; k < 60; ++k) points.push_back({random.uniform(-3, 3), random.uniform(-3, 3)});
    const Ring hull = convex_hull(points);
    ASSERT_TRUE(is_convex(hull));
    for (const Vec2 p : points) {
      for (std::size_t e = 0; e < hull.size(); ++e) {
        ASSERT_GE(cross(hull[(e + 1) % hull.size()] - hull[e], p - hull[e]), -1e-12);
      }
    }
    for (const Vec2 p : hull) ASSERT_NE(std::find(points.begin(), points.end(), p), points.end());
  }
}

TEST(Polygon, HullDropsStraightCornersAndDuplicates) {
  EXPECT_EQ(convex_hull({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}, {0, 0}, {1, 1}}).size(), 4u);
  EXPECT_EQ(convex_hull({{1, 1}, {1, 1}}).size(), 1u);
  EXPECT_EQ(convex_hull({{0, 0}, {1, 1}, {2, 2}}).size(), 2u);
}

TEST(Polygon, Convexity) {
  EXPECT_TRUE(is_convex(square));
  EXPECT_TRUE(is_convex({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}));
  EXPECT_FALSE(is_convex(u_shape));
  Ring pentagram;
  for (int i = 0; i < 5; ++i) pentagram.push_back(unit(two_pi * (2 * i) / 5));
  EXPECT_FALSE(is_convex(pentagram));
}

TEST(Polygon, LeastWidthOfKnownShapes) {
  EXPECT_DOUBLE_EQ(least_width(rectangle({-2.3, -0.45}, {0.4, 0.45})), 0.9);
  EXPECT_NEAR(least_width({{0, 0}, {1, 0}, {0.5, std::sqrt(3.0) / 2}}), std::sqrt(3.0) / 2, 1e-15);
  EXPECT_NEAR(least_width({{0, 0}, {3, 0}, {0, 4}}), 2.4, 1e-15);
  EXPECT_EQ(least_width({{0, 0}, {3, 0}}), 0.0);
  EXPECT_EQ(least_width({{0, 0}, {1, 1}, {2, 2}}), 0.0);
}

TEST(Polygon, LeastWidthIsTheLeastExtentOverDirections) {
  Random random{5};
  for (int i = 0; i < 100; ++i) {
    const Ring ring = random_star(random);
    double least = std::numeric_limits<double>::infinity();
    constexpr int directions = 4000;
    for (int k = 0; k < directions; ++k) {
      const Vec2 u = unit(pi * k / directions);
      double low = dot(u, ring[0]);
      double high = low;
      for (const Vec2 p : ring) {
        low = std::min(low, dot(u, p));
        high = std::max(high, dot(u, p));
      }
      least = std::min(least, high - low);
    }
    const double width = least_width(ring);
    ASSERT_LE(width, least + 1e-12);
    ASSERT_NEAR(width, least, 10.0 * pi / directions);
    ASSERT_NEAR(least_width(transformed(ring, random_frame(random))), width, 1e-12);
  }
}

TEST(Polygon, NearestPointOfTheArea) {
  EXPECT_EQ(nearest_in(square, {1, 1}), (Vec2{1, 1}));
  EXPECT_EQ(nearest_in(square, {3, 1}), (Vec2{2, 1}));
  EXPECT_EQ(nearest_in(square, {3, 3}), (Vec2{2, 2}));
  EXPECT_EQ(nearest_in(u_shape, {1.5, 3}), (Vec2{1, 3}));
  Random random{6};
  for (int i = 0; i < 500; ++i) {
    const Ring ring = random_star(random);
    const Vec2 p{random.uniform(-9, 9), random.uniform(-9, 9)};
    const double found = distance(nearest_in(ring, p), p);
    double least = winds_around(ring, p) ? 0.0 : std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < ring.size() && least > 0.0; ++e) {
      for (int k = 0; k <= 400; ++k) {
        const Vec2 on = ring[e] + (k / 400.0) * (ring[(e + 1) % ring.size()] - ring[e]);
        least = std::min(least, distance(on, p));
      }
    }
    ASSERT_LE(found, least + 1e-12);
    ASSERT_NEAR(found, least, 0.03);
  }
}

TEST(ClipHalfPlane, WholeNothingAndHalf) {
  EXPECT_EQ(clip_half_plane(square, {1, 0}, -1.0), std::vector<Ring>{square});
  EXPECT_EQ(clip_half_plane(square, {1, 0}, 0.0), std::vector<Ring>{square});
  EXPECT_TRUE(clip_half_plane(square, {1, 0}, 2.0).empty());
  EXPECT_TRUE(clip_half_plane(square, {1, 0}, 3.0).empty());
  const auto half = clip_half_plane(square, {3, 0}, 3.0);  // the normal need not be a unit vector
  ASSERT_EQ(half.size(), 1u);
  EXPECT_NEAR(signed_area(half[0]), 2.0, 1e-12);
  for (const Vec2 p : half[0]) EXPECT_GE(p.x, 1.0 - 1e-12);
}

TEST(ClipHalfPlane, ConcaveRingFallsApart) {
  const auto pieces = clip_half_plane(u_shape, {0, 1}, 2.0);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(signed_area(pieces[0]), 2.0, 1e-12);
  EXPECT_NEAR(signed_area(pieces[1]), 2.0, 1e-12);
  // In order along the line, from the right of the normal.
  EXPECT_GT(bounding_box(pieces[0]).low.x, bounding_box(pieces[1]).low.x);
}

TEST(ClipHalfPlane, AlongAnInnerEdge) {
  const auto legs = clip_half_plane(u_shape, {0, 1}, 1.0);
  ASSERT_EQ(legs.size(), 2u);
  EXPECT_NEAR(signed_area(legs[0]) + signed_area(legs[1]), 6.0, 1e-8);
  const auto bar = clip_half_plane(u_shape, {0, -1}, -1.0);
  ASSERT_EQ(bar.size(), 1u);
  EXPECT_NEAR(signed_area(bar[0]), 5.0, 1e-8);
}

// The two sides of a line are the whole: area by area, and point by point. Lines through corners, along edges
// and anywhere.
TEST(ClipHalfPlane, BothSidesMakeTheWhole) {
  Random random{8};
  for (int i = 0; i < 4000; ++i) {
    Ring ring = random_star(random);
    if (random.uniform() < 0.5) {
      for (Vec2& p : ring) p = {std::round(p.x), std::round(p.y)};
    }
    const RingRepair repair = repair_ring(transformed(ring, random_frame(random)));
    if (repair.refused) continue;
    ring = repair.ring;
    const auto n = ring.size();
    const auto k = static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(n) - 1));
    const bool along_edge = random.uniform() < 0.5;
    const Vec2 normal = along_edge ? left_of(ring[(k + 1) % n] - ring[k]) : unit(random.uniform(-4, 4));
    const double offset = dot(normal, ring[k]) + (random.uniform() < 0.3 ? random.uniform(-3, 3) : 0.0);
    const auto above = clip_half_plane(ring, normal, offset);
    const auto below = clip_half_plane(ring, -normal, -offset);
    double sum = 0.0;
    for (const auto* side : {&above, &below}) {
      for (const Ring& piece : *side) {
        ASSERT_GT(signed_area(piece), 0.0);
        sum += signed_area(piece);
      }
    }
    ASSERT_NEAR(sum, signed_area(ring), 1e-7 * signed_area(ring)) << "ring " << i;
    const auto in_any = [](const std::vector<Ring>& rings, Vec2 p) {
      return std::any_of(rings.begin(), rings.end(), [&](const Ring& r) { return contains(r, p); });
    };
    const Box box = bounding_box(ring);
    for (int j = 0; j < 20; ++j) {
      const Vec2 p{random.uniform(box.low.x, box.high.x), random.uniform(box.low.y, box.high.y)};
      const double side = (dot(normal, p) - offset) / norm(normal);
      double edge = 1.0;  // points on an edge belong to either
      for (std::size_t e = 0; e < n; ++e)
        edge = std::min(edge, point_segment_distance(p, ring[e], ring[(e + 1) % n]));
      if (std::abs(side) < 1e-6 || edge < 1e-6) continue;
      ASSERT_EQ(in_any(above, p), side > 0.0 && contains(ring, p)) << "ring " << i;
      ASSERT_EQ(in_any(below, p), side < 0.0 && contains(ring, p)) << "ring " << i;
    }
  }
}

TEST(ClipHalfPlane, CornersWithinRoundingOfTheLine) {
  // Edges that rotation leaves a last digit off the cutting line; the library alone loses this ring
  // altogether.
  const Ring comb{{3.3373168212187014, 7.947034372702678},  {3.3373168212187014, 6.947034372702678},
                  {6.3373168212187014, 6.947034372702678},  {6.3373168212187014, 5.947034372702678},
                  {3.337316821218701, 5.947034372702678},   {3.337316821218701, 4.947034372702678},
                  {3.3373168212187005, 3.947034372702678},  {3.3373168212187005, 2.947034372702678},
                  {6.3373168212187005, 2.9470343727026771}, {6.3373168212187005, 1.9470343727026771},
                  {3.3373168212187005, 1.947034372702678},  {3.3373168212187001, 0.94703437270267798},
                  {5.3373168212187, 0.94703437270267798},   {5.3373168212187, -0.052965627297322015},
                  {9.3373168212187, -0.052965627297323792}, {9.3373168212187014, 7.9470343727026771}};
  double sum = 0.0;
  for (const Ring& piece : clip_half_plane(comb, {1, 0}, 3.337316821218701)) sum += signed_area(piece);
  EXPECT_NEAR(sum, 40.0, 1e-7);
}

}  // namespace
}  // namespace waywright
