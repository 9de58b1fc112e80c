#include "waywright/map/trace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "waywright/core/random.hpp"
#include "waywright/map/cell_pieces.hpp"
#include "waywright/map/distance_field.hpp"
#include "waywright/map/outward_outline.hpp"

namespace waywright {
namespace {

CellGrid grid_of(const std::vector<std::string>& picture, double cell = 1.0, bool bounds = false) {
  CellGrid grid;
  grid.name = "test";
  grid.columns = static_cast<int>(picture.front().size());
  grid.rows = static_cast<int>(picture.size());
  grid.cell = cell;
  grid.bounds = bounds;
  for (const std::string& row : picture) {
    for (const char c : row) grid.blocked.push_back(c == '#' ? 1 : c == '?' ? 2 : 0);
  }
  return grid;
}

/// Cells at random, in blots of several sizes, so that there are holes, thin walls and corners that touch.
CellGrid random_grid(std::uint64_t seed) {
  Random random{seed};
  CellGrid grid;
  grid.name = "random";
  grid.columns = static_cast<int>(random.integer(1, 40));
  grid.rows = static_cast<int>(random.integer(1, 40));
  grid.cell = 1.0;
  grid.bounds = random.integer(0, 1) == 1;
  const auto share = static_cast<double>(random.integer(1, 9)) / 10.0;
  const auto blot = static_cast<int>(random.integer(1, 4));
  grid.blocked.assign(static_cast<std::size_t>(grid.columns * grid.rows), 0);
  for (int row = 0; row < grid.rows; row += blot) {
    for (int column = 0; column < grid.columns; column += blot) {
      if (random.uniform(0.0, 1.0) >= share) continue;
      for (int r = row; r < std::min(grid.rows, row + blot); ++r) {
        for (int c = column; c < std::min(grid.columns, column + blot); ++c) grid.blocked[static_cast<std::size_t>(r * grid.columns + c)] = 1;
      }
    }
  }
  // And some cells over all of it, free or not.
  for (std::uint8_t& cell : grid.blocked) {
    if (random.uniform(0.0, 1.0) < 0.05) cell ^= 1;
  }
  return grid;
}

Ring ring_of(const std::vector<HalfCell>& outline) {
  Ring ring;
  for (const HalfCell p : outline) ring.push_back({0.5 * p.x, 0.5 * p.y});
  return ring;
}

bool is_simple(const Ring& ring) {
  const RingRepair repair = repair_ring(ring);
  return !repair.refused && repair.mended.empty();
}

/// Where a horizontal line is in a ring: pairs of x, from left to right.
std::vector<std::pair<double, double>> spans(const Ring& ring, double y) {
  std::vector<double> x;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y > y) == (b.y > y)) continue;
    x.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
  }
  std::sort(x.begin(), x.end());
  std::vector<std::pair<double, double>> pairs;
  for (std::size_t i = 0; i + 1 < x.size(); i += 2) pairs.emplace_back(x[i], x[i + 1]);
  return pairs;
}

/// m, from a point to the nearest blocked cell (or to what lies outside of a grid that bounds).
double distance_to_blocked(const CellGrid& grid, Vec2 p) {
  double least = 1e9;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      if (!grid.is_blocked(column, row)) continue;
      const double x = column * grid.cell, y = (grid.rows - 1 - row) * grid.cell;
      least = std::min(least, distance(p, {std::clamp(p.x, x, x + grid.cell), std::clamp(p.y, y, y + grid.cell)}));
    }
  }
  return least;
}

/// Along lines at several heights of each row, every blocked cell is in the rings from its left to its right side, and nothing of them is farther from blocked cells than `most` metres.
void expect_held(const CellGrid& grid, const std::vector<Ring>& rings, double most, bool look_at_distances) {
  constexpr double hair = 1e-9;
  for (int row = 0; row < grid.rows; ++row) {
    for (const double part : {0.01, 0.5, 0.99}) {
      const double y = (grid.rows - 1 - row + part) * grid.cell;
      std::vector<std::pair<double, double>> covered;
      for (const Ring& ring : rings) {
        const auto some = spans(ring, y);
        covered.insert(covered.end(), some.begin(), some.end());
      }
      std::sort(covered.begin(), covered.end());
      for (int column = 0; column < grid.columns; ++column) {
        if (!grid.is_blocked(column, row)) continue;
        double reached = column * grid.cell;
        for (const auto& [from, to] : covered) {
          if (from <= reached + hair) reached = std::max(reached, to);
        }
        ASSERT_GE(reached, (column + 1) * grid.cell - hair) << "cell " << column << ", " << row << " is not covered";
      }
      if (!look_at_distances) continue;
      for (const auto& [from, to] : covered) {
        for (const double t : {0.0, 0.2, 0.5, 0.8, 1.0}) ASSERT_LE(distance_to_blocked(grid, {from + t * (to - from), y}), most + hair);
      }
    }
  }
}

TEST(CellPieces, HoldEveryCellAndNothingElse) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    const CellGrid grid = random_grid(seed);
    const auto pieces = pieces_of(grid.columns, grid.rows, grid.blocked);
    std::int64_t cells = 0;
    std::vector<Ring> rings;
    for (const CellPiece& piece : pieces) {
      cells += piece.cells;
      rings.push_back(ring_of(piece.outline));
      ASSERT_TRUE(is_simple(rings.back()));
      // Bridges alone are more than the cells, a half of a quarter cell each side.
      const std::int64_t beyond = doubled_area(piece.outline) - 8 * piece.cells;
      ASSERT_GE(beyond, 0);
      ASSERT_EQ(beyond > 0, piece.is_bridged);
    }
    ASSERT_EQ(cells, std::count(grid.blocked.begin(), grid.blocked.end(), 1));
    expect_held(grid, rings, 0.25, true);
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        if (grid.is_blocked(column, row)) continue;
        const Vec2 middle{column + 0.5, grid.rows - 1 - row + 0.5};
        for (const Ring& ring : rings) {
          const Box box = bounding_box(ring);
          ASSERT_FALSE(box.contains(middle) && contains(ring, middle)) << "a free cell is inside";
        }
      }
    }
  }
}

TEST(CellPieces, RingsAreCutAndCornersBridged) {
  const auto count = [](const std::vector<std::string>& picture) {
    const CellGrid grid = grid_of(picture);
    return pieces_of(grid.columns, grid.rows, grid.blocked).size();
  };
  EXPECT_EQ(count({"###", "#.#", "###"}), 2U);
  EXPECT_EQ(count({"#..", ".#.", "..#"}), 1U);
  EXPECT_EQ(count({".#.", "#.#", ".#."}), 2U);  // closed by corners: taken apart left and right
  EXPECT_EQ(count({"#.#", "#.#"}), 2U);
  const CellGrid diagonal = grid_of({"..#", ".#.", "#.."});
  const auto pieces = pieces_of(3, 3, diagonal.blocked);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_TRUE(pieces[0].is_bridged);
  EXPECT_EQ(pieces[0].outline.size(), 16U);
  EXPECT_EQ(trace(diagonal, {1.0, {}, 0.0})->corners, 6U);  // straight along both sides
}

TEST(Trace, KeepsItsPromisesOnRandomCells) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const CellGrid grid = random_grid(1000 + seed);
    for (const double tolerance : {0.5, 1.0, 2.5}) {
      const TracedGrid traced = trace(grid, {tolerance, {}, 0.0}).value();
      ASSERT_LE(traced.reached, tolerance);
      ASSERT_EQ(traced.boundary.has_value(), grid.bounds);
      std::size_t corners = 0;
      double area = 0.0;
      for (const Ring& ring : traced.obstacles) {
        ASSERT_TRUE(is_simple(ring));
        corners += ring.size();
        area += signed_area(ring);
      }
      ASSERT_EQ(corners, traced.corners);
      ASSERT_LE(traced.corners, traced.outline_corners);
      ASSERT_NEAR(area, static_cast<double>(traced.covered) + traced.lost, 1e-6);
      expect_held(grid, traced.obstacles, tolerance, true);
    }
  }
}

TEST(Trace, ARelativeToleranceIsNeverMoreThanTheOther) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const CellGrid grid = random_grid(5000 + seed);
    const TracedGrid loose = trace(grid, {3.0, {}, 0.0}).value(), relative = trace(grid, {3.0, 0.02, 0.0}).value();
    ASSERT_LE(relative.reached, 3.0);
    ASSERT_GE(relative.corners, 3 * relative.obstacles.size());
    ASSERT_LE(relative.lost, loose.lost + 1e-9 + 0.5 * static_cast<double>(grid.blocked.size()));
    expect_held(grid, relative.obstacles, 3.0, true);
    // Small obstacles have a small tolerance: 2 % of their outline, or half a cell.
    for (const Ring& ring : relative.obstacles) {
      double length = 0.0;
      for (std::size_t i = 0; i < ring.size(); ++i) length += distance(ring[i], ring[(i + 1) % ring.size()]);
      if (length > 25.0) continue;
      for (const auto& p : ring) ASSERT_LE(distance_to_blocked(grid, p), 0.51);
    }
  }
}

TEST(Trace, ASlantedWallIsAFewCorners) {
  CellGrid grid;
  grid.columns = grid.rows = 200;
  grid.cell = 0.05;
  grid.bounds = false;
  grid.blocked.assign(40000, 0);
  for (int c = 0; c < 200; ++c) {
    const int r = 40 + c / 3;
    for (int k = 0; k < 3; ++k) grid.blocked[static_cast<std::size_t>((r + k) * 200 + c)] = 1;
  }
  const TracedGrid traced = trace(grid, {0.05, {}, 0.0}).value();
  EXPECT_EQ(traced.obstacles.size(), 1U);
  EXPECT_GT(traced.outline_corners, 250U);
  EXPECT_LE(traced.corners, 8U);
  EXPECT_LT(traced.lost, 0.6);  // m², of a wall 10 m long: a cell at most on either side
}

TEST(Trace, DilatesByAllCellsThatTheGrownObstacleTouches) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const CellGrid grid = random_grid(9000 + seed);
    for (const double by : {0.3, 1.0, 2.2}) {
      const CellGrid grown = dilated(grid, by);
      const int pad = (grown.columns - grid.columns) / 2;
      ASSERT_EQ(pad == 0, grid.bounds);
      for (int row = 0; row < grown.rows; ++row) {
        for (int column = 0; column < grown.columns; ++column) {
          // Least distance of the cell to a blocked one; outside of a grid that bounds is blocked.
          double least = 1e9;
          const int c = column - pad, r = row - pad;
          const auto apart = [](int d) { return static_cast<double>(std::max(0, std::abs(d) - 1)); };
          for (int br = -1; br <= grid.rows; ++br) {
            for (int bc = -1; bc <= grid.columns; ++bc) {
              const bool inside = bc >= 0 && br >= 0 && bc < grid.columns && br < grid.rows;
              if (inside ? !grid.is_blocked(bc, br) : !grid.bounds) continue;
              least = std::min(least, bc == c && br == r ? -1.0 : std::hypot(apart(bc - c), apart(br - r)));
            }
          }
          ASSERT_EQ(grown.is_blocked(column, row), least < by) << column << ", " << row << ": " << least;
        }
      }
      ASSERT_NEAR(distance(grown.corner(0, grown.rows), {-pad * 1.0, -pad * 1.0}), 0.0, 1e-12);
    }
  }
}

TEST(Trace, AGridThatIsTurnedLiesWhereItsCellsDo) {
  CellGrid grid = grid_of({"##..", "#...", "...#"}, 0.1, true);
  grid.origin = {3.0, -2.0, 0.6};
  const TracedGrid traced = trace(grid, {0.05, {}, 0.0}).value();
  ASSERT_TRUE(traced.boundary);
  EXPECT_NEAR(distance((*traced.boundary)[2], grid.corner(4, 0)), 0.0, 1e-12);
  ASSERT_EQ(traced.obstacles.size(), 2U);
  double area = 0.0;
  for (const Ring& ring : traced.obstacles) area += signed_area(ring);
  EXPECT_NEAR(area, 0.04, 1e-3 + traced.lost);
  EXPECT_EQ(traced.blocked, 4);
}

TEST(Trace, WhatCannotBeDoneIsRefused) {
  const CellGrid grid = grid_of({"#."}, 0.1);
  EXPECT_TRUE(trace(grid, {0.05, {}, 0.0}));
  const auto fine = trace(grid, {0.049, {}, 0.0});
  ASSERT_FALSE(fine);
  EXPECT_EQ(fine.error().problem, "0.049 m is under half a cell, with which no slanted wall gets shorter");
  EXPECT_FALSE(trace(grid, {0.05, {}, 1e3}));
  EXPECT_FALSE(trace(grid, {std::nan(""), {}, 0.0}));
  const TracedGrid nothing = trace(grid_of({"..", ".."}, 0.1, true), {0.05, {}, 0.0}).value();
  EXPECT_TRUE(nothing.obstacles.empty());
}

}  // namespace
}  // namespace waywright
