#include "waywright/geometry/lanes/kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "waywright/core/elementary.hpp"
#include "waywright/core/random.hpp"
#include "waywright/geometry/moving_outline.hpp"

namespace waywright {
namespace {

using segment_lanes::Kernels;

/// Rings of all kinds that a kernel has a way of its own for.
Ring random_outline(Random& random, int kind) {
  const Pose at{random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-pi, pi)};
  const double a = random.uniform(0.01, 2.0), b = random.uniform(0.01, 2.0);
  Ring body;
  switch (kind) {
    case 0: body = {{0, 0}}; break;
    case 1: body = {{0, 0}, {a, 0}}; break;
    case 2: body = {{-a, -b}, {a, -b}, {a, b}, {-a, b}}; break;
    case 3: body = {{-a, -b}, {a, -0.5 * b}, {0, b}}; break;
    case 4: body = {{-a, -b}, {a, -b}, {a, b}, {0.1 * a, -0.5 * b}, {-a, b}}; break;  // a notch
    default:
      for (int i = 0; i < 40; ++i) {  // more corners than edges made beforehand; a star
        const double r = i % 2 == 0 ? a : 0.6 * a;
        body.push_back({r * std::cos(two_pi * i / 40), r * std::sin(two_pi * i / 40)});
      }
  }
  return transformed(body, Frame{at});
}
constexpr int kinds = 6;

std::vector<Segment> random_segments(Random& random, int rings, int lines, int points) {
  std::vector<Segment> segments;
  std::uint32_t source = 0;
  for (int i = 0; i < rings; ++i, ++source) {
    const Ring ring = random_outline(random, 2 + static_cast<int>(random.integer(0, 2)));
    for (std::size_t k = 0; k < ring.size(); ++k) segments.push_back({ring[k], ring[(k + 1) % ring.size()], source, true});
  }
  const auto somewhere = [&] { return Vec2{random.uniform(-8, 8), random.uniform(-8, 8)}; };
  for (int i = 0; i < lines; ++i, ++source) segments.push_back({somewhere(), somewhere(), source});
  for (int i = 0; i < points; ++i, ++source) {
    const Vec2 p = somewhere();
    segments.push_back({p, p, source});
  }
  return segments;
}

double brute_force(const std::vector<Segment>& segments, const Ring& ring, std::size_t without) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& s : segments) {
    if (s.source == without) continue;
    if (ring.size() > 2 && (contains(ring, s.a) || contains(ring, s.b))) return 0.0;
    if (ring.size() == 1) least = std::min(least, point_segment_distance(ring[0], s.a, s.b));
    for (std::size_t i = 0; ring.size() > 1 && i < ring.size(); ++i) least = std::min(least, segment_distance(ring[i], ring[(i + 1) % ring.size()], s.a, s.b));
  }
  return least;
}

TEST(SegmentLanes, EveryInstructionSetFindsTheSameBits) {
  Random random{1};
  for (int round = 0; round < 90; ++round) {
    auto segments = random_segments(random, 30, 20, 10);
    if (round % 3 == 0) {  // on a lattice: many are equally far
      for (Segment& s : segments) {
        s.a = {0.1 * std::round(10.0 * s.a.x), 0.1 * std::round(10.0 * s.a.y)};
        s.b = {0.1 * std::round(10.0 * s.b.x), 0.1 * std::round(10.0 * s.b.y)};
      }
    }
    const ObstacleIndex index{segments};
    for (int i = 0; i < 60; ++i) {
      Ring ring = random_outline(random, i % kinds);
      if (round % 3 == 0) ring = rectangle({0.1 * static_cast<double>(random.integer(-60, 0)), 0.1 * static_cast<double>(random.integer(-60, 0))}, {0.1 * static_cast<double>(random.integer(1, 40)), 0.1 * static_cast<double>(random.integer(1, 40))});
      segment_lanes::Outline outline;
      make_ready(ring, outline);
      const double limit = random.uniform(0.1, 5.0);
      const std::uint32_t hint = i % 3 == 0 ? static_cast<std::uint32_t>(random.integer(0, 99)) : segment_lanes::none;
      const segment_lanes::Found first = segment_lanes::available().front().nearest(index.tree(), outline, limit, segment_lanes::none, false, hint);
      for (const Kernels& k : segment_lanes::available()) {
        const segment_lanes::Found found = k.nearest(index.tree(), outline, limit, segment_lanes::none, false, hint);
        EXPECT_EQ(found.squared, first.squared) << k.name;
        EXPECT_EQ(found.segment, first.segment) << k.name;
      }
    }
  }
}

/// Walls of a lattice, many of them equally far but for rounding.
TEST(SegmentLanes, NearTiesEndTheSameWay) {
  Random random{8};
  const auto whole = [&](long low, long high) { return 0.1 * static_cast<double>(random.integer(low, high)); };
  for (int round = 0; round < 300; ++round) {
    std::vector<Segment> segments;
    for (std::uint32_t i = 0; i < 100; ++i) {
      const Vec2 a{whole(-60, 60), whole(-60, 60)};
      segments.push_back({a, a + (i % 2 == 0 ? Vec2{0.0, whole(1, 40)} : Vec2{whole(1, 40), 0.0}), i});
    }
    const ObstacleIndex index{segments};
    for (int i = 0; i < 60; ++i) {
      const Vec2 low{whole(-60, 60), whole(-60, 60)};
      const Ring ring = rectangle(low, low + Vec2{whole(1, 9), whole(1, 9)});
      segment_lanes::Outline outline;
      make_ready(ring, outline);
      const segment_lanes::Found first = segment_lanes::available().front().nearest(index.tree(), outline, 100.0, segment_lanes::none, false, segment_lanes::none);
      for (const Kernels& k : segment_lanes::available()) {
        const segment_lanes::Found found = k.nearest(index.tree(), outline, 100.0, segment_lanes::none, false, segment_lanes::none);
        EXPECT_EQ(found.squared, first.squared) << k.name;
        EXPECT_EQ(found.segment, first.segment) << k.name;
      }
    }
  }
}

TEST(SegmentLanes, SineAndCosineAreThoseOfElementary) {
  Random random{2};
  for (int i = 0; i < 20'000; ++i) {
    alignas(64) double angle[8], sine[8], cosine[8];
    for (double& a : angle) a = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-8, 4.9));
    for (const Kernels& k : segment_lanes::available()) {
      k.sin_cos(angle, sine, cosine);
      for (int lane = 0; lane < 8; ++lane) {
        const SinCos one = sin_cos(angle[lane]);
        ASSERT_EQ(sine[lane], one.sin) << k.name << ' ' << angle[lane];
        ASSERT_EQ(cosine[lane], one.cos) << k.name << ' ' << angle[lane];
      }
    }
  }
}

TEST(ObstacleIndex, FindsWhatBruteForceFinds) {
  Random random{3};
  int contacts = 0, misses = 0;
  for (int round = 0; round < 120; ++round) {
    // From a block with one segment to more than a node of blocks.
    const int size = round % 4;
    const auto segments = size == 0 ? random_segments(random, 0, 1, 0) : size == 1 ? random_segments(random, 4, 3, 3) : size == 2 ? random_segments(random, 30, 20, 10)
                                                                                                                                  : random_segments(random, 150, 60, 60);
    const ObstacleIndex index{segments};
    for (int i = 0; i < 30; ++i) {
      const Ring ring = random_outline(random, i % kinds);
      const std::size_t without = i % 5 == 0 ? 0 : static_cast<std::size_t>(-1);
      const double limit = i % 7 == 0 ? std::numeric_limits<double>::infinity() : random.uniform(0.01, 4.0);
      const double truth = brute_force(segments, ring, without);
      const Nearest nearest = index.nearest(ring, limit, without);
      EXPECT_EQ(nearest.found, truth < limit) << truth << ' ' << limit;
      if (std::min(truth, limit) < std::numeric_limits<double>::infinity()) {
        EXPECT_NEAR(nearest.distance, std::min(truth, limit), 1e-12);
      }
      EXPECT_EQ(index.distance(ring, limit, without), nearest.distance);
      if (without == static_cast<std::size_t>(-1)) {
        EXPECT_EQ(index.is_clear(ring, 0.9 * truth), truth > 0.0);
        EXPECT_FALSE(index.is_clear(ring, 1.1 * truth + 1e-12));
      }
      if (nearest.found) {
        EXPECT_NE(nearest.source, without);
        EXPECT_NEAR(brute_force({{nearest.point, nearest.point, 0}}, ring, static_cast<std::size_t>(-1)), nearest.distance, 1e-9);
      }
      contacts += truth == 0.0;
      misses += truth >= limit;
    }
  }
  EXPECT_GT(contacts, 500);
  EXPECT_GT(misses, 300);
}

/// A rectangle of no width is a segment.
TEST(ObstacleIndex, IsExactForRingsWithoutArea) {
  const ObstacleIndex index{{{{0.5, 1}, {0.5, 2}, 0}, {{-3, 0}, {-3, 0}, 1}}};
  EXPECT_NEAR(index.distance(Ring{{0, 0}, {0, 0}, {1, 0}, {1, 0}}, 9.0), 1.0, 1e-15);
  EXPECT_NEAR(index.distance(Ring{{0, 0}, {1, 0}, {1, 0}, {0, 0}}, 9.0), 1.0, 1e-15);
  EXPECT_NEAR(index.distance(Ring{{0, 0}, {0, 0}, {0, 0}, {0, 0}}, 9.0), std::sqrt(1.25), 1e-15);
  EXPECT_EQ(index.distance(Ring{{0, 1.5}, {1, 1.5}, {1, 1.5}, {0, 1.5}}, 9.0), 0.0);
}

struct Whole {
  long x, y;
};

/// Inside by whole numbers; points on edges are left out by the caller.
bool is_inside(const std::vector<Whole>& ring, Whole p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Whole a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const long left = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    inside ^= (left > 0) == (b.y > a.y);
  }
  return inside;
}

/// Points level with corners, in decimetres that have no exact binary form: rays through corners are counted once.
TEST(ObstacleIndex, PointsLevelWithCornersOfConcaveOutlinesAreInOrOut) {
  Random random{6};
  const auto metres = [](Whole w) { return Vec2{0.1 * static_cast<double>(w.x), 0.1 * static_cast<double>(w.y)}; };
  int insides = 0, outsides = 0;
  for (int round = 0; round < 40'000; ++round) {
    const long a = random.integer(1, 6), b = random.integer(1, 6), c = random.integer(1, 6), d = random.integer(1, 6);
    const std::vector<Whole> ell{{-a, -d}, {b, -d}, {b, c}, {0, c}, {0, c + d}, {-a, c + d}};
    const std::vector<Whole> u{{-a, -b}, {a + c, -b}, {a + c, d}, {c, d}, {c, 0}, {0, 0}, {0, d}, {-a, d}};
    const std::vector<Whole>& body = round % 2 == 0 ? ell : u;
    const Whole at{random.integer(-60, 60), random.integer(-60, 60)};
    const Whole p{random.integer(-12, 12), body[static_cast<std::size_t>(random.integer(0, static_cast<long>(body.size()) - 1))].y};
    bool is_on_edge = false;
    for (std::size_t i = 0; i < body.size(); ++i) {
      const Whole e = body[i], f = body[(i + 1) % body.size()];
      is_on_edge |= (f.x - e.x) * (p.y - e.y) == (f.y - e.y) * (p.x - e.x) && p.x >= std::min(e.x, f.x) && p.x <= std::max(e.x, f.x) && p.y >= std::min(e.y, f.y) &&
                    p.y <= std::max(e.y, f.y);
    }
    if (is_on_edge) continue;
    Ring ring, placed;
    for (const Whole w : body) {
      ring.push_back(metres(w));
      placed.push_back(metres({w.x + at.x, w.y + at.y}));
    }
    const Vec2 point = metres({p.x + at.x, p.y + at.y});
    const ObstacleIndex index{{{point, point, 0}}};
    MovingOutline moving{ring};
    moving.place({metres(at).x, metres(at).y, 0.0}, 0.0, 1.0);
    const bool inside = is_inside(body, p);
    (inside ? insides : outsides) += 1;
    EXPECT_EQ(index.distance(placed, 9.0) == 0.0, inside) << round;
    EXPECT_EQ(moving.distance(index, 9.0) == 0.0, inside) << round;
    EXPECT_EQ(index.is_clear(placed, 0.0), !inside) << round;
  }
  EXPECT_GT(insides, 1000);
  EXPECT_GT(outsides, 5000);
}

/// A straight run's hull: long, thin, far from the origin. The proof allows for 4e-15 of the coordinates.
TEST(ObstacleIndex, LongThinRectanglesAreWithinTheProofsRounding) {
  Random random{7};
  for (int i = 0; i < 200'000; ++i) {
    const double extent = std::pow(10.0, random.uniform(1, 6));
    const Pose at{random.uniform(-1, 1) * extent, random.uniform(-1, 1) * extent, random.uniform(-pi, pi)};
    const Ring ring = transformed(rectangle({0, -0.5 * random.uniform(0.3, 1)}, {random.uniform(20, 300), 0.25}), Frame{at});
    // Just inside, along a long side.
    const std::size_t first = i % 2 == 0 ? 0 : 2;
    const Vec2 side = ring[(first + 1) % 4] - ring[first];
    const Vec2 point = ring[first] + random.uniform(0.0, 1.0) * side + (std::pow(10.0, random.uniform(-16, -12.5)) * extent / norm(side)) * Vec2{-side.y, side.x};
    const ObstacleIndex index{{{point, point, 0}}};
    EXPECT_LE(index.distance(ring, 1.0), 4e-15 * (extent + 300.0)) << extent;
  }
}

TEST(ObstacleIndex, OutlinesThatLookConvexAtEveryCornerAreSeenThrough) {
  const auto at = [](const Ring& ring, Vec2 p) { return ObstacleIndex{{{p, p, 0}}}.distance(ring, 9.0); };
  const Ring doubled{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 1}, {1, 4}, {0, 4}};  // a doubled corner where it turns right
  EXPECT_EQ(at(doubled, {3, 0.5}), 0.0);
  EXPECT_NEAR(at(doubled, {2, 2}), 1.0, 1e-15);
  Ring star;  // winds twice
  for (int i = 0; i < 5; ++i) star.push_back(unit(0.8 * pi * i));
  EXPECT_EQ(at(star, 0.95 * star[0]), 0.0);
  EXPECT_EQ(at(rectangle({0, 0}, {1, 1}), {0.5, 0.5}), 0.0);
  EXPECT_FALSE((ObstacleIndex{{{{0.5, 0.5}, {0.5, 0.5}, 0}}}.is_clear(rectangle({0, 0}, {1, 1}), 1e-170)));
}

TEST(ObstacleIndex, VisitsAllThatIsNear) {
  Random random{4};
  const auto segments = random_segments(random, 300, 100, 100);
  const ObstacleIndex index{segments};
  for (int i = 0; i < 200; ++i) {
    const Vec2 p{random.uniform(-9, 9), random.uniform(-9, 9)};
    const double within = random.uniform(0, 3);
    std::size_t truth = 0, seen = 0;
    for (const Segment& s : segments) truth += point_segment_distance(p, s.a, s.b) <= within;
    index.visit(p, within, [&](const Segment& s) { seen += point_segment_distance(p, s.a, s.b) <= within; });
    EXPECT_EQ(seen, truth);
  }
}

TEST(MovingOutline, IsAsFarAsItsRing) {
  Random random{5};
  const ObstacleIndex index{random_segments(random, 60, 20, 20)};
  for (int kind = 0; kind < kinds; ++kind) {
    MovingOutline outline{random_outline(random, kind)};
    for (int i = 0; i < 300; ++i) {
      const Pose pose{random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-pi, pi)};
      const SinCos turn = sin_cos(pose.heading);
      outline.place(pose, turn.sin, turn.cos);
      const double limit = random.uniform(0.1, 3.0);
      EXPECT_NEAR(outline.distance(index, limit), index.distance(outline.ring(), limit), 1e-13);
    }
  }
}

}  // namespace
}  // namespace waywright
