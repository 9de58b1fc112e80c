#include "waywright/metrics/metrics.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "waywright/curve/bezier.hpp"
#include "waywright/map/world.hpp"

namespace waywright {
namespace {

constexpr double tolerance = 0.0005;  // m

World world_of(const Map& map) {
  World world{map};
  world.build();
  return world;
}

Metrics measured(const Path& path, const World& world, const Footprint& footprint) {
  const auto samples = sample(path, footprint.radius(), tolerance);
  return measure(path, samples, clearances(samples, [&](const Sample& at) { return world.clearance(footprint, at.pose(), clearance_cap).clearance; }));
}

Metrics measured(const Path& path) {
  return measured(path, world_of({}), Footprint{.polygon = {}, .disc = 0.5});
}

Path line_path(Vec2 from, Vec2 to, int direction = 1) { return {{{Line{from, to}, direction}}}; }

/// The station of the docking publication as reconstructed: transition at (x, y) in the shelf's frame.
Path published_pattern(double x, double y) {
  const Vec2 start{8, 0}, transition{x, y}, dock{0.5, 0};
  const Vec2 fork{0, y > 0 ? -1.0 : 1.0};  // at the transition the forks look at the shelf's axis
  const Vec2 away = transition + 1.0 * fork;
  const std::array<Vec2, 4> first{start, start - Vec2{1.0, 0}, away, transition};
  const std::array<Vec2, 4> second{transition, away, dock + Vec2{1.5, 0}, dock};
  return {{{Spline{SplineKind::natural_cubic, natural_cubic(first)}, -1},
           {Spline{SplineKind::natural_cubic, natural_cubic(second)}, 1}}};
}

TEST(Metrics, StraightLine) {
  const Metrics m = measured(line_path({1, 1}, {4, 5}));
  EXPECT_DOUBLE_EQ(m.length, 5.0);
  EXPECT_EQ(m.max_curvature, 0.0);
  EXPECT_EQ(m.max_curvature_rate, 0.0);
  EXPECT_EQ(m.curvature_change, 0.0);
  EXPECT_EQ(m.curvature_change_printed, 0.0);
  EXPECT_EQ(m.turning, 0.0);
  EXPECT_EQ(m.direction_changes, 0);
  EXPECT_EQ(m.min_clearance, clearance_cap);  // nothing in the world
  EXPECT_DOUBLE_EQ(m.mean_clearance, clearance_cap);
  EXPECT_LT(m.collision_risk, 1e-80);
}

TEST(Metrics, QuarterCircle) {
  const double radius = 2.0;
  const Path path{{{Arc{Pose{0, 0, 0}, -1.0 / radius, radius * pi / 2}, 1}}};
  const Metrics m = measured(path);
  EXPECT_NEAR(m.length, pi, 1e-12);
  EXPECT_NEAR(m.max_curvature, 0.5, 1e-15);
  EXPECT_NEAR(m.curvature_change, 0.0, 1e-12);
  EXPECT_NEAR(m.curvature_change_printed, 0.0, 1e-9);
  EXPECT_NEAR(m.turning, pi / 2, 1e-12);
}

TEST(Metrics, LineIntoArcCountsTheJumpInThePrintedFormOnly) {
  // 2 m straight, 1 m left with radius 2 m, 2 m straight: κ goes 0 → 0.5 → 0.
  Path path = line_path({0, 0}, {2, 0});
  path.pieces.push_back({Arc{Pose{2, 0, 0}, 0.5, 1.0}, 1});
  const Pose end = end_pose(path);
  path.pieces.push_back({Line{end.position(), end.position() + 2.0 * unit(end.heading)}, 1});
  const Metrics m = measured(path);
  EXPECT_NEAR(m.length, 5.0, 1e-12);
  EXPECT_NEAR(m.curvature_change, 0.0, 1e-12);  // inside each piece there is none
  EXPECT_NEAR(m.curvature_change_printed, 1.0 / 0.05, 1e-9);
  EXPECT_NEAR(m.turning, 0.5, 1e-12);
  EXPECT_EQ(m.direction_changes, 0);
}

TEST(Metrics, PosesOfTheSamePathMeasureTheSame) {
  Path path{{{Arc{Pose{0, 0, 0}, 0.5, 1.0}, 1}, {Arc{Pose{}, -0.4, 1.5}, 1}}};
  std::get<Arc>(path.pieces[1].curve).start = end_pose(path.pieces[0]);
  PoseSequence poses;
  for (const Sample& s : sample(path, 1.0, tolerance, 0.01)) poses.poses.push_back(s.pose());
  const Metrics curves = measured(path);
  const Metrics outside = measured(Path{{{poses, 1}}});
  EXPECT_NEAR(outside.length, curves.length, 1e-4);
  EXPECT_NEAR(curves.curvature_change, 0.0, 1e-12);
  EXPECT_NEAR(outside.curvature_change, 0.9, 1e-4);  // of one piece
  EXPECT_NEAR(outside.turning, curves.turning, 1e-9);
  EXPECT_NEAR(outside.curvature_change_printed, curves.curvature_change_printed, 0.01);
}

TEST(Metrics, ChangeOfDirectionIsCountedAndNotCurvature) {
  // There on a left arc and back on the same arc: travel's curvature changes sign where the vehicle stands.
  Path path{{{Arc{Pose{0, 0, 0}, 0.5, 1.0}, 1}}};
  Pose end = end_pose(path);
  path.pieces.push_back({Arc{Pose{end.x, end.y, wrap(end.heading + pi)}, -0.5, 1.0}, -1});
  const Metrics m = measured(path);
  EXPECT_EQ(m.direction_changes, 1);
  EXPECT_NEAR(m.curvature_change, 0.0, 1e-12);
  EXPECT_NEAR(m.curvature_change_printed, 0.0, 1e-9);
  EXPECT_NEAR(m.turning, 1.0, 1e-12);
  EXPECT_NEAR(end_pose(path).x, 0.0, 1e-12);
}

TEST(Metrics, TurnsOnTheSpotTurnButChangeNoDirection) {
  Path path = line_path({0, 0}, {1, 0});
  path.pieces.push_back({Turn{{1, 0}, 0.0, 1.2}, 0});
  path.pieces.push_back({Line{{1, 0}, Vec2{1, 0} + unit(1.2)}, 1});
  Metrics m = measured(path);
  EXPECT_EQ(m.direction_changes, 0);
  EXPECT_NEAR(m.turning, 1.2, 1e-12);
  EXPECT_NEAR(m.length, 2.0, 1e-12);
  path.pieces[2] = {Line{{1, 0}, Vec2{1, 0} - unit(1.2)}, -1};
  m = measured(path);
  EXPECT_EQ(m.direction_changes, 1);

  Map map;
  map.points = {{3, 0}};
  const Path turn{{{Turn{{0, 0}, 0.0, 4.0}, 0}}};
  m = measured(turn, world_of(map), Footprint{.polygon = {}, .disc = 0.5});
  EXPECT_EQ(m.length, 0.0);
  EXPECT_NEAR(m.turning, 4.0, 1e-12);
  EXPECT_NEAR(m.mean_clearance, 2.5, 1e-12);
  EXPECT_EQ(m.collision_risk, 0.0);
}

TEST(Metrics, ClearanceBesideAWall) {
  // A disc of 0.5 m drives towards a wall at x = 6: clearance falls from 5.5 to 0.5 m, 3 m on average.
  Map map;
  map.lines = {{{6, -50}, {6, 50}}};
  const Metrics m = measured(line_path({0, 0}, {5, 0}), world_of(map), Footprint{.polygon = {}, .disc = 0.5});
  EXPECT_NEAR(m.min_clearance, 0.5, 1e-12);
  EXPECT_NEAR(m.mean_clearance, 3.0, 1e-12);
  // ∫ exp(−½(d/q)²) dd from 0.5 to 5.5 with q = 0.5: q·√(π/2)·(erf(11/√2) − erf(1/√2))
  const double exact =
      0.5 * std::sqrt(pi / 2) * (std::erf(11 / std::sqrt(2.0)) - std::erf(1 / std::sqrt(2.0)));
  EXPECT_NEAR(m.collision_risk, exact, 2e-3 * exact);  // trapezoids of 0.05 m
}

TEST(Metrics, ContactIsNoClearance) {
  Map map;
  map.obstacles = {rectangle({2, -1}, {3, 1})};
  const Footprint footprint{.polygon = rectangle({-0.5, -0.4}, {1.0, 0.4}), .disc = 0.0};
  const auto samples = sample(line_path({0, 0}, {5, 0}), footprint.radius(), tolerance);
  const World world = world_of(map);
  const auto found = clearances(samples, [&](const Sample& at) { return world.clearance(footprint, at.pose(), clearance_cap).clearance; });
  ASSERT_EQ(found.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double front = 2.0 - (samples[i].x + 1.0);
    const double rear = samples[i].x - 0.5 - 3.0;
    EXPECT_NEAR(found[i], std::max({0.0, front, rear}), 1e-12) << samples[i].x;
  }
}

TEST(Metrics, NothingToMeasure) {
  const Metrics m = measure(Path{}, {}, {});
  EXPECT_EQ(m.length, 0.0);
  EXPECT_EQ(m.travel_time, 0.0);
}

// The ten transition points of the reconstructed station, measured there 0.05 m apart: length to 0.1 %, total
// variation to 1 %. Samples of ours lie closer in tight bends and on the knots, and see peaks that 0.05 m step
// over, by up to 2.5 % at a radius of half a metre.
TEST(Metrics, PublishedPatternPaths) {
  struct Row {
    double x, y, length, change, curvature;
  };
  for (const Row& row : {Row{4.0, 3.5, 12.033, 2.461, 0.533}, Row{4.5, 3.8, 12.464, 2.324, 0.487},
                         Row{5.0, 4.5, 13.683, 2.383, 0.680}, Row{3.0, 3.0, 11.614, 3.431, 1.014},
                         Row{2.0, 2.5, 11.660, 8.147, 3.018}, Row{2.5, 4.5, 14.310, 3.855, 1.368},
                         Row{6.5, 4.0, 13.485, 4.392, 1.599}, Row{6.5, 2.5, 11.219, 5.495, 1.914},
                         Row{4.0, 2.5, 10.692, 3.405, 0.869}, Row{3.5, 4.5, 13.801, 2.578, 0.799}}) {
    for (const double side : {1.0, -1.0}) {
      const Metrics m = measured(published_pattern(row.x, side * row.y));
      EXPECT_NEAR(m.length, row.length, 1e-3 * row.length) << row.x << ", " << row.y;
      EXPECT_NEAR(m.curvature_change_printed * 0.05, row.change, 1e-2 * row.change) << row.x << ", " << row.y;
      EXPECT_GT(m.curvature_change, 0.99 * row.change) << row.x << ", " << row.y;
      EXPECT_LT(m.curvature_change, 1.02 * row.change) << row.x << ", " << row.y;
      EXPECT_GT(m.max_curvature, 0.99 * row.curvature) << row.x << ", " << row.y;
      EXPECT_LT(m.max_curvature, 1.025 * row.curvature) << row.x << ", " << row.y;
      EXPECT_EQ(m.direction_changes, 1);
    }
  }
}

TEST(Metrics, PrintedFormOfThePublishedReference) {
  const Path path = published_pattern(4.0, 3.5);
  const Metrics m = measured(path);
  EXPECT_NEAR(m.curvature_change_printed, 49.3, 0.5);
  // The published form has the unit 1/m² and is the total variation over the step.
  EXPECT_NEAR(m.curvature_change_printed * 0.05, m.curvature_change, 0.01 * m.curvature_change);
}

TEST(Metrics, ChangeOfCurvatureDoesNotDependOnTheSamples) {
  const Path path = published_pattern(4.0, 3.5);
  const auto coarse = sample(path, 2.3, 1.0, 0.05);
  const auto fine = sample(path, 2.3, 1.0, 0.0125);
  ASSERT_GT(fine.size(), 3 * coarse.size());
  const Metrics a = measure(path, coarse, std::vector<double>(coarse.size(), 1.0));
  const Metrics b = measure(path, fine, std::vector<double>(fine.size(), 1.0));
  EXPECT_NEAR(a.curvature_change, b.curvature_change, 0.01 * b.curvature_change);
  EXPECT_EQ(a.curvature_change_printed, b.curvature_change_printed);
  EXPECT_NEAR(a.turning, b.turning, 1e-3);
}

}  // namespace
}  // namespace waywright
