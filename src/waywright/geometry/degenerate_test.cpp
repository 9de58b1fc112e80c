// Corners on a coarse lattice, where everything coincides that can: straight corners, shared edges, slivers, points for segments; from a
// nanometre to a thousand kilometres.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/geometry/boolean.hpp"
#include "waywright/geometry/convex_parts.hpp"
#include "waywright/geometry/disc_cover.hpp"
#include "waywright/geometry/obstacle_index.hpp"

namespace waywright {
namespace {

struct Lattice {
  double cell;
  Vec2 origin;
};
const std::vector<Lattice> lattices{{1.0, {}}, {1e-9, {}}, {2e5, {}}, {0.1, {1e6 - 0.5, -1e6}}, {1e-9, {3.0, -2.0}}};

std::vector<Vec2> lattice_points(Random& random, const Lattice& lattice, std::int64_t most) {
  std::vector<Vec2> points;
  for (std::int64_t n = random.integer(1, most); n > 0; --n) {
    points.push_back(lattice.origin + lattice.cell * Vec2{static_cast<double>(random.integer(0, 4)), static_cast<double>(random.integer(0, 3))});
  }
  return points;
}

/// Rounding of what is computed there: m.
double slack(const Lattice& lattice) { return 1e-12 * lattice.cell + 1e-15 * (std::abs(lattice.origin.x) + std::abs(lattice.origin.y)); }

/// A ring that the readers would let through; empty where this draw is none.
Ring usable(Random& random, const Lattice& lattice) {
  const RingRepair repair = repair_ring(lattice_points(random, lattice, 9));
  EXPECT_NE(repair.refused.has_value(), repair.ring.size() >= 3);
  return repair.ring;
}

TEST(Degenerate, HullsAndWidthsOfAnyPoints) {
  Random random{1};
  for (const Lattice& lattice : lattices) {
    for (int i = 0; i < 2000; ++i) {
      const std::vector<Vec2> points = lattice_points(random, lattice, 12);
      const Ring hull = convex_hull(points);
      ASSERT_GE(hull.size(), 1U);
      for (const Vec2 p : points) EXPECT_LE(distance(nearest_in(hull, p), p), slack(lattice));
      const double width = least_width(points);
      EXPECT_GE(width, 0.0);
      EXPECT_LE(width, 5.0 * lattice.cell);
    }
  }
}

TEST(Degenerate, PartsAndDiscsCoverAnyUsableRing) {
  Random random{2};
  for (const Lattice& lattice : lattices) {
    int rings = 0;
    for (int i = 0; i < 3000; ++i) {
      const Ring ring = usable(random, lattice);
      if (ring.empty()) continue;
      ++rings;
      double area = 0.0;
      const std::vector<Ring> parts = convex_parts(ring);
      for (const Ring& part : parts) {
        EXPECT_TRUE(is_convex(part));
        area += signed_area(part);
      }
      const double cell_area = lattice.cell * lattice.cell + 20.0 * lattice.cell * slack(lattice);
      EXPECT_GE(area, signed_area(ring) - 1e-9 * cell_area);
      const std::vector<CoverDisc> discs = disc_cover(ring, 0.1 * lattice.cell, 8);
      for (int k = 0; k < 10; ++k) {
        const Vec2 p = nearest_in(ring, lattice.origin + lattice.cell * Vec2{random.uniform(0, 4), random.uniform(0, 3)});
        EXPECT_TRUE(std::any_of(parts.begin(), parts.end(), [&](const Ring& part) { return distance(nearest_in(part, p), p) <= slack(lattice); }));
        EXPECT_TRUE(std::any_of(discs.begin(), discs.end(), [&](const CoverDisc& d) { return distance(d.center, p) <= d.radius + slack(lattice); }));
      }
    }
    EXPECT_GT(rings, 300);
  }
}

TEST(Degenerate, CutsUnionsAndDifferencesAddUp) {
  Random random{3};
  for (const Lattice& lattice : lattices) {
    int joins = 0;
    for (int i = 0; i < 2000; ++i) {
      const Ring a = usable(random, lattice), b = usable(random, lattice);
      if (a.empty() || b.empty()) continue;
      const double area_slack = 1e-6 * lattice.cell * lattice.cell + 50.0 * lattice.cell * slack(lattice);
      // Along an axis, through corners.
      const double at = lattice.origin.x + lattice.cell * static_cast<double>(random.integer(0, 4));
      double halves = 0.0;
      for (const double sign : {1.0, -1.0}) {
        for (const Ring& piece : clip_half_plane(a, {sign, 0.0}, sign * at)) halves += signed_area(piece);
      }
      EXPECT_NEAR(halves, signed_area(a), area_slack);

      const auto both = joined(a, b);
      const auto rest = without(a, b);
      if (!both || !rest) continue;
      ++joins;
      double left = 0.0;
      for (const Ring& ring : *rest) left += signed_area(ring);
      EXPECT_NEAR(left + signed_area(b), signed_area(*both), area_slack);
    }
    if (lattice.cell >= 0.1) {  // of nanometres the answer may be that there is none
      EXPECT_GT(joins, 5);
    }
  }
}

TEST(Degenerate, NearestOfSegmentsThatAreAllInOnePlace) {
  Random random{4};
  for (const Lattice& lattice : lattices) {
    for (int i = 0; i < 300; ++i) {
      std::vector<Segment> segments;
      const bool one_place = random.uniform() < 0.3;
      for (std::int64_t n = random.integer(1, 200); n > 0; --n) {
        const std::vector<Vec2> p = lattice_points(random, lattice, 2);
        segments.push_back(one_place ? Segment{lattice.origin, lattice.origin, 0} : Segment{p.front(), p.back(), static_cast<std::uint32_t>(n)});
      }
      const ObstacleIndex index{segments};
      const Ring body = convex_hull(lattice_points(random, lattice, 4));
      double least = 100.0 * lattice.cell;
      for (const Segment& s : segments) {
        least = std::min(least, distance(nearest_in(body, s.a), s.a));
        for (std::size_t k = 0; k < body.size(); ++k) least = std::min(least, segment_distance(body[k], body[(k + 1) % body.size()], s.a, s.b));
      }
      const Nearest nearest = index.nearest(body, 100.0 * lattice.cell);
      EXPECT_NEAR(nearest.distance, least, slack(lattice));
      EXPECT_EQ(index.is_clear(body, 0.5 * lattice.cell), nearest.distance > 0.5 * lattice.cell);
    }
  }
}

}  // namespace
}  // namespace waywright
