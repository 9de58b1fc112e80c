#include "waywright/planner/grid/lanes/kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

using move_lanes::Arrivals;
using move_lanes::From;
using move_lanes::Kernels;
using move_lanes::Lattice;

constexpr std::array<std::array<int, 2>, move_lanes::moves> knights{
    {{1, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 1}, {-1, 2}, {-1, 1}, {-2, 1}, {-1, 0}, {-2, -1}, {-1, -1}, {-1, -2}, {0, -1}, {1, -2}, {1, -1}, {2, -1}}};

// Against sums of 64 bits, one move after the other, on grids of all shapes; memory ends where a kernel may read no further.
TEST(MoveLanes, EveryInstructionSetTellsWhatPlainSumsTell) {
  Random random{4};
  std::int64_t better = 0, worse = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const auto columns = static_cast<std::ptrdiff_t>(random.integer(1, 12)), rows = static_cast<std::ptrdiff_t>(random.integer(1, 12));
    const std::ptrdiff_t before = Lattice::before(columns), cells = columns * rows;
    const auto all = static_cast<std::size_t>(before + cells + Lattice::after(columns));
    std::vector<std::uint32_t> keys(all);
    std::vector<std::uint16_t> danger(all);
    const std::uint32_t least_key = 40'000;
    const bool is_late = random.uniform() < 0.3;  // numbers at the upper end of what there is
    for (std::uint32_t& k : keys) k = random.uniform() < 0.3 ? 0xFFFFFFFFU : static_cast<std::uint32_t>(random.integer(least_key, least_key + 400'000)) + (is_late ? 0xFFF00000U : 0U);
    for (std::uint16_t& d : danger) d = static_cast<std::uint16_t>(random.uniform() < 0.1 ? 65535 : random.integer(0, 600));
    Lattice lattice;
    for (std::size_t i = 0; i < knights.size(); ++i) {
      lattice.column[i] = knights[i][0];
      lattice.row[i] = knights[i][1];
      const int steps = std::abs(knights[i][0]) + std::abs(knights[i][1]);
      lattice.weight[i] = steps == 1 ? 13691 : steps == 2 ? 19362 : 30614;
    }
    lattice.width = columns;
    lattice.danger = random.uniform() < 0.7 ? danger.data() + before : nullptr;
    lattice.most[0] = 13691;
    lattice.least[0] = 3232;
    lattice.most[1] = 11252;
    lattice.least[1] = 8110;
    lattice.less = static_cast<std::uint32_t>(random.integer(0, 60'000));
    const auto cell = static_cast<std::ptrdiff_t>(random.integer(0, cells - 1));
    From from{keys.data() + before + cell, cell, static_cast<std::uint32_t>(random.integer(0, 200'000)), is_late ? 0xFFF00000U : 20'000U,
              static_cast<std::int32_t>(random.integer(-2000, 2000)), static_cast<std::int32_t>(random.integer(-2000, 2000)), 0};
    for (std::uint32_t i = 0; i < 16; ++i) {  // into the grid alone
      const std::ptrdiff_t c = cell % columns + lattice.column[i], r = cell / columns + lattice.row[i];
      if (c >= 0 && r >= 0 && c < columns && r < rows && random.uniform() < 0.8) from.free |= 1U << i;
    }
    for (const Kernels& kernels : move_lanes::available()) {
      Arrivals arrivals;
      const std::uint32_t mask = kernels.leave(lattice, from, arrivals);
      EXPECT_EQ(mask & ~from.free, 0U) << kernels.name;
      for (std::size_t i = 0; i < knights.size(); ++i) {
        if ((from.free >> i & 1) == 0) continue;
        const std::ptrdiff_t there = cell + lattice.row[i] * columns + lattice.column[i];
        std::uint64_t cost = lattice.weight[i];
        if (lattice.danger != nullptr) cost += cost * (static_cast<std::uint64_t>(lattice.danger[cell]) + lattice.danger[there]) >> 9;
        cost += from.cost;
        if (cost + from.base > 0xFFFFFFFFU) continue;  // the caller's promise
        const bool is_better = cost + from.base < keys[static_cast<std::size_t>(before + there)];
        ASSERT_EQ((mask >> i & 1) == 1, is_better) << kernels.name << " move " << i;
        (is_better ? better : worse)++;
        if (!is_better) continue;
        const std::int64_t x = std::abs(from.column + lattice.column[i]), y = std::abs(from.row + lattice.row[i]), most = std::max(x, y), least = std::min(x, y);
        const std::int64_t way = 2 * least <= most ? (most - 2 * least) * 13691 + least * 30614 : (most - least) * 30614 + (2 * least - most) * 19362;
        ASSERT_EQ(arrivals.cost[i], cost) << kernels.name;
        ASSERT_EQ(arrivals.bound[i], cost + static_cast<std::uint64_t>(std::max<std::int64_t>(0, way - lattice.less))) << kernels.name << " move " << i;
      }
    }
  }
  EXPECT_GT(better, 10'000);
  EXPECT_GT(worse, 10'000);
}

}  // namespace
}  // namespace waywright
