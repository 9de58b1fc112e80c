// What a vehicle drives from a state of the lattice: the moves of the search.
#pragma once

#include <array>
#include <vector>

#include "waywright/planner/state_lattice/danger_cost.hpp"

namespace waywright {

/// Headings of a lattice are directions to its cells: 0, atan ½, 45°, atan 2, 90° and so on.
inline constexpr int lattice_headings = 16;
/// Columns along x, rows along y.
struct LatticeStep {
  int column = 0, row = 0;
  friend bool operator==(LatticeStep, LatticeStep) = default;
};
inline constexpr std::array<LatticeStep, lattice_headings> lattice_steps{
    {{1, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 1}, {-1, 2}, {-1, 1}, {-2, 1}, {-1, 0}, {-2, -1}, {-1, -1}, {-1, -2}, {0, -1}, {1, -2}, {1, -1}, {2, -1}}};
double lattice_heading(int heading);  ///< rad
constexpr int other_way(int heading) { return (heading + lattice_headings / 2) % lattice_headings; }

/// From a heading, curvature 0, to another, curvature 0.
struct MotionPrimitive {
  LatticeStretch stretch;  ///< from (0, 0), in the lattice's frame
  LatticeStep step{};
  int to = 0;              ///< heading of the vehicle
  double metres = 0.0;     ///< what it costs where nothing is near
  double length = 0.0;     ///< m
  Vec2 middle{};           ///< m, in world axes
  double reach = 0.0;      ///< m, no origin on the way is farther from there
  /// Some of the poses, in world axes, without the ends; `way` from the one before, m.
  struct Place {
    Vec2 offset{};
    double way = 0.0;
  };
  std::vector<Place> between;
  double last_way = 0.0;      ///< m, from the last of them to the end
  std::vector<CostedPose> poses;
};

struct PrimitiveOptions {
  double cell = 0.2;          ///< m
  BendLimits limits;
  bool may_turn = false;      ///< on the spot
  bool may_forward = true, may_reverse = true;
  double longest = 0.0;       ///< m: a longer one would not fit the lattice
  double turn_frame = 0.0;    ///< rad, the lattice's heading in the world
};

/// For each heading of the vehicle: straight on by one step; a shift to the lattice line beside; turns by one to four headings, to both sides, each the shortest whose
/// bend is within the limits; the same backwards; turns on the spot by one heading.
using MotionPrimitives = std::array<std::vector<MotionPrimitive>, lattice_headings>;
MotionPrimitives motion_primitives(const PrimitiveOptions& options, const MotionCost& cost);

}  // namespace waywright
