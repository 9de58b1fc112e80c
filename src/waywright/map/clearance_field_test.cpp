#include "waywright/map/clearance_field.hpp"

#include <gtest/gtest.h>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

Map mixed_map(double shift) {
  const auto moved = [shift](Ring ring) {
    for (Vec2& p : ring) p = p + Vec2{shift, -shift};
    return ring;
  };
  Map map;
  map.boundaries = {moved({{0, 0}, {12, 0}, {12, 9}, {6, 9.5}, {0, 9}})};
  map.obstacles = {moved({{3, 3}, {4, 3}, {4, 4.5}}), moved({{7, 1}, {9, 1.5}, {8, 3}, {7.5, 2}})};
  map.lines = {moved({{1, 7}, {2, 8}, {3, 7.5}})};
  map.points = moved({{10, 7}, {10.1, 7.05}, {5.5, 6.0}});
  CellGrid grid;
  grid.name = "overlay";
  grid.columns = 3;
  grid.rows = 2;
  grid.cell = 0.4;
  grid.origin = make_pose(Vec2{9.0 + shift, 4.0 - shift}, 0.3);
  grid.blocked = {1, 0, 1, 0, 1, 0};
  grid.bounds = false;
  map.grids = {grid};
  return map;
}

// Far from the origin too: what is tabled is relative to the region's corner.
TEST(ClearanceField, IsNeverAboveTheDistanceAndLittleUnderIt) {
  for (const double shift : {0.0, 123456.0}) {
    World world{mixed_map(shift)};
    world.build();
    const Box region{Vec2{-1, -1} + Vec2{shift, -shift}, Vec2{13, 11} + Vec2{shift, -shift}};
    const ClearanceField field{world, region, {.cell = 0.05, .sharp = 0.8, .cap = 1.5}};
    Random random{3};
    int outside = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec2 p = Vec2{random.uniform(-1, 13), random.uniform(-1, 11)} + Vec2{shift, -shift};
      const double table = static_cast<double>(field.at(p));
      const double exact = world.clearance({&p, 1}, 0.0, 2.0).clearance;
      ASSERT_GE(table, 0.0);
      ASSERT_LE(table, exact + 1e-12);
      ASSERT_GE(table, std::min(exact, 0.8) - field.slack());
      ASSERT_GE(table, std::min(exact, 1.5) - 0.7);
      if (exact == 0.0) ++outside;
    }
    EXPECT_GT(outside, 1000);
  }
}

TEST(ClearanceField, KnowsNothingOutsideItsRegion) {
  World world{mixed_map(0.0)};
  world.build();
  const ClearanceField field{world, {{2, 2}, {5, 5}}, {}};
  EXPECT_LT(field.at({1.9, 3}), 0.0F);
  EXPECT_LT(field.at({3, 5.5}), 0.0F);
  EXPECT_LT(field.at({1e12, 3}), 0.0F);
  EXPECT_LT(field.at({std::numeric_limits<double>::quiet_NaN(), 3}), 0.0F);
  EXPECT_GE(field.at({2.5, 2.5}), 0.0F);
}

TEST(ClearanceField, TakesACoarserCellForALargeRegion) {
  World world{mixed_map(0.0)};
  world.build();
  const ClearanceField field{world, {{-500, -500}, {500, 500}}, {.most_cells = 10000}};
  EXPECT_LE(field.values().size(), 10000U);
  EXPECT_GT(field.cell(), 5.0);
}

}  // namespace
}  // namespace waywright
