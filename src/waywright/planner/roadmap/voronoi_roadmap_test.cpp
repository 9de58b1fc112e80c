#include "waywright/planner/roadmap/voronoi_roadmap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "waywright/core/random.hpp"
#include "waywright/planner/plane/plane_ends.hpp"
#include "waywright/planner/roadmap/least_length.hpp"
#include "waywright/planner/roadmap/path_pencil.hpp"
#include "waywright/planner/roadmap/tangent_graph.hpp"

namespace waywright {
namespace {

/// Polygons that may overlap, walls and points; bounded or not.
Scenario clutter(Random& random, double disc, bool is_bounded) {
  Scenario s;
  if (is_bounded) s.map.boundaries = {{{0, 0}, {10, 0}, {11, 4}, {10, 8}, {0, 8}}};
  const int boxes = static_cast<int>(random.integer(2, 8));
  for (int i = 0; i < boxes; ++i) {
    Ring points;
    const Vec2 at{random.uniform(0.5, 9.5), random.uniform(0.5, 7.5)};
    for (int k = 0; k < 6; ++k) points.push_back(at + Vec2{random.uniform(-1, 1), random.uniform(-1, 1)});
    s.map.obstacles.push_back(convex_hull(points));
  }
  s.map.lines = {{{3.0, 3.0}, {4.0, 5.5}, {6.0, 5.0}}};
  for (int i = 0; i < 3; ++i) s.map.points.push_back({random.uniform(0, 10), random.uniform(0, 8)});
  s.vehicle.footprint = {{}, disc};
  s.vehicle.drive = Differential{0.5};
  s.start = {0.6, 0.6, 0.0};
  s.mission = Pose{9.4, 7.4, 0.0};
  return s;
}

/// To everything in the map, looked at one by one, and to the frame.
double by_hand(const Scenario& s, const VoronoiRoadmap& roadmap, const PlaneSpace& space, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  const auto ring = [&](const Ring& r) {
    for (std::size_t i = 0; i < r.size(); ++i) least = std::min(least, point_segment_distance(p, r[i], r[(i + 1) % r.size()]));
  };
  for (const Ring& r : s.map.obstacles) ring(r);
  for (const Ring& r : s.map.boundaries) ring(r);
  for (const Polyline& line : s.map.lines) {
    for (std::size_t i = 1; i < line.size(); ++i) least = std::min(least, point_segment_distance(p, line[i - 1], line[i]));
  }
  for (const Vec2 q : s.map.points) least = std::min(least, distance(p, q));
  if (roadmap.has_frame()) ring(rectangle(space.region().low, space.region().high));
  return least;
}

Vec2 bezier(Vec2 a, Vec2 c, Vec2 b, double u) { return (1 - u) * (1 - u) * a + 2 * u * (1 - u) * c + u * u * b; }

/// Sources of what is nearest to p from different directions: how wide the widest angle is between two of the nearest places, as seen from p.
double widest_angle(const VoronoiRoadmap& roadmap, Vec2 p, double clearance) {
  std::vector<Vec2> directions;
  for (const Segment& s : roadmap.sites().segments()) {
    Vec2 on{};
    if (point_segment_distance(p, s.a, s.b, &on) <= clearance + 1e-4) directions.push_back((1.0 / distance(on, p)) * (on - p));
  }
  double widest = 0.0;
  for (const Vec2 a : directions) {
    for (const Vec2 b : directions) widest = std::max(widest, std::acos(std::clamp(dot(a, b), -1.0, 1.0)));
  }
  return widest;
}

TEST(VoronoiRoadmap, WaysAreOnRidgesOfTheClearance) {
  Random random{7};
  int found = 0, places = 0, curved = 0;
  for (int map = 0; map < 60; ++map) {
    const Scenario s = clutter(random, 0.15, map % 3 != 0);
    const Problem problem = Problem::prepare(s).value();
    if (problem.check_ends()) continue;
    const PlaneSpace space{problem};
    if (!space.is_free(problem.start().position()) || !space.is_free(problem.goal().position())) continue;
    const VoronoiRoadmap roadmap{space};
    ASSERT_TRUE(roadmap.refusal().empty());
    EXPECT_EQ(roadmap.has_frame(), map % 3 == 0);
    Budget budget;
    const VoronoiAnswer answer = roadmap.shortest(problem.start().position(), {{problem.goal().position()}}, 0.0, budget);
    if (answer.ended != VoronoiEnd::found) continue;
    ++found;
    EXPECT_EQ(answer.way.front().at, problem.start().position());
    EXPECT_EQ(answer.way.back().at, problem.goal().position());
    for (std::size_t i = 1; i < answer.way.size(); ++i) {
      const VoronoiStep& step = answer.way[i];
      const Vec2 from = answer.way[i - 1].at;
      if (!step.is_on_diagram) {
        EXPECT_TRUE(space.is_free(from, step.at));
        continue;
      }
      curved += step.control ? 1 : 0;
      for (const double u : {0.1, 0.35, 0.5, 0.8}) {
        const Vec2 p = step.control ? bezier(from, *step.control, step.at, u) : from + u * (step.at - from);
        const double clearance = by_hand(s, roadmap, space, p);
        EXPECT_GT(clearance, space.needed() - 1e-9);
        EXPECT_GE(clearance, step.clearance - 1e-5);
        ASSERT_NEAR(roadmap.clearance(p), clearance, 1e-9);
        // Two of what is nearest are equally far, in different directions, and across the way it falls to both sides.
        const double angle = widest_angle(roadmap, p, clearance);
        ASSERT_GT(angle, 0.5 * VoronoiDiagram::flat) << "map " << map;
        if (distance(from, step.at) < 0.05 || angle < 0.2) continue;
        const Vec2 tangent = step.control ? (1 - u) * (*step.control - from) + u * (step.at - *step.control) : step.at - from;
        const Vec2 across = (1.0 / norm(tangent)) * left_of(tangent);
        const double off = 1e-3, fall = 0.5 * off * std::sin(0.5 * angle);
        EXPECT_LT(by_hand(s, roadmap, space, p + off * across), clearance - fall);
        EXPECT_LT(by_hand(s, roadmap, space, p - off * across), clearance - fall);
        ++places;
      }
    }
  }
  EXPECT_GT(found, 30);
  EXPECT_GT(places, 400);
  EXPECT_GT(curved, 50);
}

TEST(VoronoiRoadmap, AWayIsFoundWhereverTheDiscFitsThroughAndThereIsOne) {
  Random random{41};
  int found = 0, none = 0;
  for (int map = 0; map < 250; ++map) {
    Scenario s = clutter(random, 0.05 + 0.15 * (map % 5), map % 4 != 0);
    if (map % 2 == 0) {  // a wall across, with a gap
      const double x = random.uniform(3, 7), y = random.uniform(0, 7), gap = random.uniform(0.0, 1.5);
      s.map.lines.push_back({{x, -0.5}, {x, y}});
      s.map.lines.push_back({{x, y + gap}, {x, 8.5}});
    }
    // Anywhere, also in corners and beside obstacles.
    const auto place = [&] { return Vec2{random.uniform(0.1, 9.9), random.uniform(0.1, 7.9)}; };
    const Vec2 a = place(), b = place();
    s.start = {a.x, a.y, 0.0};
    s.mission = Pose{b.x, b.y, 0.0};
    const Problem problem = Problem::prepare(s).value();
    if (problem.check_ends()) continue;
    const PlaneSpace space{problem};
    const double wider = space.needed() + 3.0 * VoronoiRoadmap::sagitta;
    if (!space.is_free(a, wider) || !space.is_free(b, wider)) continue;
    const VoronoiRoadmap roadmap{space};
    Budget budget;
    const VoronoiAnswer answer = roadmap.shortest(a, {{b}}, map % 2 == 0 ? 0.0 : 2.0, budget);
    const TangentGraph graph{space, wider, wider - 1e-6}, exact{space, space.needed(), space.needed() - 5e-4, Rounding::optimistic};
    if (graph.shortest(a, {{b}}, budget).ended == TangentEnd::found) {
      ASSERT_EQ(answer.ended, VoronoiEnd::found) << "map " << map << " " << a.x << " " << a.y << " to " << b.x << " " << b.y;
      ++found;
    }
    if (exact.shortest(a, {{b}}, budget).ended == TangentEnd::unreachable) {
      EXPECT_NE(answer.ended, VoronoiEnd::found) << "map " << map;
      ++none;
    }
  }
  EXPECT_GT(found, 40);
  EXPECT_GT(none, 5);
}

TEST(VoronoiRoadmap, MoreWeightOnClearanceIsNoShorterAndAClosedFormIsMet) {
  // A corridor 0.6 m wide straight on, and 2 m of room all around the block.
  Scenario s;
  s.map.boundaries = {rectangle({0, 0}, {10, 6})};
  s.map.obstacles = {rectangle({2, 0.6}, {8, 4})};
  s.vehicle.footprint = {{}, 0.2};
  s.vehicle.drive = Differential{0.5};
  s.start = {0.5, 0.5, 0.0};
  s.mission = Pose{9.5, 0.5, 0.0};
  const Problem problem = Problem::prepare(s).value();
  const PlaneSpace space{problem};
  const VoronoiRoadmap roadmap{space};
  Budget budget;
  const auto highest = [&](double weight) {
    const VoronoiAnswer answer = roadmap.shortest({0.5, 0.5}, {{{9.5, 0.5}}}, weight, budget);
    EXPECT_EQ(answer.ended, VoronoiEnd::found);
    double y = 0.0;
    for (const VoronoiStep& step : answer.way) y = std::max(y, step.at.y);
    return y;
  };
  EXPECT_LT(highest(0.0), 1.1);
  EXPECT_NEAR(highest(20.0), 5.0, 1e-3);  // half way between the block and the wall
  // The corridor below: 0.3 m from both sides.
  const VoronoiAnswer low = roadmap.shortest({0.5, 0.5}, {{{9.5, 0.5}}}, 0.0, budget);
  bool is_seen = false;
  for (const VoronoiStep& step : low.way) is_seen = is_seen || std::abs(step.clearance - 0.3) < 1e-5;
  EXPECT_TRUE(is_seen);
  // Goals that are regions: one that holds a part of the diagram, and one in a corner that holds none.
  for (const Ring& region : {rectangle({8.5, 4.2}, {9.9, 5.9}), rectangle({9.3, 0.25}, {9.7, 0.6})}) {
    const VoronoiAnswer answer = roadmap.shortest({0.5, 0.5}, {region}, 0.0, budget);
    ASSERT_EQ(answer.ended, VoronoiEnd::found);
    EXPECT_TRUE(contains(region, answer.way.back().at));
  }
  EXPECT_EQ(roadmap.shortest({0.5, 0.5}, {{{9.5, 0.5}}}, 0.0, budget, 3).ended, VoronoiEnd::expansions);
  std::atomic<bool> flag{true};
  Budget canceled{{}, &flag};
  EXPECT_EQ(roadmap.shortest({0.5, 0.5}, {{{9.5, 0.5}}}, 0.0, canceled).ended, VoronoiEnd::stopped);
}

TEST(PathPencil, CurvesAndTheirChords) {
  const Vec2 a{0, 0}, c{1, 2}, b{3, 1};
  double greatest = 0.0;
  for (int i = 0; i <= 10'000; ++i) {
    const double u = i / 10'000.0;
    const Vec2 d1 = 2.0 * ((1 - u) * (c - a) + u * (b - c)), d2 = 2.0 * (b - 2.0 * c + a);
    greatest = std::max(greatest, std::abs(cross(d1, d2)) / std::pow(norm(d1), 3.0));
  }
  EXPECT_NEAR(greatest_curvature(a, c, b), greatest, 1e-6);
  std::vector<Vec2> points{a};
  add_chords(a, c, b, 1e-3, points);
  EXPECT_EQ(points.back(), b);
  for (int i = 0; i <= 1000; ++i) {
    double off = 1.0;
    for (std::size_t k = 1; k < points.size(); ++k) off = std::min(off, point_segment_distance(bezier(a, c, b, i / 1000.0), points[k - 1], points[k]));
    EXPECT_LE(off, 1e-3);
  }
  PathPencil pencil{{0, 0, 0}};
  pencil.curve(c, b);
  pencil.line({5, 0}, 1);  // goes on where the curve points: no turn
  const Path path = pencil.take();
  ASSERT_EQ(path.pieces.size(), 3U);
  EXPECT_NEAR(distance(end_pose(path).position(), Vec2{5, 0}), 0.0, 1e-12);
}

}  // namespace
}  // namespace waywright
