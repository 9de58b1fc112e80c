// The straight line from start to goal and what has to be gone around: the method that the safe-A* publication compares itself with (its reference 17).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "waywright/planner/grid/cell_obstacles.hpp"

namespace waywright {

/// A stretch of the line that is searched instead. Ends are along the line, cells from its start.
struct Detour {
  double begin = 0.0, end = 0.0;
};

/// Every stretch of blocked cells on the line, with `around` cells before and after, moved on until both ends are on free cells; overlapping ones as one. The
/// straight parts between the middles of the cells at their ends, asked of `is_free`, are free: where one is not, it joins its neighbours. Empty: the line is free.
std::vector<Detour> detours_of(const CellMap& cells, Vec2 start, Vec2 goal, double around, const std::function<bool(Vec2, Vec2)>& is_free);

/// Makes a detour that leads nowhere longer: with the next one, to the line's end, with the one before, from its beginning. Returns which one it is then; nothing where it was the
/// whole line already.
std::optional<std::size_t> widened(std::vector<Detour>& detours, std::size_t i, double whole);

/// The cell on the line at this distance from the start.
Cell cell_on(Vec2 start, Vec2 goal, double along);

}  // namespace waywright
