#include "waywright/geometry/disc_cover.hpp"

#include <gtest/gtest.h>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

const Ring forklift{{-0.4, -0.6}, {1.2, -0.6}, {1.2, -0.35}, {2.4, -0.35}, {2.4, 0.35}, {1.2, 0.35}, {1.2, 0.6}, {-0.4, 0.6}};

TEST(DiscCover, HoldsTheRingAndItsInnerDiscsLieInIt) {
  const Ring upright = transformed(forklift, Frame{make_pose({0.3, 0.2}, 0.5 * pi)});
  for (const Ring& ring : {forklift, upright, Ring{{0, 0}, {3, 0}, {0, 1}}}) {
    for (const double bulge : {0.3, 0.05, 0.01}) {
      const auto discs = disc_cover(ring, bulge, 16);
      ASSERT_FALSE(discs.empty());
      Random random{9};
      const Box box = bounding_box(ring);
      for (int i = 0; i < 5000; ++i) {
        const Vec2 p{random.uniform(box.low.x, box.high.x), random.uniform(box.low.y, box.high.y)};
        bool covered = false, inner = false;
        for (const CoverDisc& d : discs) {
          covered |= distance(p, d.center) <= d.radius;
          inner |= distance(p, d.center) < d.inner - 1e-12;
        }
        const bool inside = contains(ring, p);
        EXPECT_TRUE(covered || !inside);
        EXPECT_TRUE(inside || !inner);
      }
    }
  }
}

TEST(DiscCover, MoreDiscsWhereLessBulgeIsAsked) {
  EXPECT_LT(disc_cover(forklift, 0.3, 16).size(), disc_cover(forklift, 0.02, 16).size());
  EXPECT_EQ(disc_cover(forklift, 0.0, 5).size(), 5U);
}

}  // namespace
}  // namespace waywright
