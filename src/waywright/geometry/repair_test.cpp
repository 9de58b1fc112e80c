#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "waywright/core/random.hpp"
#include "waywright/geometry/polygon.hpp"

namespace waywright {
namespace {

const Ring square = rectangle({0, 0}, {2, 2});

std::string refusal(const Ring& ring) {
  const RingRepair repair = repair_ring(ring);
  EXPECT_EQ(repair.ring.empty(), repair.refused.has_value());
  return repair.refused.value_or("");
}

TEST(RepairRing, GoodRingIsLeftAlone) {
  const RingRepair repair = repair_ring(square);
  EXPECT_FALSE(repair.refused);
  EXPECT_TRUE(repair.mended.empty());
  EXPECT_EQ(repair.ring, square);
}

TEST(RepairRing, DuplicatesAndClosingCornerAreDropped) {
  const RingRepair repair = repair_ring({{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 2}, {0, 0}});
  EXPECT_FALSE(repair.refused);
  EXPECT_EQ(repair.ring, square);
  EXPECT_EQ(repair.mended, std::vector<std::string>{"3 duplicate corners removed"});
  EXPECT_EQ(repair_ring({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}).mended,
            std::vector<std::string>{"1 duplicate corner removed"});
}

TEST(RepairRing, ClockwiseIsReversedFromTheSameFirstCorner) {
  const RingRepair repair = repair_ring({{0, 0}, {0, 2}, {2, 2}, {2, 0}});
  EXPECT_EQ(repair.ring, square);
  EXPECT_EQ(repair.mended, std::vector<std::string>{"clockwise order reversed"});
}

TEST(RepairRing, StraightCornersAreKept) {
  const Ring ring{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_EQ(repair_ring(ring).ring, ring);
}

TEST(RepairRing, NotFiniteIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal({{0, 0}, {nan, 0}, {1, 1}}), "corner 1 has a coordinate that is not finite");
  EXPECT_EQ(refusal({{0, 0}, {1, 0}, {1, -infinity}}), "corner 2 has a coordinate that is not finite");
}

TEST(RepairRing, TooFewCornersAreRefused) {
  EXPECT_EQ(refusal({}), "a polygon needs at least 3 different corners and this one has 0");
  EXPECT_EQ(refusal({{1, 1}, {1, 1}, {1, 1}, {1, 1}}),
            "a polygon needs at least 3 different corners and this one has 1");
  EXPECT_EQ(refusal({{1, 1}, {2, 1}, {1, 1}}),
            "a polygon needs at least 3 different corners and this one has 2");
}

TEST(RepairRing, NoAreaIsRefused) {
  EXPECT_EQ(refusal({{0, 0}, {1, 1}, {2, 2}}), "the polygon has no area");
  EXPECT_EQ(refusal({{0, 0}, {1, 0}, {3, 0}, {2, 0}}), "the polygon has no area");
  EXPECT_EQ(refusal({{0, 0}, {1, 0}, {0, 0}, {1, 0}}), "the polygon has no area");
  // Straight but for rounding.
  EXPECT_EQ(refusal({{-3.6190141598609031, -9.762700230494751},
                     {-3.7747455714060618, -8.7749007936361583},
                     {-4.0862083944963796, -6.7993019199189728}}),
            "the polygon has no area");
}

TEST(RepairRing, CrossingEdgesAreNamed) {
  EXPECT_EQ(refusal({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), "edges 0 and 2 cross at (1, 1)");
  EXPECT_EQ(refusal({{0, 0}, {4, 0}, {4, 4}, {3, -1}, {0, 4}}), "edges 0 and 2 cross at (3.2, 0)");
}

TEST(RepairRing, TouchingItselfIsRefused) {
  // A corner on an edge, a corner on a corner, an edge along an edge.
  EXPECT_EQ(refusal({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}), "edges 0 and 2 touch at (2, 0)");
  EXPECT_NE(refusal({{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}).find("touch at (2, 2)"),
            std::string::npos);
  EXPECT_NE(refusal({{0, 0}, {5, 0}, {5, 3}, {3, 3}, {3, 0}, {2, 0}, {2, 3}, {0, 3}}).find("touch"),
            std::string::npos);
}

TEST(RepairRing, SpikesAreRefusedAndLocated) {
  EXPECT_EQ(refusal({{0, 0}, {2, 0}, {2, 1}, {5, 1}, {2, 1}, {2, 2}, {0, 2}}),
            "the outline folds back on itself at corner 3, (5, 1)");
  const Ring turned =
      transformed({{0, 0}, {2, 0}, {2, 1}, {5, 1}, {2, 1}, {2, 2}, {0, 2}}, Frame{Pose{3, 4, 0.7}});
  EXPECT_NE(refusal(turned).find("folds back on itself at corner 3"), std::string::npos);
  EXPECT_EQ(refusal({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, -1}}),
            "the outline folds back on itself at corner 4, (0, -1)");
}

TEST(RepairRing, TinyAndHugeRings) {
  for (const double size : {1e-9, 1e-3, 1.0, 1e6}) {
    Ring ring{{0, 0}, {0, size}, {size, size}, {size, 0}};
    const RingRepair repair = repair_ring(ring);
    EXPECT_FALSE(repair.refused) << size << ": " << repair.refused.value_or("");
    EXPECT_NEAR(signed_area(repair.ring), size * size, 1e-12 * size * size);
    EXPECT_NE(refusal({{0, 0}, {size, size}, {size, 0}, {0, size}}).find("edges 0 and 2 cross"),
              std::string::npos);
  }
  EXPECT_FALSE(repair_ring(transformed(square, Frame{Pose{1e6, 1e6, 0.3}})).refused);
}

TEST(RepairRing, TenThousandCornersAreQuick) {
  Random random{11};
  constexpr int n = 10000;
  Ring wheel;
  for (int i = 0; i < n; ++i) wheel.push_back(random.uniform(5, 6) * unit(two_pi * i / n));
  Ring comb{{-5, 5000}, {-5, -1}};  // every tooth overlaps every other in x
  for (int i = 0; i < n / 2; ++i) {
    comb.push_back({0.0, i * 1.0});
    comb.push_back({1000.0 + i % 7, i + 0.5});
  }
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(repair_ring(wheel).refused);
  EXPECT_FALSE(repair_ring(comb).refused);
  std::swap(wheel[4000], wheel[7000]);
  EXPECT_TRUE(repair_ring(wheel).refused);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_LT(seconds, 20.0);  // a generous bound for slow machines and sanitizers; about 0.3 s in release
}

// Against testing all pairs by parameters of the crossing point.
TEST(RepairRing, FindsCrossingsWhereAllPairsDo) {
  Random random{12};
  int crossing = 0;
  for (int i = 0; i < 5000; ++i) {
    Ring ring;
    const auto n = static_cast<std::size_t>(random.integer(4, 9));
    for (std::size_t k = 0; k < n; ++k) {
      ring.push_back(
          random.uniform(2, 5) *
          unit(two_pi * (static_cast<double>(k) + random.uniform(-0.7, 0.7)) / static_cast<double>(n)));
    }
    bool expected = false;
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = a + 2; b < n; ++b) {
        if (a == 0 && b + 1 == n) continue;
        const Vec2 p = ring[a], r = ring[a + 1] - ring[a];
        const Vec2 q = ring[b], s = ring[(b + 1) % n] - ring[b];
        const double u = cross(q - p, s) / cross(r, s);
        const double v = cross(q - p, r) / cross(r, s);
        expected = expected || (u > 0 && u < 1 && v > 0 && v < 1);
      }
    }
    crossing += expected ? 1 : 0;
    ASSERT_EQ(repair_ring(ring).refused.has_value(), expected) << "ring " << i;
  }
  EXPECT_GT(crossing, 300);
  EXPECT_LT(crossing, 4700);
}

/// A comb of n teeth between 0 and n, each from y = 0 to 100, along a line that rises: in x and in y all edges overlap many others.
Ring comb(int teeth, double slope) {
  Ring ring{{0.0, -1.0}, {1.0 * teeth, slope * teeth - 1.0}};
  for (int i = teeth; i-- > 0;) {
    const double y = slope * (i + 0.05);
    ring.push_back({i + 0.9, y + 100.0});
    ring.push_back({i + 0.1, y + 100.0});
    ring.push_back({i + 0.05, y});
  }
  return ring;
}

// 100 000 corners: pairs by the billion would be looked at for ever, so that a wrong order of growth is found by the work limit.
TEST(RepairRing, LargeOutlinesAreCheckedInLittleWork) {
  Random random{31};
  Ring round;
  for (int i = 0; i < 100'000; ++i) round.push_back(random.uniform(9.0, 9.0001) * unit(two_pi * i / 100'000.0));
  for (Ring ring : {round, comb(33'000, 0.0), comb(33'000, 1.0), comb(33'000, 90.0)}) {
    EXPECT_FALSE(repair_ring(ring).refused) << *repair_ring(ring).refused;
    const std::size_t far = ring.size() / 3;
    std::swap(ring[5], ring[far]);
    ASSERT_TRUE(repair_ring(ring).refused);
    EXPECT_NE(repair_ring(ring).refused->find("cross"), std::string::npos) << *repair_ring(ring).refused;
  }
}

TEST(RepairRing, EveryCrossingIsFound) {
  Random random{32};
  int simple = 0;
  for (int i = 0; i < 4000; ++i) {
    Ring ring;
    const int n = static_cast<int>(random.integer(3, 12));
    for (int k = 0; k < n; ++k) ring.push_back(random.uniform(0.3, 1.0) * unit(two_pi * (k + random.uniform(-1.0, 1.0)) / n));
    bool crosses = false;
    for (std::size_t a = 0; a < ring.size(); ++a) {
      for (std::size_t b = a + 2; b < ring.size(); ++b) {
        if (a == 0 && b + 1 == ring.size()) continue;
        const Vec2 p = ring[a], q = ring[a + 1], r = ring[b], s = ring[(b + 1) % ring.size()];
        crosses |= cross(q - p, r - p) * cross(q - p, s - p) < 0.0 && cross(s - r, p - r) * cross(s - r, q - r) < 0.0;
      }
    }
    simple += crosses ? 0 : 1;
    EXPECT_EQ(repair_ring(ring).refused.has_value(), crosses) << i;
  }
  EXPECT_GT(simple, 400);
  EXPECT_LT(simple, 3600);
}

}  // namespace
}  // namespace waywright
