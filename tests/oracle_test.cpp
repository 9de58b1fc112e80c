// The oracle against hand-computed places, and the world's clearance and the path's samples against the
// oracle.
#include "tests/oracle/brute_force.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "waywright/core/random.hpp"
#include "waywright/curve/bezier.hpp"
#include "waywright/map/world.hpp"

namespace waywright {
namespace {

Footprint forklift() { return {.polygon = rectangle({-2.3, -0.45}, {0.4, 0.45}), .disc = 0.0}; }
Footprint disc(double radius) { return {.polygon = {}, .disc = radius}; }

double clearance(const Map& map, const Footprint& footprint, const Pose& pose) {
  return oracle_clearance(map, {}, {}, footprint, pose);
}

TEST(Oracle, HandComputedPlaces) {
  EXPECT_EQ(clearance({}, forklift(), {0, 0, 0}), oracle_cap);
  Map map;
  map.points = {{3.4, 4.45}};
  EXPECT_NEAR(clearance(map, forklift(), {0, 0, 0}), 5.0, 1e-12);
  EXPECT_NEAR(clearance(map, forklift(), {3.4, 4.45, 1.0}), 0.0, 1e-12);
  EXPECT_NEAR(clearance(map, disc(0.5), {3.4, 2.0, 1.0}), 1.95, 1e-12);

  map = {};
  map.obstacles = {rectangle({-10, -10}, {10, 10})};
  EXPECT_EQ(clearance(map, forklift(), {0, 0, 0.3}), 0.0);  // wholly within what is solid
  EXPECT_EQ(clearance(map, disc(0.1), {0, 0, 0}), 0.0);
  EXPECT_NEAR(clearance(map, forklift(), {10.45 + 1.5, 0, pi / 2}), 1.5, 1e-12);

  map = {};
  map.boundaries = {rectangle({-10, -10}, {10, 10})};
  EXPECT_NEAR(clearance(map, forklift(), {0, 0, 0}), 7.7, 1e-12);
  EXPECT_EQ(clearance(map, forklift(), {20, 0, 0}), 0.0);
  EXPECT_EQ(clearance(map, forklift(), {9.7, 0, 0}), 0.0);
  EXPECT_EQ(oracle_clearance({}, map.boundaries, {}, disc(1), {9.5, 0, 0}), 0.0);
  EXPECT_NEAR(oracle_clearance({}, map.boundaries, {rectangle({1, -1}, {2, 1})}, disc(0.25), {0, 0, 0}), 0.75,
              1e-12);

  map = {};
  map.lines = {{{0.4, -5}, {0.4, 5}}};
  EXPECT_EQ(clearance(map, forklift(), {0, 0, 0}), 0.0);  // touching
  EXPECT_NEAR(clearance(map, forklift(), {-0.25, 0, 0}), 0.25, 1e-12);
}

TEST(Oracle, CellsAreSquares) {
  Map map;
  CellGrid grid;
  grid.columns = 4;
  grid.rows = 3;
  grid.cell = 0.5;
  grid.origin = {10, 20, 0};
  grid.blocked.assign(12, 0);
  grid.blocked[1 * 4 + 2] = 2;  // column 2, middle row: [11, 11.5] × [20.5, 21]
  grid.bounds = false;
  map.grids = {grid};
  EXPECT_NEAR(clearance(map, disc(0.1), {10.5, 20.75, 0}), 0.4, 1e-12);
  EXPECT_NEAR(clearance(map, disc(0.0), {11.8, 21.4, 0}), 0.5, 1e-12);
  EXPECT_EQ(clearance(map, disc(0.0), {11.2, 20.7, 0}), 0.0);
  EXPECT_NEAR(clearance(map, disc(0.1), {8, 20.75, 0}), 2.9, 1e-12);
  map.grids[0].bounds = true;
  EXPECT_EQ(clearance(map, disc(0.1), {8, 20.75, 0}), 0.0);
  EXPECT_NEAR(clearance(map, disc(0.1), {10.3, 20.75, 0}), 0.2, 1e-12);
  // The same turned by a quarter: the grid's x axis is the world's y axis.
  map.grids[0].origin = {0, 0, pi / 2};
  EXPECT_NEAR(clearance(map, disc(0.1), {-0.75, 0.5, 0}), 0.4, 1e-12);
}

Ring random_ring(Random& random, Vec2 centre) {
  Ring ring;
  const auto n = random.integer(3, 8);
  for (std::int64_t i = 0; i < n; ++i) {
    const double angle =
        two_pi * (static_cast<double>(i) + random.uniform(0.1, 0.9)) / static_cast<double>(n);
    ring.push_back(centre + random.uniform(0.2, 1.5) * unit(angle));
  }
  return ring;
}

Map random_map(Random& random, bool grids) {
  const auto anywhere = [&] { return Vec2{random.uniform(-8, 8), random.uniform(-8, 8)}; };
  Map map;
  if (random.uniform() < 0.5)
    map.boundaries = {transformed(rectangle({-9, -9}, {9, 9}), Frame{Pose{0, 0, random.uniform(-1, 1)}})};
  for (int i = 0; i < 4; ++i) map.obstacles.push_back(random_ring(random, anywhere()));
  for (int i = 0; i < 2; ++i) map.lines.push_back({anywhere(), anywhere()});
  for (int i = 0; i < 10; ++i) map.points.push_back(anywhere());
  if (!grids) return map;
  CellGrid grid;
  grid.columns = 60;
  grid.rows = 50;
  grid.cell = 0.25;
  grid.origin = {random.uniform(-9, -5), random.uniform(-9, -5), random.uniform(-0.4, 0.4)};
  grid.bounds = random.uniform() < 0.3;
  for (int i = 0; i < grid.columns * grid.rows; ++i) grid.blocked.push_back(random.uniform() < 0.01 ? 1 : 0);
  map.grids = {grid};
  return map;
}

TEST(Oracle, TheWorldSaysTheSame) {
  Random random{31};
  int free = 0;
  int blocked = 0;
  for (int i = 0; i < 200; ++i) {
    const Map map = random_map(random, i % 2 == 0);
    World world{map};
    world.build();
    const Footprint footprint = random.uniform() < 0.3 ? disc(random.uniform(0, 0.6))
                                : random.uniform() < 0.5
                                    ? Footprint{.polygon = rectangle({-1.0, -0.3}, {0.2, 0.3}), .disc = 0.0}
                                    : Footprint{.polygon = random_ring(random, {0, 0}), .disc = 0.0};
    for (int k = 0; k < 40; ++k) {
      const Pose pose{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-pi, pi)};
      const double expected = clearance(map, footprint, pose);
      const double found = std::min(oracle_cap, world.clearance(footprint, pose, oracle_cap).clearance);
      ASSERT_NEAR(found, expected, 1e-9)
          << "map " << i << ", pose " << k << ": " << pose.x << ", " << pose.y << ", " << pose.heading;
      ASSERT_EQ(world.is_free(footprint, pose, 0.0), expected > 0.0);
      (expected > 0.0 ? free : blocked) += 1;
    }
  }
  EXPECT_GT(free, 1000);
  EXPECT_GT(blocked, 1000);
}

Path mixed_path() {
  Path path;
  path.pieces.push_back({Line{{0, 0}, {1, 0.5}}, 1});
  Pose end = end_pose(path);
  path.pieces.push_back({Arc{end, -0.7, 2.0}, 1});
  end = end_pose(path);
  path.pieces.push_back({Turn{end.position(), end.heading, -1.4}, 0});
  end = end_pose(path);
  const Vec2 back = -1.0 * unit(end.heading);
  const BezierSpan span =
      straight_ended_quintic(end.position(), 3.0 * back, end.position() + Vec2{2, 2}, {3, 0.5});
  path.pieces.push_back({Spline{SplineKind::quintic, {span}}, -1});
  end = end_pose(path);
  path.pieces.push_back(
      {PoseSequence{{end, {end.x + 1, end.y, end.heading + 0.3}, {end.x + 2, end.y + 1, end.heading}}}, 1});
  return path;
}

TEST(Oracle, PosesLieOnThePath) {
  const Path path = mixed_path();
  const Footprint footprint = forklift();
  constexpr double step = 0.002;
  const auto poses = oracle_poses(path, footprint, step);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double moved = distance(poses[i].position(), poses[i - 1].position());
    ASSERT_LE(moved + footprint.radius() * std::abs(shorter_turn(poses[i - 1].heading, poses[i].heading)),
              step + 1e-9);
  }
  // Each sample of the path is met by a pose of the oracle, in order.
  std::size_t k = 0;
  for (const Sample& sample : sample(path, footprint.radius(), 1e-4)) {
    const auto off = [&](const Pose& p) {
      return distance(p.position(), sample.pose().position()) +
             footprint.radius() * std::abs(shorter_turn(p.heading, sample.heading));
    };
    std::size_t best = k;
    for (std::size_t j = k; j < poses.size() && j < k + 2000; ++j) {
      if (off(poses[j]) < off(poses[best])) best = j;
    }
    k = best;
    ASSERT_LE(off(poses[k]), step) << "s = " << sample.s;
  }
  EXPECT_GT(k + 2, poses.size());
}

TEST(Oracle, LeastClearanceAlongAPath) {
  // Past a point: 0.45 m half width, the point 1 m beside.
  Map map;
  map.points = {{5, 1}, {5, -1.2}};
  Pose tightest;
  const Path line{{{Line{{0, 0}, {10, 0}}, 1}}};
  EXPECT_NEAR(oracle_path_clearance(map, {}, {}, forklift(), line, 0.001, &tightest), 0.55, 1e-12);
  EXPECT_EQ(oracle_path_clearance(map, {}, {rectangle({6, 0.4}, {7, 2})}, forklift(), line), 0.0);
  // The rear corners of a turn on the spot sweep a circle, from −x over −y to +x.
  map.points = {{0, -3}};
  const Path turn{{{Turn{{0, 0}, 0.0, pi}, 0}}};
  EXPECT_NEAR(oracle_path_clearance(map, {}, {}, forklift(), turn, 0.001), 3.0 - std::hypot(2.3, 0.45),
              0.001);
}

TEST(Oracle, FifteenMetresAtAMillimetreAreQuick) {
  Random random{33};
  Map map;
  map.boundaries = {rectangle({-8, -8}, {14, 14})};
  Path path;
  const BezierSpan span = straight_ended_quintic({0, 0}, {12, 0}, {6, 9}, {0, 12});
  path.pieces.push_back({Spline{SplineKind::quintic, {span}}, 1});
  path.pieces.push_back({Line{{6, 9}, {6, 12}}, 1});
  const auto poses = oracle_poses(path, forklift(), 0.5);
  const auto clear_place = [&] {
    while (true) {
      const Vec2 p{random.uniform(-7, 13), random.uniform(-7, 13)};
      bool clear = true;
      for (const Pose& pose : poses) clear = clear && distance(pose.position(), p) > 2.4 + 1.6;
      if (clear) return p;
    }
  };
  for (int i = 0; i < 20; ++i) map.obstacles.push_back(random_ring(random, clear_place()));
  for (int i = 0; i < 500; ++i) map.points.push_back(clear_place());
  const auto begin = std::chrono::steady_clock::now();
  const double least = oracle_path_clearance(map, {}, {}, forklift(), path, 0.001);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_GT(least, 0.0);
  EXPECT_LT(seconds, 20.0);  // about a second optimised; generous for sanitizers
  RecordProperty("seconds", std::to_string(seconds));
}

}  // namespace
}  // namespace waywright
