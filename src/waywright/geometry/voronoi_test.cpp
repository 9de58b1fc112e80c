#include "waywright/geometry/voronoi.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "waywright/core/random.hpp"
#include "waywright/geometry/voronoi_noding.hpp"

namespace waywright {
namespace {

void add(std::vector<Segment>& all, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) all.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

/// A rectangle with polygons (some of which overlap), walls (which cross each other and them), and points in it.
std::vector<Segment> clutter(Random& random) {
  std::vector<Segment> all;
  add(all, rectangle({0, 0}, {10, 8}));
  for (int i = 0; i < 4; ++i) {
    Ring points;
    const Vec2 at{random.uniform(1, 9), random.uniform(1, 7)};
    for (int k = 0; k < 6; ++k) points.push_back(at + Vec2{random.uniform(-1, 1), random.uniform(-1, 1)});
    add(all, convex_hull(points));
  }
  for (int i = 0; i < 4; ++i) all.push_back({{random.uniform(0, 10), random.uniform(0, 8)}, {random.uniform(0, 10), random.uniform(0, 8)}});
  for (int i = 0; i < 6; ++i) {
    const Vec2 p{random.uniform(0, 10), random.uniform(0, 8)};
    all.push_back({p, p});
  }
  // What maps have, too: the same wall twice, one on another, an end on a wall, a point on one.
  all.push_back({{2, 1}, {6, 1}});
  all.push_back({{6, 1}, {2, 1}});
  all.push_back({{3, 1}, {8, 1}});
  all.push_back({{4, 1}, {4, 2}});
  all.push_back({{5, 1}, {5, 1}});
  return all;
}

double clearance(const std::vector<Segment>& all, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& s : all) least = std::min(least, point_segment_distance(p, s.a, s.b));
  return least;
}

std::int64_t cross(GridPoint o, GridPoint p, GridPoint q) {
  return (std::int64_t{p.x} - o.x) * (std::int64_t{q.y} - o.y) - (std::int64_t{p.y} - o.y) * (std::int64_t{q.x} - o.x);
}

TEST(VoronoiNoding, WhatIsLeftMeetsAtEndsAloneAndIsTheSame) {
  Random random{3};
  for (int round = 0; round < 60; ++round) {
    // Small coordinates make every kind of touching likely, and cuts that bend much.
    const std::int64_t size = round % 3 == 0 ? 6 : round % 3 == 1 ? 40 : 100'000'000;
    const auto place = [&] { return GridPoint{static_cast<std::int32_t>(random.integer(-size, size)), static_cast<std::int32_t>(random.integer(-size, size))}; };
    std::vector<GridSegment> given;
    for (int i = 0; i < 60; ++i) {
      const GridPoint p = place();
      given.push_back({p, i % 6 == 0 ? p : place()});
    }
    const auto nodes = noded(given);
    ASSERT_TRUE(nodes);
    const auto& s = nodes->segments;
    EXPECT_GT(nodes->rounds, 0);
    for (std::size_t i = 0; i < s.size(); ++i) {
      for (std::size_t k = i + 1; k < s.size(); ++k) {
        ASSERT_NE(s[i], s[k]);
        const std::int64_t ia = cross(s[k].a, s[k].b, s[i].a), ib = cross(s[k].a, s[k].b, s[i].b), ka = cross(s[i].a, s[i].b, s[k].a), kb = cross(s[i].a, s[i].b, s[k].b);
        ASSERT_FALSE(((ia < 0 && ib > 0) || (ia > 0 && ib < 0)) && ((ka < 0 && kb > 0) || (ka > 0 && kb < 0)));
        for (const auto& [line, p, side] : {std::tuple{s[i], s[k].a, ka}, std::tuple{s[i], s[k].b, kb}, std::tuple{s[k], s[i].a, ia}, std::tuple{s[k], s[i].b, ib}}) {
          if (side != 0 || p == line.a || p == line.b || line.a == line.b) continue;
          const bool is_between = std::min(line.a.x, line.b.x) <= p.x && p.x <= std::max(line.a.x, line.b.x) && std::min(line.a.y, line.b.y) <= p.y && p.y <= std::max(line.a.y, line.b.y);
          ASSERT_FALSE(is_between);
        }
        if (s[i].a == s[i].b) {
          ASSERT_TRUE(s[k].a != s[i].a && s[k].b != s[i].a);
        }
      }
    }
    const auto away = [](double share, const GridSegment& of, const std::vector<GridSegment>& from) {
      const Vec2 at{of.a.x + share * (double(of.b.x) - of.a.x), of.a.y + share * (double(of.b.y) - of.a.y)};
      double least = std::numeric_limits<double>::infinity();
      for (const GridSegment& t : from) least = std::min(least, point_segment_distance(at, {double(t.a.x), double(t.a.y)}, {double(t.b.x), double(t.b.y)}));
      return least;
    };
    const double allowed = 0.70711 * nodes->rounds + 1e-6;
    for (const GridSegment& g : given) {
      for (const double share : {0.0, 0.3, 0.77, 1.0}) EXPECT_LE(away(share, g, s), allowed);
    }
    for (const GridSegment& g : s) {
      for (const double share : {0.0, 0.5, 1.0}) EXPECT_LE(away(share, g, given), allowed);
    }
  }
}

TEST(VoronoiDiagram, PlacesAreEquallyFarFromTheTwoNearestAndARidge) {
  Random random{11};
  int curved = 0, straight = 0, ridges = 0;
  for (int map = 0; map < 40; ++map) {
    const std::vector<Segment> all = clutter(random);
    const auto diagram = VoronoiDiagram::of(all);
    ASSERT_TRUE(diagram);
    EXPECT_LT(diagram->error(), 1e-5);
    for (const VoronoiEdge& edge : diagram->edges()) {
      (edge.is_straight() ? straight : curved) += 1;
      const std::vector<VoronoiPlace> places = diagram->places(edge, 0.2, 1e-3);
      ASSERT_EQ(places.front().at, diagram->vertices()[edge.from]);
      ASSERT_EQ(places.back().at, diagram->vertices()[edge.to]);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const VoronoiPlace& p = places[i];
        ASSERT_NEAR(distance(edge.left, p.at), distance(edge.right, p.at), 1e-7);
        ASSERT_NEAR(clearance(all, p.at), p.clearance, diagram->error() + 1e-7) << "map " << map;
        if (i == 0) continue;
        ASSERT_LE(distance(places[i - 1].at, p.at), 0.2 + 1e-9);
        // Half way along the chord it is no farther from the edge than agreed: the clearance differs by that at most.
        const Vec2 half = 0.5 * (places[i - 1].at + p.at);
        ASSERT_LE(std::abs(distance(edge.left, half) - distance(edge.right, half)), 2.0 * 1e-3 + 1e-9);
        if (places[i - 1].clearance < 1e-2 || distance(places[i - 1].at, p.at) < 1e-4) continue;
        if (i + 1 == places.size()) continue;  // beyond a vertex there are other ridges
        const Vec2 to_left = nearest(edge.left, p.at) - p.at, to_right = nearest(edge.right, p.at) - p.at;
        const Vec2 across = (1.0 / norm(to_left - to_right)) * (to_left - to_right);
        const double sharp = norm(to_left - to_right) / (2.0 * p.clearance);  // sine of half the angle between
        const double step = 0.01 * p.clearance * sharp;
        if (step * sharp < 1e-5) continue;
        EXPECT_LT(clearance(all, p.at + step * across), p.clearance - 0.4 * step * sharp);
        EXPECT_LT(clearance(all, p.at - step * across), p.clearance - 0.4 * step * sharp);
        ++ridges;
      }
    }
  }
  EXPECT_GT(curved, 500);
  EXPECT_GT(straight, 500);
  EXPECT_GT(ridges, 2000);
}

TEST(VoronoiDiagram, WhoeverGoesAwayFromTheNearestComesToIt) {
  Random random{29};
  int met = 0;
  for (int map = 0; map < 12; ++map) {
    const std::vector<Segment> all = clutter(random);
    const auto diagram = VoronoiDiagram::of(all);
    ASSERT_TRUE(diagram);
    std::vector<std::pair<Vec2, Vec2>> chords;
    for (const VoronoiEdge& edge : diagram->edges()) {
      const auto places = diagram->places(edge, 1.0, 1e-4);
      for (std::size_t i = 1; i < places.size(); ++i) chords.emplace_back(places[i - 1].at, places[i].at);
    }
    for (int i = 0; i < 300; ++i) {
      const Vec2 p{random.uniform(0, 10), random.uniform(0, 8)};
      Vec2 on{};
      double least = std::numeric_limits<double>::infinity();
      for (const Segment& s : all) {
        Vec2 here{};
        const double d = point_segment_distance(p, s.a, s.b, &here);
        if (d < least) {
          least = d;
          on = here;
        }
      }
      if (least < 1e-2) continue;
      const Vec2 along = (1.0 / least) * (p - on);
      double near = 0.0, far = 20.0;
      for (int k = 0; k < 60; ++k) {
        const double half = 0.5 * (near + far);
        (clearance(all, p + half * along) >= least + half - 1e-7 ? near : far) = half;
      }
      double off = std::numeric_limits<double>::infinity();
      for (const auto& [a, b] : chords) off = std::min(off, point_segment_distance(p + near * along, a, b));
      EXPECT_LT(off, 1e-2) << "map " << map << " from " << p.x << " " << p.y << " to " << near;
      ++met;
    }
  }
  EXPECT_GT(met, 2500);
}

TEST(VoronoiDiagram, AWallAndAPointInClosedForm) {
  std::vector<Segment> all{{{-50, 0}, {50, 0}}, {{3, 2}, {3, 2}}, {{-50, 9}, {50, 9}}};
  const auto diagram = VoronoiDiagram::of(all);
  ASSERT_TRUE(diagram);
  int seen = 0;
  for (const VoronoiEdge& edge : diagram->edges()) {
    if (edge.is_straight()) continue;
    const bool is_low = edge.left.a.y == 0.0 || edge.right.a.y == 0.0;
    for (const VoronoiPlace& p : diagram->places(edge, 0.1, 1e-4)) {
      const double x = p.at.x - 3.0, expected = is_low ? (x * x + 4.0) / 4.0 : 9.0 - (x * x + 49.0) / 14.0;
      EXPECT_NEAR(p.at.y, expected, 1e-5);
      ++seen;
    }
    const Vec2 a = diagram->vertices()[edge.from], b = diagram->vertices()[edge.to];
    const Vec2 control = *control_point(edge, a, b);
    const Vec2 half = 0.25 * (a + b) + 0.5 * control;  // of the Bézier curve
    EXPECT_NEAR(distance(edge.left, half), distance(edge.right, half), 1e-9);
  }
  EXPECT_GT(seen, 20);
}

TEST(VoronoiDiagram, FlatBlindEndsAreNoEdges) {
  // A long wall in hundreds of pieces, turned so that rounding bends it at each.
  std::vector<Segment> all;
  const Vec2 along = {0.8191520442889918, 0.573576436351046};
  const int pieces = 300;
  for (const double side : {0.0, 2.0}) {
    for (int i = 0; i < pieces; ++i) all.push_back({(0.1 * i) * along + side * left_of(along), (0.1 * (i + 1)) * along + side * left_of(along)});
  }
  const auto diagram = VoronoiDiagram::of(all);
  ASSERT_TRUE(diagram);
  double length = 0.0;
  for (const VoronoiEdge& edge : diagram->edges()) {
    const double off = std::abs(dot(diagram->vertices()[edge.from], left_of(along)) - 1.0);
    EXPECT_LT(off, 1e-3);
    length += distance(diagram->vertices()[edge.from], diagram->vertices()[edge.to]);
  }
  EXPECT_NEAR(length, 30.0, 0.5);
  EXPECT_TRUE(VoronoiDiagram::of({})->edges().empty());
}

}  // namespace
}  // namespace waywright
