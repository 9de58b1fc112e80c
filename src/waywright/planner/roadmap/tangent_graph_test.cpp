#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "waywright/core/random.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/roadmap/tangent_graph.hpp"

namespace waywright {
namespace {

Scenario hall(Random& random, double disc, int boxes, double room = 1.3) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {10, 8})};
  for (int i = 0; i < boxes; ++i) {
    Ring points;
    const Vec2 at{random.uniform(0.5, 9.5), random.uniform(0.5, 7.5)};
    for (int k = 0; k < 7; ++k) points.push_back(at + Vec2{random.uniform(-room, room), random.uniform(-room, room)});
    s.map.obstacles.push_back(convex_hull(points));
  }
  s.vehicle.footprint = {{}, disc};
  s.vehicle.drive = Differential{0.5};
  s.start = {0.6, 0.6, 0.0};
  s.mission = Pose{9.4, 7.4, 0.0};
  return s;
}

/// The shortest way among places, each seen from another where the straight line between keeps `margin` by looking at every edge, by plain Dijkstra on a full matrix.
double by_hand(const Scenario& s, const std::vector<Vec2>& places, double margin) {
  std::vector<std::pair<Vec2, Vec2>> edges;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  };
  for (const Ring& ring : s.map.obstacles) add(ring);
  for (const Ring& ring : s.map.boundaries) add(ring);
  const auto sees = [&](Vec2 a, Vec2 b) {
    for (const auto& [p, q] : edges) {
      if (segment_distance(a, b, p, q) < margin) return false;
    }
    return true;
  };
  const auto is_solid = [&](Vec2 p) {
    for (const Ring& ring : s.map.obstacles) {
      if (contains(ring, p)) return true;
    }
    return !contains(s.map.boundaries.front(), p);
  };
  const std::size_t n = places.size();
  std::vector<double> cost(n, std::numeric_limits<double>::infinity());
  std::vector<bool> done(n, false);
  cost[0] = 0.0;
  while (true) {
    std::size_t at = n;
    for (std::size_t i = 0; i < n; ++i) {
      if (!done[i] && std::isfinite(cost[i]) && (at == n || cost[i] < cost[at])) at = i;
    }
    if (at == n) return std::numeric_limits<double>::infinity();
    if (at == 1) return cost[1];
    done[at] = true;
    if (is_solid(places[at])) continue;
    for (std::size_t i = 0; i < n; ++i) {
      const double longer = cost[at] + distance(places[at], places[i]);
      if (!done[i] && longer < cost[i] && sees(places[at], places[i])) cost[i] = longer;
    }
  }
}

/// Places on polygons around the circles of all corners, that hold the circles.
std::vector<Vec2> places_around(const Scenario& s, double radius, int sides) {
  std::vector<Vec2> places{s.start.position(), std::get<Pose>(s.mission).position()};
  const auto add = [&](Vec2 corner) {
    for (int i = 0; i < sides; ++i) places.push_back(corner + (radius / std::cos(pi / sides)) * unit(wrap(two_pi * (i + 0.5) / sides)));
  };
  for (const Ring& ring : s.map.obstacles) {
    for (const Vec2 p : ring) add(p);
  }
  return places;
}

bool ends_are_free(const PlaneSpace& space, double radius) { return space.is_free(space.problem().start().position(), radius) && space.is_free(space.problem().goal().position(), radius); }

TEST(TangentGraph, OfAPointAsAnIndependentConstructionOnAThousandMaps) {
  Random random{17};
  constexpr double tiny = 1e-5;
  int found = 0, none = 0, bent = 0;
  for (int map = 0; map < 1000; ++map) {
    const Scenario s = hall(random, 0.0, 3 + map % 8, map % 10 == 0 ? 2.6 : 1.3);
    const Problem problem = Problem::prepare(s).value();
    const PlaneSpace space{problem};
    if (!ends_are_free(space, 1e-3)) continue;
    TangentGraph graph{space, tiny, 0.5 * tiny};
    Budget budget;
    const TangentAnswer answer = graph.shortest(s.start.position(), {{std::get<Pose>(s.mission).position()}}, budget);
    const double expected = by_hand(s, places_around(s, tiny, 4), 0.5 * tiny);
    ASSERT_EQ(answer.ended == TangentEnd::found, std::isfinite(expected)) << "map " << map;
    if (!std::isfinite(expected)) {
      ++none;
      continue;
    }
    ++found;
    bent += answer.way.bends.empty() ? 0 : 1;
    ASSERT_NEAR(answer.way.length, expected, 2e-3 * tiny * 1e3 + 1e-3) << "map " << map;
    graph.see_all();
    const TangentAnswer again = graph.shortest(s.start.position(), {{std::get<Pose>(s.mission).position()}}, budget);
    ASSERT_NEAR(again.way.length, answer.way.length, 1e-9);
  }
  EXPECT_GT(found, 500);
  EXPECT_GT(bent, 300);
  EXPECT_GT(none, 5);
}

TEST(TangentGraph, OfADiscAsAnIndependentConstruction) {
  Random random{23};
  constexpr double radius = 0.35;
  constexpr int sides = 24;
  int compared = 0;
  for (int map = 0; map < 60; ++map) {
    const Scenario s = hall(random, 0.0, 2 + map % 4, 1.0);
    const Problem problem = Problem::prepare(s).value();
    const PlaneSpace space{problem};
    if (!ends_are_free(space, radius)) continue;
    const TangentGraph graph{space, radius, radius - 1e-6};
    Budget budget;
    const TangentAnswer answer = graph.shortest(s.start.position(), {{std::get<Pose>(s.mission).position()}}, budget);
    const double expected = by_hand(s, places_around(s, radius, sides), radius - 1e-6);
    if (!std::isfinite(expected)) continue;  // gaps that polygons around the circles do not fit through
    ASSERT_EQ(answer.ended, TangentEnd::found) << "map " << map;
    EXPECT_LE(answer.way.length, expected + 1e-9) << "map " << map;
    // Polygons of 24 sides are at most 0.6 % longer around than the circle; where another gap is taken the difference is larger, but then both are close.
    EXPECT_GE(answer.way.length, expected * 0.99) << "map " << map;
    ++compared;
  }
  EXPECT_GT(compared, 30);
}

TEST(TangentGraph, AroundOneCornerInClosedForm) {
  Scenario s;
  s.map.obstacles = {rectangle({0, -5}, {10, 0})};
  s.vehicle.drive = Differential{0.5};
  s.vehicle.footprint = {{}, 0.1};
  s.start = {-1.0, -3.0, 0.0};
  s.mission = Pose{5.0, 1.0, 0.0};
  const Problem problem = Problem::prepare(s).value();
  const PlaneSpace space{problem};
  const double r = 0.5;
  const TangentGraph graph{space, r, r - 1e-6};
  Budget budget;
  const TangentAnswer answer = graph.shortest({-1.0, -3.0}, {{{5.0, 1.0}}}, budget);
  ASSERT_EQ(answer.ended, TangentEnd::found);
  // Tangents from both ends to the circle of 0.5 m about (0, 0), and the arc between.
  const double a = std::sqrt(10.0 - r * r), b = std::sqrt(26.0 - r * r);
  double angle = std::fmod(std::atan2(-3.0, -1.0) - std::atan2(1.0, 5.0) + 4.0 * pi, 2.0 * pi);
  angle = angle - std::acos(r / std::sqrt(10.0)) - std::acos(r / std::sqrt(26.0));
  EXPECT_NEAR(answer.way.length, a + b + r * angle, 1e-9);
  ASSERT_EQ(answer.way.bends.size(), 1U);
  EXPECT_NEAR(answer.way.bends.front().angle, -angle, 1e-9);
  EXPECT_NEAR(norm(answer.way.bends.front().from), 1.0, 1e-12);
}

TEST(TangentGraph, PointsWallsAndRegions) {
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {10, 6})};
  s.map.lines = {{{5.0, 0.0}, {5.0, 4.0}}};
  s.map.points = {{5.0, 5.2}};
  s.vehicle.drive = Differential{0.5};
  s.vehicle.footprint = {{}, 0.1};
  s.start = {1.0, 1.0, 0.0};
  s.mission = FreeGoal{rectangle({8, 0.5}, {9, 5.5})};
  const Problem problem = Problem::prepare(s).value();
  const PlaneSpace space{problem};
  Budget budget;
  // Between the wall's end and the scan point there are 1.2 m.
  const TangentGraph narrow{space, 0.5, 0.4999};
  const TangentAnswer through = narrow.shortest({1.0, 1.0}, target_of(problem, {}), budget);
  ASSERT_EQ(through.ended, TangentEnd::found);
  EXPECT_NEAR(through.way.goal.x, 8.0, 1e-9);
  EXPECT_NEAR(through.way.goal.y, 4.5, 1e-9);  // straight at the region from the top of the circle
  EXPECT_EQ(through.way.bends.size(), 1U);
  const TangentGraph wide{space, 0.65, 0.6499};
  EXPECT_EQ(wide.shortest({1.0, 1.0}, target_of(problem, {}), budget).ended, TangentEnd::unreachable);  // 0.8 m over the point
}

/// Obstacles lie across the edges of goal regions, so that ways end where they slide into one, at no corner of it and not straight at an edge.
TEST(TangentGraph, OfARegionAsOfTheNearestOfManyPlacesOnItsEdge) {
  Random random{43};
  constexpr double spacing = 0.02, radius = 0.3, margin = 0.29999;
  int found = 0, bent = 0, near = 0;
  for (int map = 0; map < 150; ++map) {
    Scenario s = hall(random, 0.2, 6);
    Ring area = convex_hull({{random.uniform(4, 9), random.uniform(3, 7)}, {random.uniform(4, 9), random.uniform(1, 7)}, {random.uniform(4, 9), random.uniform(1, 7)}, {random.uniform(4, 9), random.uniform(1, 7)}});
    // Every second one with a notch.
    if (map % 2 == 0) area.insert(area.begin() + 1, 0.5 * (0.5 * (area[0] + area[1]) + 0.25 * (area[0] + area[1] + area[2] + area.back())));
    s.map.points = {0.5 * (area[0] + area.back()), 0.3 * area[0] + 0.7 * area.back()};
    s.mission = FreeGoal{area};
    const auto prepared = Problem::prepare(s);
    if (!prepared) continue;
    const Problem& problem = *prepared;
    const PlaneSpace space{problem};
    const PlaneTarget target = target_of(problem, {});
    if (target.is_point() || !space.is_free(s.start.position(), 0.31) || contains(area, s.start.position())) continue;
    const TangentGraph graph{space, radius, margin, Rounding::optimistic};
    Budget budget;
    const TangentAnswer answer = graph.shortest(s.start.position(), target, budget);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < area.size(); ++i) {
      const Vec2 a = area[i], b = area[(i + 1) % area.size()];
      const int steps = static_cast<int>(std::ceil(distance(a, b) / spacing));
      for (int k = 0; k < steps; ++k) {
        const Vec2 place = a + (static_cast<double>(k) / steps) * (b - a);
        if (!space.is_free(place, radius)) continue;
        const TangentAnswer there = graph.shortest(s.start.position(), {{place}}, budget);
        if (there.ended == TangentEnd::found) nearest = std::min(nearest, there.way.length);
      }
    }
    if (answer.ended != TangentEnd::found) {
      ASSERT_FALSE(std::isfinite(nearest)) << map;
      continue;
    }
    ASSERT_LE(answer.way.length, nearest + 1e-9) << map;
    // And it is a way to a free place of the region. (Those may miss a narrow one.)
    ASSERT_TRUE(space.is_free(answer.way.goal, margin)) << map;
    ASSERT_LT(distance(target.nearest(answer.way.goal), answer.way.goal), 1e-9) << map;
    ASSERT_NEAR(graph.shortest(s.start.position(), {{answer.way.goal}}, budget).way.length, answer.way.length, 1e-6) << map;
    near += answer.way.length > nearest - 3.0 * spacing ? 1 : 0;
    ++found;
    bent += answer.way.bends.empty() ? 0 : 1;
  }
  EXPECT_GT(found, 60);
  EXPECT_GT(bent, 10);
  EXPECT_GT(near, 9 * found / 10);
}

TEST(LeastLength, ARegionThatAnObstacleShutsWhereItIsNearest) {
  Scenario s;
  s.map.boundaries = {rectangle({-10, -10}, {10, 10})};
  s.map.points = {{0.0, 0.0}};
  s.vehicle.drive = Differential{0.5};
  s.vehicle.footprint = {{}, 0.3};
  s.start = {-3.0, 0.0, 0.0};
  s.mission = FreeGoal{rectangle({-0.15, -5}, {5, 5})};
  const Problem problem = Problem::prepare(s).value();
  Budget budget;
  const LeastLength least = least_length(PlaneSpace{problem}, budget);
  // Straight to where the region's edge is 0.3 m from the point.
  EXPECT_NEAR(least.metres, std::hypot(2.85, std::sqrt(0.3 * 0.3 - 0.15 * 0.15)), 1e-5);
  EXPECT_FALSE(least.is_straight);
}

TEST(LeastLength, SaysWhyItIsOnlyTheStraightLine) {
  Random random{5};
  Scenario s = hall(random, 0.2, 0);
  s.map.obstacles = {rectangle({3, 0.5}, {4, 8}), rectangle({6, 0}, {7, 7})};
  const Problem problem = Problem::prepare(s).value();
  const std::atomic<bool> cancel{true};
  Budget canceled{{}, &cancel}, all;
  const LeastLength straight = least_length(PlaneSpace{problem}, canceled), bent = least_length(PlaneSpace{problem}, all);
  EXPECT_TRUE(straight.is_cut_short);
  EXPECT_NEAR(straight.metres, distance(problem.start().position(), problem.goal().position()), 1e-12);
  EXPECT_NE(bound_sentence(straight, 20.0).find("the budget was over"), std::string::npos);
  EXPECT_FALSE(bent.is_cut_short);
  EXPECT_GT(bent.metres, straight.metres + 1.0);
}

TEST(LeastLength, NoShorterThanStraightAndNoLongerThanWhatIsDriven) {
  Random random{31};
  int bent = 0;
  for (int map = 0; map < 60; ++map) {
    const Scenario s = hall(random, 0.25, 6);
    const Problem problem = Problem::prepare(s).value();
    if (problem.check_ends()) continue;
    const PlaneSpace space{problem};
    Budget budget;
    const LeastLength least = least_length(space, budget);
    EXPECT_GE(least.metres, distance(problem.start().position(), problem.goal().position()) - 1e-12);
    if (!ends_are_free(space, space.needed())) continue;
    const TangentGraph graph{space, space.needed(), space.needed() - 5e-4};
    const TangentAnswer answer = graph.shortest(problem.start().position(), target_of(problem, problem.goal().position()), budget);
    if (answer.ended != TangentEnd::found) continue;
    ASSERT_FALSE(least.is_unreachable);
    EXPECT_LE(least.metres, answer.way.length + 1e-9);
    EXPECT_GE(least.metres, answer.way.length * 0.9) << map;
    bent += answer.way.bends.empty() ? 0 : 1;
  }
  EXPECT_GT(bent, 20);
}

}  // namespace
}  // namespace waywright
