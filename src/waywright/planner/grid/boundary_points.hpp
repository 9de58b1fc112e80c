// Boundary points of the safe-A* publication: from corner to corner of what stands between a place and the goal, until a straight line leads there.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "waywright/planner/grid/cell_danger.hpp"
#include "waywright/planner/grid/cell_obstacles.hpp"

namespace waywright {

struct BoundaryTask {
  const CellMap& cells;
  const CellObstacles& obstacles;  ///< of its occupied cells
  const CellDanger& danger;
  Vec2 start{}, goal{};            ///< cells
  /// May the way leave the grid here for the goal? Asked of cells that are free and without danger.
  std::function<bool(Cell)> sees_goal;
  bool start_has_to_see = false;   ///< a start with no obstacle on its line has to be asked, too
  std::function<bool()> is_over;   ///< ends the construction; may be empty
};

struct BoundaryAnswer {
  enum class Kind {
    straight,  ///< nothing stands between start and goal
    joined,    ///< from `last` the goal is seen
    none,      ///< no corner is left, or no cell near the last one sees the goal: `why`
  } kind = Kind::none;
  std::vector<Vec2> corners;  ///< of obstacles, in the order in which they were taken; cells
  std::vector<Vec2> shifted;  ///< each moved away from obstacles
  Cell last{};                ///< D′
  std::string why;
};

/// Algorithm 2, corrected: the first obstacle on the line; of its corners the one nearest to where the line meets it, not taken yet and not within R₁ of the map's
/// border; moved away from obstacles until all are R₁ away; and again from there.
BoundaryAnswer boundary_points(const BoundaryTask& task);

/// Moves a place away from blocked cells within R₁, in steps of at most R₁/6, until none is nearer or 40 steps are done. (Formula (10) corrected: the shift is R₁ less the distance,
/// a length; the published one has the unit 1/m.) `outwards`: where to first from the middle of a blocked cell.
Vec2 shifted_away(Vec2 at, Vec2 outwards, const CellMap& cells, double reach);

/// The first blocked cell on a line, looked at every quarter of a cell; where its middle is, and how far along. Empty: none.
struct Crossing {
  Vec2 at{};
  Cell cell{};
};
std::optional<Crossing> first_crossing(const CellMap& cells, Vec2 from, Vec2 to);

}  // namespace waywright
