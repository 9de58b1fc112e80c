#include "waywright/map/distance_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "waywright/core/random.hpp"

namespace waywright {
namespace {

using Blocked = std::vector<std::uint8_t>;

Blocked random_cells(int columns, int rows, double share, Random& random) {
  Blocked blocked(static_cast<std::size_t>(columns * rows));
  for (std::uint8_t& b : blocked) b = random.uniform() < share ? 1 : 0;
  return blocked;
}

std::int32_t nearest_by_looking(int columns, int rows, const Blocked& blocked, bool is_bounded, int c, int r) {
  std::int32_t best = DistanceField::nowhere;
  for (int y = -1; y <= rows; ++y) {
    for (int x = -1; x <= columns; ++x) {
      const bool outside = x < 0 || y < 0 || x == columns || y == rows;
      if (outside ? !is_bounded : blocked[static_cast<std::size_t>(y * columns + x)] == 0) continue;
      best = std::min(best, (x - c) * (x - c) + (y - r) * (y - r));
    }
  }
  return best;
}

// Widths on both sides of the blocks that are searched together, shares that take each of the two ways through a row.
TEST(DistanceField, IsWhatLookingAtEveryPairOfCellsGives) {
  Random random{11};
  for (int i = 0; i < 300; ++i) {
    const int columns = static_cast<int>(random.integer(1, i % 3 == 0 ? 200 : 70));
    const int rows = static_cast<int>(random.integer(1, 30));
    const double share = i % 4 == 0 ? 0.3 : i % 4 == 1 ? 0.02 : i % 4 == 2 ? 0.001 : 0.0005;
    const Blocked blocked = random_cells(columns, rows, share, random);
    const bool is_bounded = i % 5 == 0;
    const DistanceField field{columns, rows, blocked, is_bounded};
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c < columns; ++c) {
        ASSERT_EQ(field.squared(c, r), nearest_by_looking(columns, rows, blocked, is_bounded, c, r)) << columns << " x " << rows << " at " << c << ", " << r << ", map " << i;
        const auto nearest = field.nearest(c, r);
        ASSERT_EQ(nearest.has_value(), field.squared(c, r) != DistanceField::nowhere);
        if (!nearest) continue;
        const auto [x, y] = *nearest;
        ASSERT_EQ((x - c) * (x - c) + (y - r) * (y - r), field.squared(c, r));
        const bool outside = x < 0 || y < 0 || x >= columns || y >= rows;
        ASSERT_TRUE(outside ? is_bounded : blocked[static_cast<std::size_t>(y * columns + x)] != 0);
      }
    }
  }
}

// Rows that need the stack, rows that need the search, and the change from one to the other within one grid.
TEST(DistanceField, TurnsOverAndTransposesWithTheGrid) {
  Random random{5};
  for (const double share : {0.2, 0.001, 0.00005}) {
    const int columns = 331, rows = 257;
    Blocked blocked = random_cells(columns, rows, share, random);
    for (int r = 100; r < 130; ++r) {
      for (int c = 40; c < 90; ++c) blocked[static_cast<std::size_t>(r * columns + c)] = random.uniform() < 0.5 ? 1 : 0;
    }
    Blocked across(blocked.size()), over(blocked.size());
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c < columns; ++c) {
        const std::uint8_t b = blocked[static_cast<std::size_t>(r * columns + c)];
        across[static_cast<std::size_t>(c * rows + r)] = b;
        over[static_cast<std::size_t>((rows - 1 - r) * columns + columns - 1 - c)] = b;
      }
    }
    const DistanceField field{columns, rows, blocked, false}, transposed{rows, columns, across, false}, turned{columns, rows, over, false};
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c < columns; ++c) {
        ASSERT_EQ(field.squared(c, r), transposed.squared(r, c));
        ASSERT_EQ(field.squared(c, r), turned.squared(columns - 1 - c, rows - 1 - r));
      }
    }
  }
}

TEST(DistanceField, TakesNewGridsIntoItsMemoryAndTheLongestSides) {
  DistanceField field;
  Blocked line(DistanceField::longest_side);
  line[0] = 1;
  field.assign(DistanceField::longest_side, 1, line, false);
  EXPECT_EQ(field.squared(DistanceField::longest_side - 1, 0), (DistanceField::longest_side - 1) * (DistanceField::longest_side - 1));
  field.assign(1, DistanceField::longest_side, line, false);
  EXPECT_EQ(field.squared(0, DistanceField::longest_side - 1), (DistanceField::longest_side - 1) * (DistanceField::longest_side - 1));
  field.assign(2, 2, Blocked{0, 0, 0, 0}, false);
  EXPECT_EQ(field.values(), std::vector<std::int32_t>(4, DistanceField::nowhere));
  field.assign(2, 2, Blocked{0, 0, 0, 0}, true);
  EXPECT_EQ(field.values(), std::vector<std::int32_t>(4, 1));
}

}  // namespace
}  // namespace waywright
