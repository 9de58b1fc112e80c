// Regions with and without a free place, by hand and against a search at points.
#include "waywright/scenario/blocked_region.hpp"

#include <gtest/gtest.h>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

World world_of(Map map) {
  World world{map};
  world.build();
  return world;
}

Map hall() {
  Map map;
  map.boundaries = {rectangle({0, 0}, {10, 8})};
  map.obstacles = {rectangle({4, 2}, {6, 5}), rectangle({6, 2}, {8, 5})};
  return map;
}

TEST(BlockedRegion, SaysWhatBlocksAllOfIt) {
  const World world = world_of(hall());
  const auto inside = blocked_region(world, rectangle({4.5, 2.5}, {5.5, 3.5}), 0.3, 0.05);
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->status, Status::goal_in_collision);
  EXPECT_EQ(inside->reason, "no place in the goal's region is free: obstacle 0 blocks all of it, even for the largest disc in the footprint, 0.300 m, with the 0.0500 m that are required "
                            "(clearance and pose error)");
  const auto both = blocked_region(world, rectangle({5, 3}, {7, 4}), 0.0, 0.01);
  ASSERT_TRUE(both);
  EXPECT_NE(both->reason.find("obstacle 0 and obstacle 1 block all of it"), std::string::npos) << both->reason;
  const auto outside = blocked_region(world, rectangle({12, 1}, {14, 3}), 0.3, 0.0);
  ASSERT_TRUE(outside);
  EXPECT_EQ(outside->status, Status::goal_outside);
  EXPECT_EQ(outside->reason, "the goal's region lies outside of the boundary");
}

TEST(BlockedRegion, IsSilentWhereAPlaceIsFree) {
  const World world = world_of(hall());
  EXPECT_FALSE(blocked_region(world, rectangle({3, 3}, {5, 4}), 0.3, 0.05));
  EXPECT_FALSE(blocked_region(world, rectangle({3.6, 3}, {5, 4}), 0.3, 0.05));  // as far as it has to be at its left edge
  EXPECT_TRUE(blocked_region(world, rectangle({3.7, 3}, {5, 4}), 0.3, 0.05));
  EXPECT_FALSE(blocked_region(World{}, rectangle({3, 3}, {5, 4}), 0.3, 0.05));
}

/// What is said to be blocked has no free place among many that are looked at.
TEST(BlockedRegion, NeverCallsAFreePlaceBlocked) {
  Random random{7};
  int blocked = 0;
  for (int i = 0; i < 300; ++i) {
    Map map = hall();
    for (int k = 0; k < 12; ++k) {
      const Vec2 low{random.uniform(0.0, 9.0), random.uniform(0.0, 7.0)};
      map.obstacles.push_back(rectangle(low, low + Vec2{random.uniform(0.2, 2.5), random.uniform(0.2, 2.5)}));
    }
    const World world = world_of(map);
    const Vec2 low{random.uniform(0.0, 9.0), random.uniform(0.0, 7.0)};
    const Vec2 size{random.uniform(0.05, 2.0), random.uniform(0.05, 2.0)};
    const double radius = random.uniform(0.0, 0.5);
    if (!blocked_region(world, rectangle(low, low + size), radius, 0.05)) continue;
    ++blocked;
    for (int k = 0; k <= 20; ++k) {
      for (int l = 0; l <= 20; ++l) {
        const Pose there{low.x + size.x * k / 20.0, low.y + size.y * l / 20.0, 0.0};
        EXPECT_LT(world.clearance(Footprint{{}, radius}, there, 1.0).clearance, 0.05);
      }
    }
  }
  EXPECT_GT(blocked, 50);
}

}  // namespace
}  // namespace waywright
