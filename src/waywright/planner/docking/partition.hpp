// The free polygons beside the shelf, where the vehicle may change its direction (docking publication, Algorithm 1).
#pragma once

#include <string>
#include <vector>

#include "waywright/scenario/problem.hpp"

namespace waywright {

enum class Side { left = 1, right = -1 };  ///< of the shelf, seen along its heading (+y and −y in its frame)

const char* to_string(Side side);

/// One side of the shelf, in the shelf's frame (origin in the middle of the loading face, +x out of the shelf).
struct TransitionZone {
  Side side = Side::left;
  const char* of = "shelf";    ///< what it lies beside, for sentences: "shelf" or "goal"
  std::vector<Ring> polygons;  ///< where the transition point may lie; empty where the side is left out
  double width = 0.0;          ///< m, greatest least width of the side's polygons
  double needed = 0.0;         ///< m, the footprint's least width plus twice the clearance
  bool left_out() const { return polygons.empty(); }
};

/// What docking is about, in the shelf's frame: works for a station, and for any goal pose (a shelf of no width).
struct DockingTask {
  Frame frame;         ///< shelf frame → world
  Pose start, dock;    ///< in the shelf's frame; dock heading is π
  Vec2 dock_heading{-1.0, 0.0};  ///< the same as a unit vector
  std::vector<TransitionZone> zones;  ///< left, then right
};

/// Clips the station (or, without one, the surroundings of start and goal) beside the shelf. A polygon is left out only where
/// `needed` does not fit into it: a convex hull less wide than that holds no placement of the footprint with its clearance.
DockingTask partition(const Problem& problem);

/// The published rule: a side is dropped where its extent across is under `least_extent`.
std::vector<Ring> clip_beside(const Ring& area, double shelf_right, double shelf_left, Side side);

}  // namespace waywright
