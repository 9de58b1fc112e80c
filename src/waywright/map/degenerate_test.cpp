// Worlds of touching, flat, tiny and huge things: answers are numbers, and the field never says more than the distance.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "waywright/core/random.hpp"
#include "waywright/map/clearance_field.hpp"

namespace waywright {
namespace {

/// Squares edge to edge, walls on their edges, points on their corners, a wall of no length, cells that touch.
Map touching(double size, Vec2 origin) {
  Map map;
  const auto at = [&](double x, double y) { return origin + size * Vec2{x, y}; };
  map.boundaries = {{at(-4, -4), at(5, -4), at(5, 5), at(-4, 5)}};
  for (int i = 0; i < 3; ++i) map.obstacles.push_back(rectangle(at(i, 0), at(i + 1, 1)));
  map.obstacles.push_back({at(0, 1), at(3, 1), at(3, 1.0000001)});  // a sliver on top of them
  map.lines = {{at(0, 0), at(3, 0), at(3, 1)}, {at(2, 3), at(2, 3)}, {at(-1, 3), at(0, 3), at(-1, 3)}};
  map.points = {at(0, 0), at(0, 0), at(3, 1), at(2, 3)};
  map.grids.push_back({"cells", 3, 2, 0.5 * size, make_pose(at(-3, -3), 0.3), {1, 0, 1, 0, 1, 0}, false});
  return map;
}

TEST(DegenerateWorld, ClearancesAreNumbersAndFieldsKeepUnderThem) {
  Random random{5};
  struct Place {
    double size;
    Vec2 origin;
  };
  for (const auto& [size, origin] : {Place{1.0, {}}, Place{1e-9, {}}, Place{2e5, {}}, Place{1.0, {1e6 - 5.0, 5.0 - 1e6}}}) {
    World world{touching(size, origin)};
    world.build();
    const Box region{origin + size * Vec2{-4, -4}, origin + size * Vec2{5, 5}};
    const ClearanceField field{world, region, {.sharp = size, .cap = 2.0 * size, .most_cells = 20'000}};
    for (int i = 0; i < 2000; ++i) {
      const Vec2 p = origin + size * Vec2{random.uniform(-5, 6), random.uniform(-5, 6)};
      Footprint point;
      const double clearance = world.clearance(point, make_pose(p, 0.0), 100.0 * size).clearance;
      ASSERT_TRUE(std::isfinite(clearance) && clearance >= 0.0);
      ASSERT_LE(field.at(p), clearance);
      Footprint sliver;
      sliver.polygon = {{-size, 0.0}, {size, 0.0}, {0.0, 1e-9 * size}};
      const Pose pose = make_pose(p, random.uniform(-pi, pi));
      const double of_sliver = world.clearance(sliver, pose, 100.0 * size).clearance;
      ASSERT_TRUE(of_sliver >= 0.0 && of_sliver <= clearance + size);
      ASSERT_EQ(world.is_free(sliver, pose, 0.0), of_sliver > 0.0);
    }
  }
}

TEST(DegenerateWorld, TouchingIsNoClearance) {
  World world{touching(1.0, {})};
  world.build();
  Footprint square;
  square.polygon = rectangle({-0.5, -0.5}, {0.5, 0.5});
  EXPECT_EQ(world.clearance(square, {-0.5, 0.5, 0.0}, 10.0).clearance, 0.0) << "side on side";
  EXPECT_EQ(world.clearance(square, {-0.5, -0.5, 0.0}, 10.0).clearance, 0.0) << "corner on corner";
  EXPECT_EQ(world.clearance(square, {2.0, 2.5, 0.0}, 10.0).clearance, 0.0) << "side on a scan point";
  EXPECT_EQ(world.clearance(square, {-3.5, 4.5, 0.0}, 10.0).clearance, 0.0) << "side on the boundary";
}

}  // namespace
}  // namespace waywright
