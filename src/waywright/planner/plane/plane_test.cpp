#include <gtest/gtest.h>

#include <array>

#include "waywright/core/random.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/plane/point_bins.hpp"
#include "waywright/planner/plane/rounded_way.hpp"
#include "waywright/planner/plane/view.hpp"

namespace waywright {
namespace {

Problem hall(Random& random, double disc, int boxes, double clearance = 0.02) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {12, 9})};
  for (int i = 0; i < boxes; ++i) {
    const Ring box = rectangle({0, 0}, {random.uniform(0.2, 1.2), random.uniform(0.2, 1.2)});
    s.map.obstacles.push_back(transformed(box, Frame{make_pose({random.uniform(0, 11), random.uniform(0, 8)}, random.uniform(-1, 1))}));
  }
  s.map.lines.push_back({{2.0, 2.0}, {4.0, 2.5}, {4.0, 4.0}});
  s.map.points = {{8.0, 8.0}, {8.5, 7.0}};
  s.vehicle.footprint = {{}, disc};
  s.vehicle.drive = Differential{0.5};
  s.clearance = clearance;
  s.start = {0.5, 0.5, 0.0};
  s.mission = Pose{11.5, 8.5, 0.0};
  return Problem::prepare(std::move(s)).value();
}

TEST(PointBins, NearestAndWithinAsByLookingAtAll) {
  Random random{5};
  PointBins bins;
  std::vector<PointBins::Near> near;
  for (const Box& region : {Box{{0, 0}, {10, 10}}, Box{{-3, 2}, {400, 2.5}}, Box{{0, 0}, {1e-12, 5}}}) {
    bins.clear(region);
    EXPECT_EQ(bins.nearest({0, 0}), PointBins::none);
    const Vec2 size = region.high - region.low;
    const auto place = [&] {  // some are outside of the region
      return region.low + Vec2{random.uniform(-0.2, 1.2) * size.x, random.uniform(-0.2, 1.2) * size.y};
    };
    for (int i = 0; i < 3000; ++i) {
      bins.add(place());
      if (i % 37 != 0) continue;
      const Vec2 at = place();
      std::uint32_t expected = 0;
      for (std::uint32_t k = 1; k < bins.size(); ++k) {
        if (squared_norm(bins[k] - at) < squared_norm(bins[expected] - at)) expected = k;
      }
      ASSERT_EQ(bins.nearest(at), expected) << i;
      const double radius = random.uniform(0.0, 0.3) * norm(size);
      std::vector<bool> seen(bins.size(), false);
      bins.within(at, radius, near);
      for (const PointBins::Near& n : near) {
        ASSERT_FALSE(seen[n.index]);
        ASSERT_EQ(n.squared, squared_norm(bins[n.index] - at));
        seen[n.index] = true;
      }
      for (std::uint32_t k = 0; k < bins.size(); ++k) ASSERT_EQ(seen[k], squared_norm(bins[k] - at) <= radius * radius);
    }
  }
}

TEST(PlaneSpace, LinesAreFreeAsTheExactOutlinesHaveIt) {
  Random random{9};
  int free = 0, blocked = 0;
  for (int map = 0; map < 8; ++map) {
    const Problem problem = hall(random, map % 2 == 0 ? 0.3 : 0.0, 12);
    const PlaneSpace space{problem};
    for (int i = 0; i < 4000; ++i) {
      const Vec2 a{random.uniform(-1, 13), random.uniform(-1, 10)};
      const Vec2 b = i % 3 == 0 ? a : i % 3 == 1 ? a + Vec2{random.uniform(-1, 1), random.uniform(-1, 1)} : Vec2{random.uniform(-1, 13), random.uniform(-1, 10)};
      const double margin = i % 5 == 0 ? random.uniform(0.0, 0.6) : space.needed();
      const std::vector<Vec2> ring = a == b ? std::vector<Vec2>{a} : std::vector<Vec2>{a, b};
      const double exact = problem.world().least_clearance(ring, 0.0, 10.0);
      if (std::abs(exact - margin) < 1e-9) continue;
      ASSERT_EQ(a == b ? space.is_free(a, margin) : space.is_free(a, b, margin), exact > margin) << a.x << " " << a.y << " " << b.x << " " << b.y;
      if (margin == space.needed()) {
        ASSERT_EQ(space.is_free(a, b, distance(a, b), space.room(a), space.room(b)), exact > margin) << a.x << " " << a.y << " " << b.x << " " << b.y;
      }
      (exact > margin ? free : blocked) += 1;
    }
  }
  EXPECT_GT(free, 5000);
  EXPECT_GT(blocked, 5000);
}

TEST(PlaneSpace, WhatIsLearntOfALineHoldsAroundIt) {
  Random random{27};
  int free_around = 0, hits = 0;
  for (int map = 0; map < 6; ++map) {
    const Problem problem = hall(random, map % 2 == 0 ? 0.0 : 0.2, 8);
    const PlaneSpace space{problem};
    for (int i = 0; i < 3000; ++i) {
      const Vec2 a{random.uniform(0, 12), random.uniform(0, 9)}, b = a + random.uniform(0.1, 3.0) * unit(wrap(random.uniform(0.0, two_pi)));
      PlaneSpace::Line line;
      const bool is_free = space.is_free(a, b, distance(a, b), space.room(a), space.room(b), line);
      ASSERT_EQ(is_free, space.is_free(a, b));
      for (int k = 0; k < 8; ++k) {
        const Vec2 way = unit(wrap(random.uniform(0.0, two_pi)));
        const double share = k < 4 ? 0.999 : random.uniform();
        if (is_free && line.around > 0.0) {
          ++free_around;
          ASSERT_TRUE(space.is_free(a, b + share * line.around * way)) << a.x << " " << a.y << " " << b.x << " " << b.y;
        } else if (!is_free && line.hit >= 0.0) {
          ++hits;
          const Vec2 middle = a + (line.hit / distance(a, b)) * (b - a);
          ASSERT_FALSE(space.is_free(middle + share * line.blocked * way)) << a.x << " " << a.y << " " << b.x << " " << b.y;
        }
      }
    }
  }
  EXPECT_GT(free_around, 1000);
  EXPECT_GT(hits, 1000);
}

TEST(PlaneSpace, TellsMuchOfWhatIsBlockedAndHowFarAround) {
  Random random{21};
  int blocked = 0, told = 0, told_around = 0;
  for (int map = 0; map < 6; ++map) {
    const Problem problem = hall(random, map % 2 == 0 ? 0.0 : 0.2, 12);
    const PlaneSpace space{problem};
    for (int i = 0; i < 5000; ++i) {
      const Vec2 at{random.uniform(-0.1, 12.1), random.uniform(-0.1, 9.1)};
      const double off = i % 2 == 0 ? 0.0 : random.uniform(0.0, 0.3);
      const bool is_told = space.is_surely_blocked(at, off);
      const bool is_of_a_point = map % 2 == 0;  // around which no ring of what is needed tells it
      if (is_of_a_point && off == 0.0 && problem.world().least_clearance(std::vector<Vec2>{at}, 0.0, 10.0) <= space.needed()) {
        ++blocked;
        told += is_told ? 1 : 0;
      }
      if (!is_told) continue;
      for (int k = 0; k < 8; ++k) {
        const Vec2 there = at + random.uniform(0.0, off) * unit(wrap(random.uniform(0.0, two_pi)));
        ASSERT_LE(problem.world().least_clearance(std::vector<Vec2>{there}, 0.0, 10.0), space.needed()) << at.x << " " << at.y << " " << off;
      }
      told_around += is_of_a_point && off > 0.1 ? 1 : 0;
    }
  }
  EXPECT_GT(blocked, 500);
  EXPECT_GT(told, 0.4 * blocked);
  EXPECT_GT(told_around, 10);
}

TEST(PlaneSpace, TheFreeAreaIsNotUnderTheTruth) {
  Random random{3};
  const Problem problem = hall(random, 0.3, 10);
  const PlaneSpace space{problem};
  const Vec2 size = space.region().high - space.region().low;
  int free = 0;
  constexpr int drawn = 20'000;
  for (int i = 0; i < drawn; ++i) free += space.is_free(space.region().low + Vec2{random.uniform() * size.x, random.uniform() * size.y}) ? 1 : 0;
  const double area = size.x * size.y * free / drawn;
  EXPECT_GT(space.free_area(), 0.98 * area);
  EXPECT_LT(space.free_area(), 1.1 * area);
}

TEST(PlaneView, SeesWhatIsFreeAndIsMostlyToldByItsTable) {
  Random random{19};
  int asked = 0, told = 0, told_in_single = 0, hidden = 0;
  for (int map = 0; map < 12; ++map) {
    const double disc = map % 3 == 0 ? 0.0 : 0.1 * (map % 3);
    const Problem problem = hall(random, disc, 12);
    const PlaneSpace space{problem};
    const Vec2 from{random.uniform(0.5, 11.5), random.uniform(0.5, 8.5)};
    if (!space.is_free(from)) continue;
    PlaneView view{space, from};
    for (int i = 0; i < 20'000; ++i) {
      const Vec2 at{random.uniform(-1, 13), random.uniform(-1, 10)};
      const std::vector<Vec2> ring{at, from};
      const bool is_free = problem.world().least_clearance(ring, 0.0, 2.0) > space.needed();  // the exact outlines, no table
      ASSERT_EQ(view.sees(at), is_free) << map << ": " << at.x << " " << at.y;
      const PlaneView::Seen seen = view.seen(at);
      told += seen == PlaneView::Seen::not_told ? 0 : 1;
      if (seen != PlaneView::Seen::not_told) {
        ASSERT_EQ(seen == PlaneView::Seen::yes, is_free) << map << ": " << at.x << " " << at.y;
      }
      // The tables for single precision, whose bins may be off by one.
      const auto squared = static_cast<float>(squared_norm(at - from));
      const std::size_t bin = (PlaneView::index(at - from) + PlaneView::count + static_cast<std::size_t>(i % 3) - 1) % PlaneView::count;
      const bool is_seen = squared < view.seen_squares()[bin], is_hidden = squared > view.hidden_squares()[bin];
      ASSERT_FALSE(is_free ? is_hidden : is_seen) << map << ": " << at.x << " " << at.y;
      told_in_single += is_seen || is_hidden ? 1 : 0;
      hidden += is_free ? 0 : 1;
      ++asked;
    }
  }
  EXPECT_GT(asked, 120'000);
  EXPECT_GT(hidden, 20'000);
  EXPECT_LT(hidden, asked - 20'000);
  EXPECT_GT(told, 0.9 * asked);
  EXPECT_GT(told_in_single, 0.85 * asked);
}

TEST(PlaneView, DiscsFromWhichItIsSeenEverywhereOrNowhere) {
  Random random{23};
  std::array<int, 3> told{};
  for (int map = 0; map < 8; ++map) {
    const Problem problem = hall(random, 0.1 * (map % 3), map < 4 ? 3 : 12);
    const PlaneSpace space{problem};
    const Vec2 from{random.uniform(0.5, 11.5), random.uniform(0.5, 8.5)};
    if (!space.is_free(from)) continue;
    PlaneView view{space, from};
    for (int i = 0; i < 2000; ++i) {
      const Vec2 middle{random.uniform(0.0, 12.0), random.uniform(0.0, 9.0)};
      const double radius = random.uniform(0.05, 2.5);
      const PlaneView::Seen seen = view.seen_from_all(middle, radius);
      ++told[static_cast<std::size_t>(seen)];
      if (seen == PlaneView::Seen::not_told) continue;
      for (int k = 0; k < 10; ++k) {
        const Vec2 at = middle + radius * (k < 4 ? 1.0 : random.uniform()) * unit(wrap(random.uniform(0.0, two_pi)));
        ASSERT_EQ(space.is_free(at, from), seen == PlaneView::Seen::yes) << map << ": " << at.x << " " << at.y;
      }
    }
  }
  for (const int n : told) EXPECT_GT(n, 200);
}

TEST(PlaneEnds, ARunLeadsOutOfWhereTheDiscCannotStand) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {10, 6})};
  s.map.obstacles = {rectangle({0, 2.0}, {3, 2.3}), rectangle({0, 3.7}, {3, 4.0})};
  s.vehicle.footprint = {{{-0.3, -0.3}, {1.5, -0.3}, {1.5, 0.3}, {-0.3, 0.3}}, 0.0};
  s.vehicle.drive = Differential{0.5};
  s.start = {0.6, 3.0, 0.0};         // in a stall, forks out
  s.mission = Pose{8.2, 3.0, pi};    // its forks look back
  const Problem problem = Problem::prepare(s).value();
  const PlaneSpace space{problem};
  ASSERT_FALSE(space.is_free(problem.start().position()));
  const auto start = plane_start(space);
  ASSERT_TRUE(start);
  EXPECT_EQ(start->run, 1);
  EXPECT_NEAR(start->at.y, 3.0, 1e-9);
  EXPECT_GT(start->at.x, 3.0);
  EXPECT_TRUE(space.is_free(start->at));
  const auto goal = plane_goal(space);
  ASSERT_TRUE(goal);
  const Path path = plane_path(space, *start, {start->at, goal->at}, *goal);
  EXPECT_NEAR(distance(start_pose(path).position(), problem.start().position()), 0.0, 1e-12);
  EXPECT_NEAR(distance(end_pose(path).position(), problem.goal().position()), 0.0, 1e-9);
  EXPECT_NEAR(std::abs(wrap(end_pose(path).heading - pi)), 0.0, 1e-9);
  s.start = {0.6, 3.0, pi};  // forks in the wall: backwards out
  s.vehicle.footprint = {{{-1.5, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-1.5, 0.3}}, 0.0};
  const Problem turned = Problem::prepare(s).value();
  const PlaneSpace other{turned};
  const auto backwards = plane_start(other);
  ASSERT_TRUE(backwards);
  EXPECT_EQ(backwards->run, -1);
}

// A way over middles of cells does not turn aside for those beside its ends, and is free and no longer as before.
TEST(PlaneEnds, StubsAtTheEndsAreLeftOut) {
  Random random{23};
  const Problem problem = hall(random, 0.2, 8);
  const PlaneSpace space{problem};
  int shorter = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<Vec2> points{{0.6, 0.6}};
    while (points.size() < 40) {
      const Vec2 next = points.back() + 0.05 * Vec2{random.uniform(-1, 3), random.uniform(-1, 3)};
      if (space.is_free(points.back(), next)) points.push_back(next);
      else if (random.uniform(0, 1) < 0.2) break;
    }
    if (points.size() < 2) continue;
    const std::vector<Vec2> way = without_stubs(space, points, 0.3);
    EXPECT_EQ(way.front(), points.front());
    EXPECT_EQ(way.back(), points.back());
    EXPECT_LE(length_of_way(way), length_of_way(points) + 1e-12);
    shorter += way.size() < points.size() ? 1 : 0;
    for (std::size_t k = 1; k < way.size(); ++k) EXPECT_TRUE(space.is_free(way[k - 1], way[k]));
  }
  EXPECT_GT(shorter, 300);
  const std::vector<Vec2> zigzag{{1, 1}, {1.05, 1.08}, {2, 1.1}, {3, 1.0}, {3.02, 1.06}, {3.1, 1}};
  const Problem empty = hall(random, 0.0, 0);
  EXPECT_EQ(without_stubs(PlaneSpace{empty}, zigzag, 0.2), (std::vector<Vec2>{{1, 1}, {2, 1.1}, {3.1, 1}}));
  EXPECT_EQ(without_stubs(PlaneSpace{empty}, {{1, 1}, {2, 1}}, 5.0), (std::vector<Vec2>{{1, 1}, {2, 1}}));
}

TEST(PlaneEnds, TautWaysKeepTheirEndsAndAreNeverLonger) {
  Random random{11};
  const Problem problem = hall(random, 0.2, 8);
  const PlaneSpace space{problem};
  int checked = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<Vec2> points{{0.6, 0.6}};
    while (points.size() < 12) {
      const Vec2 next = points.back() + Vec2{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)};
      if (space.is_free(points.back(), next)) points.push_back(next);
    }
    const std::vector<Vec2> taut = taut_way(points, space);
    EXPECT_EQ(taut.front(), points.front());
    EXPECT_EQ(taut.back(), points.back());
    EXPECT_LE(length_of_way(taut), length_of_way(points) + 1e-12);
    for (std::size_t k = 1; k < taut.size(); ++k) EXPECT_TRUE(space.is_free(taut[k - 1], taut[k]));
    for (std::size_t k = 2; k < taut.size(); ++k) EXPECT_FALSE(space.is_free(taut[k - 2], taut[k]));
    checked += taut.size() < points.size() ? 1 : 0;
  }
  EXPECT_GT(checked, 100);
}

}  // namespace
}  // namespace waywright
