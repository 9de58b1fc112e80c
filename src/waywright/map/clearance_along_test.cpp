#include "waywright/map/clearance_along.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

Map cluttered(Random& random) {
  Map map;
  map.boundaries = {rectangle({-10, -8}, {10, 8})};
  for (int i = 0; i < 40; ++i) {
    const Pose at{random.uniform(-9, 9), random.uniform(-7, 7), random.uniform(-pi, pi)};
    map.obstacles.push_back(transformed(rectangle({-random.uniform(0.05, 0.5), -0.2}, {random.uniform(0.05, 0.5), 0.3}), Frame{at}));
  }
  map.lines = {{{-9, -7}, {-8, -6}, {-8, -5}}};
  for (int i = 0; i < 20; ++i) map.points.push_back({random.uniform(-9, 9), random.uniform(-7, 7)});
  return map;
}

/// Steps of all lengths, out of the hall and into obstacles too.
std::vector<Pose> wandering(Random& random, int count) {
  std::vector<Pose> poses{{0, 0, 0}};
  while (static_cast<int>(poses.size()) < count) {
    const double step = std::pow(10.0, random.uniform(-3, random.integer(0, 9) == 0 ? 1.0 : -0.3));
    const Pose& last = poses.back();
    Pose next = make_pose(last.position() + step * unit(random.uniform(-pi, pi)), wrap(last.heading + random.uniform(-1, 1) * step));
    if (std::abs(next.x) > 12 || std::abs(next.y) > 10) next = {0, 0, next.heading};
    poses.push_back(next);
    if (random.integer(0, 19) == 0) poses.push_back(next);
  }
  return poses;
}

TEST(ClearanceAlong, IsTheClearanceOfEachPoseWhateverCameBefore) {
  Random random{1};
  int contacts = 0;
  for (int round = 0; round < 20; ++round) {
    World world{cluttered(random)};
    world.build();
    Footprint footprint;
    if (round % 3 == 0) footprint.disc = 0.3;
    if (round % 3 == 1) footprint.polygon = {{-0.9, -0.275}, {0.9, -0.275}, {0.9, 0.275}, {-0.9, 0.275}};
    if (round % 3 == 2) footprint.polygon = {{-0.4, -0.4}, {0.3, -0.4}, {0.3, -0.3}, {1.0, -0.3}, {1.0, -0.2}, {0.3, -0.2}, {0.3, 0.4}, {-0.4, 0.4}};
    const double cap = random.uniform(0.2, 4.0);
    const std::vector<Pose> poses = wandering(random, 300);
    std::vector<double> all;
    ClearanceAlong{world, footprint, cap}.at(poses, all);
    ASSERT_EQ(all.size(), poses.size());
    ClearanceAlong one_by_one{world, footprint, cap};
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const double truth = std::min(cap, world.clearance(footprint, poses[i], cap).clearance);
      EXPECT_NEAR(all[i], truth, 1e-12);
      EXPECT_EQ(one_by_one.at(poses[i]), all[i]);
      EXPECT_NEAR(std::min(cap, world.least_clearance(footprint, poses[i], cap)), truth, 1e-15);
      contacts += truth == 0.0;
    }
  }
  EXPECT_GT(contacts, 300);
}

TEST(RingBins, HaveEveryRingThatAPointCanBeIn) {
  Random random{2};
  for (int round = 0; round < 60; ++round) {
    // Small ones, and some that cover much: those would be in every bin.
    std::vector<Box> boxes;
    const auto count = random.integer(0, 200);
    for (int i = 0; i < count; ++i) {
      const Vec2 low{random.uniform(-5, 5), random.uniform(-5, 5)};
      const double size = round % 3 == 0 ? 0.0 : round % 3 == 1 ? 0.5 : 20.0;
      boxes.push_back({low, low + Vec2{random.uniform(0, size), random.uniform(0, size)}});
    }
    const RingBins bins{boxes};
    for (int i = 0; i < 300; ++i) {
      const Vec2 p = i % 10 == 0 && count > 0 ? boxes[static_cast<std::size_t>(i) % boxes.size()].high : Vec2{random.uniform(-7, 7), random.uniform(-7, 7)};
      const auto near = bins.near(p);
      EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
      for (std::uint32_t k = 0; k < boxes.size(); ++k) {
        if (boxes[k].contains(p)) {
          EXPECT_TRUE(std::binary_search(near.begin(), near.end(), k));
        }
      }
    }
  }
}

/// Where one of a grid's edges ends another begins: only so need ends not be looked at twice.
TEST(World, GridsEdgesFollowOneAnother) {
  Random random{3};
  for (int round = 0; round < 30; ++round) {
    CellGrid grid;
    grid.columns = static_cast<int>(random.integer(1, 12));
    grid.rows = static_cast<int>(random.integer(1, 12));
    grid.cell = 0.25;
    grid.origin = {0.5, -0.25, round % 2 == 0 ? 0.0 : 0.5 * pi};
    grid.bounds = round % 3 == 0;
    for (int i = 0; i < grid.columns * grid.rows; ++i) grid.blocked.push_back(random.integer(0, 2) == 0 ? 1 : 0);
    Map map;
    map.grids = {grid};
    World world{map};
    world.build();
    for (const Segment& s : world.index().segments()) {
      EXPECT_TRUE(s.end_begins_another);
      EXPECT_TRUE(std::any_of(world.index().segments().begin(), world.index().segments().end(), [&](const Segment& t) { return t.a == s.b; }));
    }
  }
}

}  // namespace
}  // namespace waywright
